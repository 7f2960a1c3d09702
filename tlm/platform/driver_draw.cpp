// How the driver lays a draw out in memory and programs the device for it.

#include "tlm/platform/driver.h"
#include "tlm/platform/frame_registers.h"
#include "tlm/records.h"

namespace repousse::shell {
namespace {

// Buffers start on cache lines.
constexpr uint64_t kAlignment = 64;

uint64_t aligned(uint64_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

template <class T>
uint64_t bytes_of(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

uint64_t base_bytes(const AdaptiveDraw<Fixed>& draw) { return bytes_of(draw.triangles); }
uint64_t base_bytes(const SweepDraw<Fixed>& draw) {
    return draw.triangles.size() * sizeof(SweepRecord) + kAlignment + bytes_of(draw.z_table);
}

uint64_t output_bytes(const AdaptiveDraw<Fixed>&, uint32_t capacity) {
    return aligned(capacity * sizeof(OutputRecord));
}
uint64_t output_bytes(const SweepDraw<Fixed>&, uint32_t capacity) {
    return aligned(capacity * sizeof(FineTriangleRecord)) + aligned(capacity * sizeof(FineRecord));
}

template <class Records, class Items>
Records records_of(const Items& items) {
    Records records;
    records.reserve(items.size());
    for (const auto& item : items) records.push_back(record_of(item));
    return records;
}

uint32_t bit(bool set, Feature feature) { return set ? uint32_t(feature) : 0; }

uint32_t map_features(const MapView<Fixed>& map) {
    return bit(map.wrap, kWrap) | bit(map.filter == HeightFilter::Bilinear, kBilinear) |
           bit(map.filter == HeightFilter::Maximum, kMaximum) |
           bit(map.filter == HeightFilter::Average, kAverage) | bit(map.has_minima, kMinima);
}

uint32_t features(const AdaptiveDraw<Fixed>& draw) {
    const AdaptiveRegisters<Fixed>& r = draw.registers;
    return bit(r.use_view_test, kUseViewTest) | bit(r.use_normal_test, kUseNormalTest) |
           bit(r.use_height_test, kUseHeightTest) | bit(r.use_bump, kUseBump) |
           bit(r.use_shade, kUseShade) | bit(r.shade.two_sided, kTwoSided) | bit(r.eager, kEager) |
           bit(r.order == StackOrder::Fifo, kFifo) |
           bit(r.normal_space == NormalSpace::Map, kMapSpaceNormals) |
           bit(r.height_test.box == BoxKind::Literal, kLiteralBoxes) |
           bit(r.height_test.mode == HeightMode::Sum, kSumMode) | map_features(draw.map);
}

uint32_t features(const SweepDraw<Fixed>& draw) {
    return kSweep | bit(draw.registers.use_bump, kUseBump) |
           bit(draw.registers.use_shade, kUseShade) |
           bit(draw.registers.shade.two_sided, kTwoSided) | bit(draw.registers.use_clip, kUseClip) |
           map_features(draw.map);
}

}  // namespace

uint64_t buffer_bytes(const Draw& draw, uint32_t output_capacity) {
    return std::visit(
        [output_capacity](const auto& d) {
            return aligned(d.vertices.size() * sizeof(VertexRecord)) + aligned(base_bytes(d)) +
                   aligned(bytes_of(d.tables.heights)) + aligned(bytes_of(d.tables.normals)) +
                   aligned(bytes_of(d.tables.turns)) + aligned(bytes_of(d.tables.sums)) +
                   output_bytes(d, output_capacity);
        },
        draw);
}

void Driver::place(Register low, const void* data, uint64_t bytes) {
    set_address(low, next_address_);
    port.write(next_address_, data, bytes, local_time_);
    next_address_ += aligned(bytes);
}

void Driver::upload(const Draw& draw) {
    next_address_ = map_.memory;
    std::visit(
        [this](const auto& d) {
            const auto vertices = records_of<std::vector<VertexRecord>>(d.vertices);
            place(kVerticesLo, vertices.data(), bytes_of(vertices));
            upload_bases(d);
            place(kHeightsLo, d.tables.heights.data(), bytes_of(d.tables.heights));
            if (d.tables.turns.empty()) {
                place(kNormalsLo, d.tables.normals.data(), bytes_of(d.tables.normals));
            } else {
                place(kNormalsLo, d.tables.turns.data(), bytes_of(d.tables.turns));
            }
            place(kSumsLo, d.tables.sums.data(), bytes_of(d.tables.sums));
        },
        draw);
    output_address_ = next_address_;
    set_address(kOutputLo, output_address_);
    output_vertices_address_ =
        output_address_ + aligned(map_.output_capacity * sizeof(FineTriangleRecord));
    set_address(kOutputVerticesLo, output_vertices_address_);
}

void Driver::upload_bases(const AdaptiveDraw<Fixed>& draw) {
    place(kIndicesLo, draw.triangles.data(), bytes_of(draw.triangles));
}

void Driver::upload_bases(const SweepDraw<Fixed>& draw) {
    const auto bases = records_of<std::vector<SweepRecord>>(draw.triangles);
    place(kIndicesLo, bases.data(), bytes_of(bases));
    place(kZTableLo, draw.z_table.data(), bytes_of(draw.z_table));
}

template <class D>
void Driver::program_common(const D& draw) {
    set(kFeatures, features(draw));
    set(kMapWidth, draw.map.width);
    set(kMapHeight, draw.map.height);
    set(kScaleMantissa, draw.map.scale_mantissa);
    set(kScaleExponent, draw.map.scale_exponent);
    set(kBias, draw.map.bias);
    set(kSlopeUMantissa, draw.map.slope_u.mantissa);
    set(kSlopeUExponent, draw.map.slope_u.exponent);
    set(kSlopeVMantissa, draw.map.slope_v.mantissa);
    set(kSlopeVExponent, draw.map.slope_v.exponent);
    const ViewRegisters<Fixed>& c = draw.camera;
    set(kEye, c.eye);
    set(kRight, c.right);
    set(kUp, c.up);
    set(kForward, c.forward);
    set(kNear, c.near);
    set(kFocalX, c.focal_x);
    set(kFocalY, c.focal_y);
    set(kCentreX, c.centre_x);
    set(kCentreY, c.centre_y);
    set(kVertexCount, static_cast<uint32_t>(draw.vertices.size()));
    set(kTriangleCount, static_cast<uint32_t>(draw.triangles.size()));
    set(kOutputCapacity, map_.output_capacity);
}

// The eye is the camera's.
void Driver::program_shade(const ShadeRegisters<Fixed>& r) {
    set(kAmbient, r.ambient);
    set(kShininess, r.shininess);
    uint32_t at = kLights;
    for (const Light<Fixed>& light : r.lights) {
        set(at, light.direction);
        set(at + 3, light.diffuse);
        set(at + 6, light.specular);
        at += kLightWords;
    }
}

void Driver::program(const AdaptiveDraw<Fixed>& draw) {
    program_common(draw);
    const AdaptiveRegisters<Fixed>& r = draw.registers;
    set(kCap, r.cap);
    set(kViewThreshold, static_cast<uint32_t>(r.view_threshold));
    set(kNormalThreshold, r.normal_threshold);
    set(kHeightThresholdLo, static_cast<uint32_t>(r.height_test.threshold));
    set(kHeightThresholdHi, static_cast<uint32_t>(r.height_test.threshold >> 32));
    if (r.use_shade) program_shade(r.shade);
}

void Driver::program(const SweepDraw<Fixed>& draw) {
    program_common(draw);
    set(kOutputVertexCapacity, map_.output_capacity);
    const GridRegisters<Fixed>& grid = draw.registers.grid;
    set(kGridFocalX, grid.focal_x);
    set(kGridFocalY, grid.focal_y);
    set(kWMin, grid.w_min);
    set(kWScale, grid.w_scale);
    set(kStepsPerOctave, grid.steps_per_octave);
    set(kLog2Near, grid.log2_near);
    set(kZTableNear, grid.table_near);
    set(kZTableScale, grid.table_scale);
    set(kZTableShift, uint32_t(grid.table_shift));
    set(kGuard, draw.registers.setup.guard);
    set(kZOffset, draw.registers.setup.z_offset);
    const ClipRegisters<Fixed>& clip = draw.registers.clip;
    set(kClipNear, clip.near);
    set(kClipFar, clip.far);
    set(kClipCosineX, clip.cosine_x);
    set(kClipSineX, clip.sine_x);
    set(kClipCosineY, clip.cosine_y);
    set(kClipSineY, clip.sine_y);
    set(kClipMargin, clip.margin);
    set(kLastLevel, draw.map.last_level);
    set(kFiner, draw.map.finer);
    if (draw.registers.use_shade) program_shade(draw.registers.shade);
}

}  // namespace repousse::shell

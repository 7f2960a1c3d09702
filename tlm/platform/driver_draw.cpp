// How the driver lays a draw out in memory and programs the device for it.

#include "tlm/platform/driver.h"
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

template <class Records, class Items>
Records records_of(const Items& items) {
    Records records;
    records.reserve(items.size());
    for (const auto& item : items) records.push_back(record_of(item));
    return records;
}

uint32_t bit(bool set, Feature feature) { return set ? uint32_t(feature) : 0; }

uint32_t map_features(const MapView<Fixed>& map) {
    return bit(map.wrap, kWrap) | bit(map.filter == HeightFilter::Bilinear, kBilinear);
}

uint32_t features(const AdaptiveDraw<Fixed>& draw) {
    const AdaptiveRegisters<Fixed>& r = draw.registers;
    return bit(r.use_view_test, kUseViewTest) | bit(r.use_normal_test, kUseNormalTest) |
           bit(r.use_height_test, kUseHeightTest) | bit(r.use_bump, kUseBump) |
           bit(r.eager, kEager) | bit(r.order == StackOrder::Fifo, kFifo) |
           bit(r.normal_space == NormalSpace::Map, kMapSpaceNormals) |
           bit(r.height_test.box == BoxKind::Literal, kLiteralBoxes) |
           bit(r.height_test.mode == HeightMode::Sum, kSumMode) | map_features(draw.map);
}

uint32_t features(const SweepDraw<Fixed>& draw) {
    return kSweep | bit(draw.registers.use_bump, kUseBump) |
           bit(draw.registers.use_clip, kUseClip) | map_features(draw.map);
}

}  // namespace

uint64_t buffer_bytes(const Draw& draw, uint32_t output_capacity) {
    return std::visit(
        [output_capacity](const auto& d) {
            return aligned(d.vertices.size() * sizeof(VertexRecord)) + aligned(base_bytes(d)) +
                   aligned(bytes_of(d.tables.heights)) + aligned(bytes_of(d.tables.normals)) +
                   aligned(bytes_of(d.tables.sums)) +
                   aligned(output_capacity * sizeof(OutputRecord));
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
            place(kNormalsLo, d.tables.normals.data(), bytes_of(d.tables.normals));
            place(kSumsLo, d.tables.sums.data(), bytes_of(d.tables.sums));
        },
        draw);
    output_address_ = next_address_;
    set_address(kOutputLo, output_address_);
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

void Driver::program(const AdaptiveDraw<Fixed>& draw) {
    program_common(draw);
    const AdaptiveRegisters<Fixed>& r = draw.registers;
    set(kCap, r.cap);
    set(kViewThreshold, static_cast<uint32_t>(r.view_threshold));
    set(kNormalThreshold, r.normal_threshold);
    set(kHeightThresholdLo, static_cast<uint32_t>(r.height_test.threshold));
    set(kHeightThresholdHi, static_cast<uint32_t>(r.height_test.threshold >> 32));
}

void Driver::program(const SweepDraw<Fixed>& draw) {
    program_common(draw);
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
}

}  // namespace repousse::shell

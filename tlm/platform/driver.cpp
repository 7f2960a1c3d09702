#include "tlm/platform/driver.h"

namespace repousse::shell {
namespace {

// Buffers start on cache lines.
constexpr uint64_t kAlignment = 64;

uint64_t aligned(uint64_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

template <class T>
uint64_t bytes_of(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

uint32_t features(const AdaptiveDraw<Fixed>& draw) {
    const AdaptiveRegisters<Fixed>& r = draw.registers;
    const auto bit = [](bool set, Feature feature) { return set ? uint32_t(feature) : 0; };
    return bit(r.use_view_test, kUseViewTest) | bit(r.use_normal_test, kUseNormalTest) |
           bit(r.use_height_test, kUseHeightTest) | bit(r.use_bump, kUseBump) |
           bit(r.eager, kEager) | bit(r.order == StackOrder::Fifo, kFifo) |
           bit(r.normal_space == NormalSpace::Map, kMapSpaceNormals) |
           bit(r.height_test.box == BoxKind::Literal, kLiteralBoxes) |
           bit(r.height_test.mode == HeightMode::Sum, kSumMode) | bit(draw.map.wrap, kWrap) |
           bit(draw.map.filter == HeightFilter::Bilinear, kBilinear);
}

OutputTriangle<Fixed> triangle_of(const OutputRecord& record) {
    OutputTriangle<Fixed> triangle;
    triangle.path = {record.base, static_cast<uint8_t>(record.depth), record.digits};
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputRecord::Corner& c = record.corners[k];
        triangle.corners[k] = {
            {c.uv[0], c.uv[1]},
            {c.displaced[0], c.displaced[1], c.displaced[2]},
            {c.displaced_normal[0], c.displaced_normal[1], c.displaced_normal[2]},
            static_cast<uint8_t>(c.generation)};
    }
    return triangle;
}

const char* reason(uint32_t error) {
    switch (error) {
        case kMissingUnit:
            return "a feature needs a unit that was not built";
        case kBadRegister:
            return "a register is out of its range";
        case kMemoryError:
            return "a memory access was answered with an error";
        case kStackOverflow:
            return "the triangle stack overflowed its proven bound";
        case kBadIndex:
            return "an index names no vertex";
        default:
            return "no reason given";
    }
}

}  // namespace

uint64_t buffer_bytes(const AdaptiveDraw<Fixed>& draw, uint32_t output_capacity) {
    return aligned(draw.vertices.size() * sizeof(VertexRecord)) +
           aligned(bytes_of(draw.triangles)) + aligned(bytes_of(draw.tables.heights)) +
           aligned(bytes_of(draw.tables.normals)) + aligned(bytes_of(draw.tables.sums)) +
           aligned(output_capacity * sizeof(OutputRecord));
}

Driver::Driver(const sc_core::sc_module_name& name, const AddressMap& map)
    : sc_module(name), map_(map) {
    SC_THREAD(drive);
    dont_initialize();
    sensitive << start_event_;
}

void Driver::start(Span<const AdaptiveDraw<Fixed>> draws) {
    draws_ = draws;
    outputs_.assign(draws.size(), {});
    status_ = done();
    start_event_.notify(sc_core::SC_ZERO_TIME);
}

void Driver::drive() {
    while (true) {
        drive_all();
        sc_core::wait(start_event_);
    }
}

void Driver::drive_all() {
    port.clear();
    if (get(kId) != kIdValue) {
        status_ = Error{ErrorKind::Environment, "device", "does not answer with its ID", {}, {}};
    }
    set(kControl, 2);  // reset
    set(kControl, 1);  // interrupts
    for (std::size_t i = 0; i < draws_.size() && status_.ok(); ++i) {
        if (!run(draws_[i], outputs_[i]) && status_.ok()) {
            status_ = Error{ErrorKind::Mismatch,
                            "draw " + std::to_string(i),
                            std::string("the device reports: ") + reason(get(kErrorCode)),
                            {},
                            {}};
        }
    }
}

bool Driver::run(const AdaptiveDraw<Fixed>& draw, Output& output) {
    upload(draw);
    program(draw);
    if (!port.ok()) {
        status_ = Error{ErrorKind::Environment, "memory", "an access failed", {}, {}};
        return false;
    }
    set(kDoorbell, kStart);
    while (true) {
        sc_core::wait(local_time_);
        local_time_ = sc_core::SC_ZERO_TIME;
        if (!interrupt.read()) sc_core::wait(interrupt.posedge_event());
        const uint32_t status = get(kStatus);
        set(kInterrupt, 1);
        sc_core::wait(interrupt.negedge_event());
        collect(output);
        if ((status & kStatusDone) != 0) return (status & kStatusError) == 0;
        set(kDoorbell, kDrained);
    }
}

void Driver::place(Register low, const void* data, uint64_t bytes) {
    set_address(low, next_address_);
    port.write(next_address_, data, bytes, local_time_);
    next_address_ += aligned(bytes);
}

void Driver::upload(const AdaptiveDraw<Fixed>& draw) {
    next_address_ = map_.memory;
    std::vector<VertexRecord> vertices;
    vertices.reserve(draw.vertices.size());
    for (const Vertex<Fixed>& v : draw.vertices) {
        vertices.push_back({{v.uv.x, v.uv.y},
                            {v.position.x, v.position.y, v.position.z},
                            {v.normal.x, v.normal.y, v.normal.z},
                            {v.tangent.x, v.tangent.y, v.tangent.z},
                            v.handedness});
    }
    place(kVerticesLo, vertices.data(), bytes_of(vertices));
    place(kIndicesLo, draw.triangles.data(), bytes_of(draw.triangles));
    place(kHeightsLo, draw.tables.heights.data(), bytes_of(draw.tables.heights));
    place(kNormalsLo, draw.tables.normals.data(), bytes_of(draw.tables.normals));
    place(kSumsLo, draw.tables.sums.data(), bytes_of(draw.tables.sums));
    output_address_ = next_address_;
    set_address(kOutputLo, output_address_);
}

void Driver::program(const AdaptiveDraw<Fixed>& draw) {
    const AdaptiveRegisters<Fixed>& r = draw.registers;
    const auto word = [](int32_t value) { return static_cast<uint32_t>(value); };
    set(kFeatures, features(draw));
    set(kCap, static_cast<uint32_t>(r.cap));
    set(kViewThreshold, static_cast<uint32_t>(r.view_threshold));
    set(kNormalThreshold, word(r.normal_threshold));
    set(kHeightThresholdLo, static_cast<uint32_t>(r.height_test.threshold));
    set(kHeightThresholdHi, static_cast<uint32_t>(r.height_test.threshold >> 32));
    set(kMapWidth, word(draw.map.width));
    set(kMapHeight, word(draw.map.height));
    set(kScaleMantissa, word(draw.map.scale_mantissa));
    set(kScaleExponent, word(draw.map.scale_exponent));
    set(kBias, word(draw.map.bias));
    const auto vector = [&](uint32_t index, const Vec3<int32_t>& v) {
        set(index, word(v.x));
        set(index + 1, word(v.y));
        set(index + 2, word(v.z));
    };
    const ViewRegisters<Fixed>& c = draw.camera;
    vector(kEye, c.eye);
    vector(kRight, c.right);
    vector(kUp, c.up);
    vector(kForward, c.forward);
    set(kNear, word(c.near));
    set(kFocalX, word(c.focal_x));
    set(kFocalY, word(c.focal_y));
    set(kCentreX, word(c.centre_x));
    set(kCentreY, word(c.centre_y));
    set(kVertexCount, static_cast<uint32_t>(draw.vertices.size()));
    set(kTriangleCount, static_cast<uint32_t>(draw.triangles.size()));
    set(kOutputCapacity, map_.output_capacity);
}

void Driver::collect(Output& output) {
    const uint32_t count = get(kOutputCount);
    const uint64_t bytes = count * sizeof(OutputRecord);
    const auto* records =
        static_cast<const OutputRecord*>(port.view(output_address_, bytes, local_time_));
    for (uint32_t i = 0; i < count; ++i) output.push_back(triangle_of(records[i]));
}

void Driver::set(uint32_t index, uint32_t word) {
    port.write(map_.device + 4 * uint64_t(index), &word, sizeof word, local_time_);
}

void Driver::set_address(Register low, uint64_t address) {
    set(low, static_cast<uint32_t>(address));
    set(low + 1, static_cast<uint32_t>(address >> 32));
}

uint32_t Driver::get(uint32_t index) {
    uint32_t word = 0;
    port.read(map_.device + 4 * uint64_t(index), &word, sizeof word, local_time_);
    return word;
}

}  // namespace repousse::shell

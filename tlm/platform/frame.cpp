// The frame of the DisplacementUnit: from the doorbell to the interrupt.

#include <algorithm>

#include "datapath/units/edge_iter.h"
#include "tlm/platform/displacement_unit.h"

namespace repousse::shell {
namespace {

// Triangles that are converted at a time on their way to memory.
constexpr std::size_t kOutputChunk = 256;

OutputRecord record_of(const OutputTriangle<Fixed>& triangle) {
    OutputRecord record;
    record.base = triangle.path.base;
    record.depth = triangle.path.depth;
    record.digits = triangle.path.digits;
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputVertex<Fixed>& v = triangle.corners[k];
        record.corners[k] = {{v.uv.x, v.uv.y},
                             {v.displaced.x, v.displaced.y, v.displaced.z},
                             {v.displaced_normal.x, v.displaced_normal.y, v.displaced_normal.z},
                             v.generation};
    }
    return record;
}

}  // namespace

uint64_t DisplacementUnit::address(Register low) const {
    return uint64_t(frame_[low + 1]) << 32 | frame_[low];
}

void DisplacementUnit::raise(uint32_t status) {
    status_ = status;
    interrupt_level_ = (file_[kControl] & 1) != 0;
    interrupt_event_.notify(sc_core::SC_ZERO_TIME);
}

void DisplacementUnit::run_frames() {
    while (true) {
        wait(start_event_);
        quantum_.reset();
        output_count_ = 0;
        const FrameError error = run_frame();
        quantum_.sync();
        error_ = error;
        raise(error == kNoError ? kStatusDone : kStatusDone | kStatusError);
    }
}

FrameError DisplacementUnit::run_frame() {
    if (const FrameError error = configure_units()) return error;
    uint32_t next = 0;
    bad_index_ = false;
    TriangleStack::Frame frame;
    frame.order = has(kFifo) ? StackOrder::Fifo : StackOrder::Lifo;
    frame.cap = static_cast<int>(frame_[kCap]);
    frame.fetch = [&](Triangle<Fixed>& triangle) {
        return next < frame_[kTriangleCount] && fetch(next++, triangle);
    };
    frame.emit = [this](Span<const OutputTriangle<Fixed>> triangles) { emit(triangles); };
    frame.elapse = [this](uint64_t cycles) { elapse(cycles); };
    const bool fits = triangle_stack_.run(frame);
    if (!memory_port.ok()) return kMemoryError;
    if (bad_index_) return kBadIndex;
    return fits ? kNoError : kStackOverflow;
}

FrameError DisplacementUnit::configure_units() {
    const bool missing = (has(kUseViewTest) && !view_test_) ||
                         (has(kUseNormalTest) && !normal_test_) ||
                         (has(kUseHeightTest) && !height_test_) || (has(kUseBump) && !bump_);
    if (missing) return kMissingUnit;
    const bool needs_bump = has(kUseNormalTest) && !has(kUseBump);
    if (needs_bump || frame_[kCap] > uint32_t(repousse::EdgeIter<Fixed>::kMaxCap) ||
        frame_[kOutputCapacity] == 0 || frame_[kMapWidth] == 0 || frame_[kMapHeight] == 0) {
        return kBadRegister;
    }
    const bool eager = has(kEager);
    edge_iter_.configure(static_cast<int>(frame_[kCap]));
    texcoord_test_.configure(eager);
    mid_vertex_.configure(has(kUseNormalTest), eager);
    split_.configure(has(kUseNormalTest) || has(kUseHeightTest));
    if (view_test_) {
        view_test_->enable(has(kUseViewTest));
        view_test_->configure(frame_[kViewThreshold], eager);
        if (has(kUseViewTest)) {
            vertex_transform_->configure(camera());
        } else {
            vertex_transform_->disable();
        }
    }
    if (normal_test_) {
        normal_test_->enable(has(kUseNormalTest));
        normal_test_->configure(static_cast<int32_t>(frame_[kNormalThreshold]),
                                has(kMapSpaceNormals) ? NormalSpace::Map : NormalSpace::World,
                                eager);
    }
    return bind_map();
}

// Fetches pointers to the tables; again whenever the memory takes them back.
FrameError DisplacementUnit::bind_map() {
    memory_port.moved();
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    MapView<Fixed> map;
    map.width = static_cast<int>(frame_[kMapWidth]);
    map.height = static_cast<int>(frame_[kMapHeight]);
    map.wrap = has(kWrap);
    map.filter = has(kBilinear) ? HeightFilter::Bilinear : HeightFilter::Nearest;
    map.scale_mantissa = static_cast<int32_t>(frame_[kScaleMantissa]);
    map.scale_exponent = static_cast<int>(frame_[kScaleExponent]);
    map.bias = static_cast<int32_t>(frame_[kBias]);
    const auto texels = std::size_t(frame_[kMapWidth]) * frame_[kMapHeight];
    const auto table = [&](Register low, std::size_t count, auto* element) {
        using T = std::remove_pointer_t<decltype(element)>;
        const void* at = memory_port.view(address(low), count * sizeof(T), delay);
        return Span<const T>(static_cast<const T*>(at), count);
    };
    map.heights = table(kHeightsLo, texels, static_cast<uint16_t*>(nullptr));
    if (has(kUseBump))
        map.normals = table(kNormalsLo, texels, static_cast<Vec3<int16_t>*>(nullptr));
    if (has(kUseHeightTest)) {
        const auto entries = (std::size_t(frame_[kMapWidth]) + 1) * (frame_[kMapHeight] + 1);
        map.sums = table(kSumsLo, entries, static_cast<uint64_t*>(nullptr));
    }
    vertices_ =
        table(kVerticesLo, frame_[kVertexCount], static_cast<VertexRecord*>(nullptr)).data();
    indices_ =
        table(kIndicesLo, 3 * std::size_t(frame_[kTriangleCount]), static_cast<uint32_t*>(nullptr))
            .data();
    quantum_.inc(delay);
    if (!memory_port.ok()) return kMemoryError;

    displace_.configure(map);
    if (bump_) {
        if (has(kUseBump)) {
            bump_->configure(map, has(kUseNormalTest), has(kEager));
        } else {
            bump_->disable();
        }
    }
    if (height_test_) {
        height_test_->enable(has(kUseHeightTest));
        const HeightTestRegisters test{map.width,
                                       map.height,
                                       map.wrap,
                                       has(kLiteralBoxes) ? BoxKind::Literal : BoxKind::Square,
                                       has(kSumMode) ? HeightMode::Sum : HeightMode::Average,
                                       address(kHeightThresholdLo)};
        if (has(kUseHeightTest) && !height_test_->configure(test, map.sums, has(kEager))) {
            return kBadRegister;
        }
    }
    return kNoError;
}

ViewRegisters<Fixed> DisplacementUnit::camera() const {
    const auto word = [this](uint32_t i) { return static_cast<int32_t>(frame_[i]); };
    const auto vector = [&](uint32_t i) {
        return Vec3<int32_t>{word(i), word(i + 1), word(i + 2)};
    };
    return {vector(kEye),  vector(kRight), vector(kUp),    vector(kForward), word(kNear),
            word(kFocalX), word(kFocalY),  word(kCentreX), word(kCentreY)};
}

bool DisplacementUnit::fetch(uint32_t index, Triangle<Fixed>& triangle) {
    triangle = {};
    for (std::size_t k = 0; k < 3; ++k) {
        const uint32_t i = indices_[3 * std::size_t(index) + k];
        if (i >= frame_[kVertexCount]) {
            bad_index_ = true;
            return false;
        }
        const VertexRecord& r = vertices_[i];
        Vertex<Fixed>& v = triangle.corners[k];
        v.uv = {r.uv[0], r.uv[1]};
        v.position = {r.position[0], r.position[1], r.position[2]};
        v.normal = {r.normal[0], r.normal[1], r.normal[2]};
        v.tangent = {r.tangent[0], r.tangent[1], r.tangent[2]};
        v.handedness = r.handedness < 0 ? -1 : 1;
    }
    return true;
}

// A full buffer stops the frame until the host has emptied it, so any buffer is large enough.
void DisplacementUnit::emit(Span<const OutputTriangle<Fixed>> triangles) {
    std::array<OutputRecord, kOutputChunk> chunk;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    for (std::size_t i = 0; i < triangles.size();) {
        if (output_count_ == frame_[kOutputCapacity]) {
            quantum_.sync();
            raise(kStatusBusy | kStatusOutputFull);
            wait(drained_event_);
            status_ = kStatusBusy;
            output_count_ = 0;
        }
        const std::size_t n = std::min({triangles.size() - i, kOutputChunk,
                                        std::size_t(frame_[kOutputCapacity] - output_count_)});
        for (std::size_t k = 0; k < n; ++k) chunk[k] = record_of(triangles[i + k]);
        memory_port.write(address(kOutputLo) + output_count_ * sizeof(OutputRecord), chunk.data(),
                          n * sizeof(OutputRecord), delay);
        output_count_ += static_cast<uint32_t>(n);
        i += n;
    }
    quantum_.inc(delay);
}

void DisplacementUnit::elapse(uint64_t cycles) {
    cycles_ += cycles;
    quantum_.inc(static_cast<double>(cycles) * clock_period_);
    if (quantum_.need_sync()) quantum_.sync();
    if (memory_port.moved()) bind_map();
}

}  // namespace repousse::shell

#include "tlm/platform/adaptive_path.h"

#include <algorithm>
#include <array>

#include "datapath/units/edge_iter.h"
#include "tlm/platform/bump_table.h"

namespace repousse::shell {
namespace {

// Triangles that are converted at a time on their way to memory.
constexpr std::size_t kOutputChunk = 256;

}  // namespace

AdaptivePath::AdaptivePath(const DeviceConfig& config, SharedUnits& shared, FrameHost& host)
    : shared_(shared),
      host_(host),
      triangle_stack_("triangle_stack", config.contexts),
      edge_iter_("edge_iter"),
      mid_vertex_("mid_vertex", config.profile),
      texcoord_test_("texcoord_test", config.profile),
      split_("split", config.profile) {
    const Profile& profile = config.profile;
    if (config.view_test) view_test_ = std::make_unique<ViewTest>("view_test", profile);
    if (config.normal_test) normal_test_ = std::make_unique<NormalTest>("normal_test", profile);
    if (config.height_test) height_test_ = std::make_unique<HeightTest>("height_test", profile);
    connect();
}

// The chain in the hardware's order (Doggett and Hirche, figure 8): the serial tests, the decision,
// what only new vertices need. A unit that was not built leaves no gap.
void AdaptivePath::connect() {
    Chain<EdgeBatch> edges(triangle_stack_.out);
    edges.then(edge_iter_);
    edges.then(mid_vertex_.topology);
    edges.then(texcoord_test_);
    if (view_test_) edges.then(*view_test_);
    if (normal_test_) {
        edges.then(mid_vertex_.before_test);
        edges.then(shared_.bump->before_test);
        edges.then(*normal_test_);
    }
    if (height_test_) edges.then(*height_test_);
    edges.then(split_);
    edges.then(mid_vertex_.after_split);
    if (shared_.bump) edges.then(shared_.bump->after_split);
    edges.then(shared_.displace->edges);
    if (shared_.shade) edges.then(shared_.shade->edges);
    if (view_test_) edges.then(shared_.vertex_transform->edges);
    triangle_stack_.children.bind(split_.children);

    Chain<Triangle<Fixed>> base(triangle_stack_.base_out);
    base.then(shared_.displace->base);
    if (shared_.bump) base.then(shared_.bump->base);
    if (shared_.shade) base.then(shared_.shade->base);
    if (view_test_) base.then(shared_.vertex_transform->base);
}

AdaptiveCounters AdaptivePath::counters() const {
    AdaptiveCounters c;
    c.stack_peak = triangle_stack_.peak();
    c.edge_iter = edge_iter_.counters();
    c.mid_vertex = mid_vertex_.counters();
    c.texcoord_test = texcoord_test_.counters();
    c.displace = shared_.displace->counters();
    c.split = split_.counters();
    if (shared_.vertex_transform) c.vertex_transform = shared_.vertex_transform->counters();
    if (view_test_) c.view_test = view_test_->counters();
    if (shared_.bump) c.bump = shared_.bump->counters();
    if (shared_.shade) c.shade = shared_.shade->counters();
    if (normal_test_) c.normal_test = normal_test_->counters();
    if (height_test_) {
        c.height_test = height_test_->counters();
        c.height_test_reads = height_test_->stats().reads;
    }
    return c;
}

void AdaptivePath::reset() {
    triangle_stack_.reset();
    edge_iter_.reset();
    mid_vertex_.reset();
    texcoord_test_.reset();
    split_.reset();
    if (view_test_) view_test_->reset();
    if (normal_test_) normal_test_->reset();
    if (height_test_) height_test_->reset();
}

FrameError AdaptivePath::run() {
    const FrameRegisters& frame = host_.frame();
    if (!has_units()) return kMissingUnit;
    const bool needs_bump = frame.has(kUseNormalTest) && !frame.has(kUseBump);
    // Slopes give N' without an N_D, which the normal test in map space would want.
    const bool needs_map_normals = frame.has(kUseNormalTest) && frame.has(kMapSpaceNormals) &&
                                   shared_.bump->bump_kind() == BumpKind::Slopes;
    if (needs_bump || needs_map_normals ||
        frame[kCap] > uint32_t(repousse::EdgeIter<Fixed>::kMaxCap)) {
        return kBadRegister;
    }
    configure();
    if (const FrameError error = bind()) return error;

    uint32_t next = 0;
    bad_index_ = aborted_ = false;
    TriangleStack::Frame work;
    work.order = frame.has(kFifo) ? StackOrder::Fifo : StackOrder::Lifo;
    work.cap = static_cast<int>(frame[kCap]);
    work.fetch = [&](Triangle<Fixed>& triangle) {
        return next < frame[kTriangleCount] && fetch(next++, triangle);
    };
    work.emit = [this](Span<const OutputTriangle<Fixed>> triangles) { emit(triangles); };
    work.elapse = [this](uint64_t cycles) {
        aborted_ = !host_.elapse(cycles);
        return !aborted_;
    };
    const bool fits = triangle_stack_.run(work);
    if (aborted_) return kAborted;
    if (bad_index_) return kBadIndex;
    return fits ? kNoError : kStackOverflow;
}

bool AdaptivePath::has_units() const {
    const FrameRegisters& frame = host_.frame();
    return (!frame.has(kUseViewTest) || view_test_) &&
           (!frame.has(kUseNormalTest) || normal_test_) &&
           (!frame.has(kUseHeightTest) || height_test_) && (!frame.has(kUseBump) || shared_.bump) &&
           (!frame.has(kUseShade) || shared_.shade);
}

void AdaptivePath::configure() {
    const FrameRegisters& frame = host_.frame();
    const bool eager = frame.has(kEager);
    edge_iter_.configure(static_cast<int>(frame[kCap]));
    texcoord_test_.configure(eager);
    mid_vertex_.configure(frame.has(kUseNormalTest), eager);
    split_.configure(frame.has(kUseNormalTest) || frame.has(kUseHeightTest));
    shared_.configure_shade(frame);
    if (view_test_) {
        view_test_->enable(frame.has(kUseViewTest));
        view_test_->configure(frame[kViewThreshold], eager);
        if (frame.has(kUseViewTest)) {
            shared_.vertex_transform->configure(frame.camera());
        } else {
            shared_.vertex_transform->disable();
        }
    }
    if (normal_test_) {
        normal_test_->enable(frame.has(kUseNormalTest));
        normal_test_->configure(frame.word(kNormalThreshold),
                                frame.has(kMapSpaceNormals) ? NormalSpace::Map : NormalSpace::World,
                                eager);
    }
}

FrameError AdaptivePath::bind() {
    const FrameRegisters& frame = host_.frame();
    MapView<Fixed> map = frame.map();
    const auto texels = std::size_t(frame[kMapWidth]) * frame[kMapHeight];
    map.heights = host_.table<uint16_t>(kHeightsLo, texels);
    if (frame.has(kUseBump)) bind_bump(host_, shared_.bump->bump_kind(), texels, map);
    if (frame.has(kUseHeightTest)) {
        const auto entries = (std::size_t(frame[kMapWidth]) + 1) * (frame[kMapHeight] + 1);
        map.sums = host_.table<uint64_t>(kSumsLo, entries);
    }
    vertices_ = host_.table<VertexRecord>(kVerticesLo, frame[kVertexCount]);
    indices_ = host_.table<uint32_t>(kIndicesLo, 3 * std::size_t(frame[kTriangleCount]));
    if (!host_.memory_ok()) return kMemoryError;

    shared_.displace->configure(map);
    if (shared_.bump) {
        if (frame.has(kUseBump)) {
            shared_.bump->configure(map, frame.has(kUseNormalTest), frame.has(kEager));
        } else {
            shared_.bump->disable();
        }
    }
    return configure_height_test(map);
}

FrameError AdaptivePath::configure_height_test(const MapView<Fixed>& map) {
    if (!height_test_) return kNoError;
    const FrameRegisters& frame = host_.frame();
    height_test_->enable(frame.has(kUseHeightTest));
    if (!frame.has(kUseHeightTest)) return kNoError;
    const HeightTestRegisters test{map.width,
                                   map.height,
                                   map.wrap,
                                   frame.has(kLiteralBoxes) ? BoxKind::Literal : BoxKind::Square,
                                   frame.has(kSumMode) ? HeightMode::Sum : HeightMode::Average,
                                   frame.address(kHeightThresholdLo)};
    return height_test_->configure(test, map.sums, frame.has(kEager)) ? kNoError : kBadRegister;
}

bool AdaptivePath::fetch(uint32_t index, Triangle<Fixed>& triangle) {
    triangle = {};
    for (std::size_t k = 0; k < 3; ++k) {
        const uint32_t i = indices_[3 * std::size_t(index) + k];
        if (i >= vertices_.size()) {
            bad_index_ = true;
            return false;
        }
        triangle.corners[k] = vertex_of(vertices_[i]);
    }
    return true;
}

void AdaptivePath::emit(Span<const OutputTriangle<Fixed>> triangles) {
    std::array<OutputRecord, kOutputChunk> chunk;
    for (std::size_t i = 0; i < triangles.size();) {
        const std::size_t n = std::min(triangles.size() - i, kOutputChunk);
        for (std::size_t k = 0; k < n; ++k) chunk[k] = record_of(triangles[i + k]);
        host_.write({chunk.data(), n});
        i += n;
    }
}

}  // namespace repousse::shell

#include "tlm/platform/sweep_path.h"

#include "tlm/platform/bump_table.h"

namespace repousse::shell {

SweepPath::Units::Units(const DeviceConfig& config)
    : grid_transform("grid_transform", config.profile),
      view_clip(config.view_clip ? std::make_unique<ViewClip>("view_clip", config.profile)
                                 : nullptr),
      triangle_setup("triangle_setup", config.profile),
      sweep_line("sweep_line", config.profile),
      perspective("perspective", config.profile),
      footprint(config.levels ? std::make_unique<Footprint>("footprint", config.profile) : nullptr),
      strip("strip") {}

SweepPath::SweepPath(const DeviceConfig& config, SharedUnits& shared, FrameHost& host)
    : profile_(config.profile),
      shared_(shared),
      host_(host),
      controller_("controller", config.profile),
      triangle_buffer_("triangle_buffer") {
    if (config.sweep) units_ = std::make_unique<Units>(config);
    connect();
}

// Vertices to the grid; base triangles to the sweep line; from there, what new vertices need, and
// the strips.
void SweepPath::connect() {
    controller_.order.bind(triangle_buffer_.order);
    if (!units_) return;
    Chain<CornerBatch> corners(controller_.corners_out);
    corners.then(shared_.vertex_transform->corners);
    corners.then(units_->grid_transform);
    corners.then(units_->triangle_setup.slots);

    Chain<BaseBatch> triangles(controller_.out);
    if (units_->view_clip) triangles.then(*units_->view_clip);
    triangles.then(units_->triangle_setup.triangles);
    triangles.then(units_->sweep_line);

    Chain<FineBatch> fine(units_->sweep_line.fine_out);
    fine.then(units_->perspective);
    if (units_->footprint) fine.then(*units_->footprint);
    fine.then(shared_.displace->fine);
    if (shared_.bump) fine.then(shared_.bump->fine);
    if (shared_.shade) fine.then(shared_.shade->fine);
    fine.then(units_->strip);
    units_->strip.fine_out.bind(triangle_buffer_.in);
}

SweepCounters SweepPath::counters() const {
    SweepCounters c;
    c.controller = controller_.counters();
    c.triangle_buffer = triangle_buffer_.counters();
    if (!units_) return c;
    c.vertex_transform = shared_.vertex_transform->counters();
    c.grid_transform = units_->grid_transform.counters();
    if (units_->view_clip) c.view_clip = units_->view_clip->counters();
    c.triangle_setup = units_->triangle_setup.counters();
    c.sweep_line = units_->sweep_line.counters();
    c.perspective = units_->perspective.counters();
    c.normalise = units_->perspective.normalise_counters();
    if (units_->footprint) c.footprint = units_->footprint->counters();
    c.displace = shared_.displace->counters();
    if (shared_.bump) c.bump = shared_.bump->counters();
    if (shared_.shade) c.shade = shared_.shade->counters();
    c.strip = units_->strip.counters();
    return c;
}

void SweepPath::reset() {
    controller_.reset();
    triangle_buffer_.reset();
    busy_ = {};
    if (!units_) return;
    units_->grid_transform.reset();
    if (units_->view_clip) units_->view_clip->reset();
    units_->triangle_setup.reset();
    units_->sweep_line.reset();
    units_->perspective.reset();
    if (units_->footprint) units_->footprint->reset();
    units_->strip.reset();
}

uint32_t SweepPath::status() const {
    if (!units_) return 0;
    return (units_->sweep_line.runaway() ? uint32_t(kStatusRunaway) : 0) |
           (units_->strip.bad_ref() ? uint32_t(kStatusBadRef) : 0);
}

FrameError SweepPath::run() {
    const FrameRegisters& frame = host_.frame();
    if (!has_units()) return kMissingUnit;
    if (units_ && !in_range()) return kBadRegister;
    configure();
    if (const FrameError error = bind()) return error;

    Controller::Frame work;
    work.vertex_count = frame[kVertexCount];
    work.triangle_count = frame[kTriangleCount];
    work.use_bump = frame.has(kUseBump);
    work.vertex = [this](uint32_t i) -> const VertexRecord& { return vertices_[i]; };
    work.base = [this](uint32_t i) -> const SweepRecord& { return bases_[i]; };
    work.elapse = [this](const BatchTime& time) { return elapse(time, stream_time_.outer(time)); };
    const Controller::Outcome outcome = controller_.run(work);
    if (outcome == Controller::Outcome::Aborted) triangle_buffer_.clear();
    triangle_buffer_.drain();
    if (units_) units_->strip.flush();
    switch (outcome) {
        case Controller::Outcome::Done:
            return kNoError;
        case Controller::Outcome::Aborted:
            return kAborted;
        case Controller::Outcome::BadIndex:
            return kBadIndex;
        case Controller::Outcome::BadDescriptor:
            return kBadDescriptor;
        case Controller::Outcome::MissingUnit:
            return kMissingUnit;
    }
    return kNoError;
}

// Normals of the map are turned into a frame of tangents, which take the last four components.
bool SweepPath::has_units() const {
    if (!units_) return true;
    const FrameRegisters& frame = host_.frame();
    const bool can_bump = shared_.bump && profile_.components == kSweepComponents;
    return (!frame.has(kUseBump) || can_bump) && (!frame.has(kUseShade) || shared_.shade) &&
           (!frame.has(kUseClip) || units_->view_clip) &&
           (!reads_levels(frame.map().filter) || units_->footprint);
}

bool SweepPath::in_range() const {
    const FrameRegisters& frame = host_.frame();
    const bool depth_table =
        static_cast<ZTableKind>(profile_.z_table_kind) != ZTableKind::Uniform ||
        frame[kZTableShift] < 64;
    constexpr int32_t kSlotLimit = 1 << (kGridSlotBits - 1);
    const MapView<Fixed> map = frame.map();
    const bool levels =
        frame[kLastLevel] <= kMostLevels && (frame[kLastLevel] == 0 || reads_levels(map.filter));
    const bool finer =
        frame[kFiner] <= kMostFiner && (frame[kFiner] == 0 || map.filter == HeightFilter::Maximum);
    return levels && finer && frame.word(kWMin) > 0 && frame.word(kWScale) >= frame.word(kWMin) &&
           depth_table && frame.word(kGuard) >= 1 && frame.word(kGuard) <= kGridLimit &&
           frame.word(kZOffset) >= -kSlotLimit && frame.word(kZOffset) < kSlotLimit;
}

void SweepPath::configure() {
    triangle_buffer_.configure(
        {[this](Span<const FineRecord> vertices) { host_.write(vertices); },
         [this](Span<const FineTriangleRecord> triangles) { host_.write(triangles); }});
    stream_time_ = {};
    if (units_) configure_units();
}

void SweepPath::configure_units() {
    const FrameRegisters& frame = host_.frame();
    const bool use_bump = frame.has(kUseBump);
    shared_.vertex_transform->configure(frame.camera());
    shared_.configure_shade(frame);
    if (units_->view_clip) {
        units_->view_clip->enable(frame.has(kUseClip));
        units_->view_clip->configure({frame.word(kClipNear), frame.word(kClipFar),
                                      frame.word(kClipCosineX), frame.word(kClipSineX),
                                      frame.word(kClipCosineY), frame.word(kClipSineY),
                                      frame.word(kClipMargin)});
    }
    units_->triangle_setup.configure({frame.word(kGuard), frame.word(kZOffset)},
                                     use_bump ? kSweepComponents : kPlainComponents,
                                     reads_levels(frame.map().filter));
    if (units_->footprint) {
        units_->footprint->enable(reads_levels(frame.map().filter));
        units_->footprint->configure({frame.word(kMapWidth), frame.word(kMapHeight),
                                      frame.word(kLastLevel), frame.word(kFiner),
                                      frame.vector(kEye)});
    }
    units_->perspective.configure(use_bump);
    units_->sweep_line.configure(
        [this](const BatchTime& time) { return elapse(time, stream_time_.inner(time)); });
    units_->strip.flush();
}

FrameError SweepPath::bind() {
    const FrameRegisters& frame = host_.frame();
    vertices_ = host_.table<VertexRecord>(kVerticesLo, frame[kVertexCount]);
    bases_ = host_.table<SweepRecord>(kIndicesLo, frame[kTriangleCount]);
    if (units_) return bind_units();
    return host_.memory_ok() ? kNoError : kMemoryError;
}

FrameError SweepPath::bind_units() {
    const FrameRegisters& frame = host_.frame();
    MapView<Fixed> map = frame.map();
    const auto texels = std::size_t(frame[kMapWidth]) * frame[kMapHeight];
    map.heights = host_.table<uint16_t>(kHeightsLo, height_table_size(map));
    if (frame.has(kUseBump)) bind_bump(host_, shared_.bump->bump_kind(), texels, map);

    GridRegisters<Fixed> grid;
    grid.w_min = frame.word(kWMin);
    grid.w_scale = frame.word(kWScale);
    grid.focal_x = frame.word(kGridFocalX);
    grid.focal_y = frame.word(kGridFocalY);
    grid.steps_per_octave = frame.word(kStepsPerOctave);
    grid.log2_near = frame.word(kLog2Near);
    if (static_cast<ZTableKind>(profile_.z_table_kind) == ZTableKind::Uniform) {
        grid.table_near = frame.word(kZTableNear);
        grid.table_scale = frame[kZTableScale];
        grid.table_shift = static_cast<uint8_t>(frame[kZTableShift]);
        const auto entries = (std::size_t(1) << profile_.z_table_index_bits) + 1;
        grid.table = host_.table<uint32_t>(kZTableLo, entries);
    }
    if (!host_.memory_ok()) return kMemoryError;

    units_->grid_transform.configure(grid, frame.has(kUseBump));
    shared_.displace->configure(map);
    if (shared_.bump) {
        if (frame.has(kUseBump)) {
            shared_.bump->configure(map, false, false);
        } else {
            shared_.bump->disable();
        }
    }
    return kNoError;
}

bool SweepPath::elapse(const BatchTime& time, uint64_t cycles) {
    busy_.add(time.busy());
    return host_.elapse(cycles);
}

}  // namespace repousse::shell

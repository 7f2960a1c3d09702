#include "datapath/pipelines/sweep.h"

#include <type_traits>

#include "datapath/pipelines/closed_form.h"

namespace repousse {
TriangleSetupOptions setup_options(const Profile& profile, bool use_bump, bool use_footprints) {
    TriangleSetupOptions options;
    options.adder = static_cast<AdderKind>(profile.adder_kind);
    options.guard_bits = profile.guard_bits;
    options.components = use_bump ? kSweepComponents : kPlainComponents;
    options.footprints = use_footprints;
    options.data_bits = profile.sweep_data.width;
    options.c_bits = profile.inverse_w.width;
    return options;
}

SweepLineOptions sweep_options(const Profile& profile) {
    SweepLineOptions options;
    options.column_depth = profile.column_depth;
    return options;
}

template <class P>
SweepPipeline<P>::SweepPipeline(const Profile& profile, const SweepDraw<P>& draw)
    : draw_(draw),
      controller_(profile),
      vertex_transform_(profile),
      grid_transform_(profile),
      triangle_setup_(
          setup_options(profile, draw.registers.use_bump, reads_levels(draw.map.filter))),
      sweep_line_(sweep_options(profile)),
      perspective_(profile),
      displace_(profile),
      corners_(draw.vertices.size()) {
    const SweepRegisters<P>& registers = draw.registers;
    const MapView<P> map = draw.view();
    controller_.configure(static_cast<uint32_t>(draw.vertices.size()), registers.use_bump);
    vertex_transform_.configure(draw.camera);
    GridRegisters<P> grid = registers.grid;
    grid.table = draw.z_table;
    grid_transform_.configure(grid);
    if (registers.use_clip) {
        view_clip_.emplace(profile);
        view_clip_->configure(registers.clip);
    }
    triangle_setup_.configure(registers.setup);
    perspective_.configure(registers.use_bump);
    if (reads_levels(map.filter)) {
        footprint_.emplace(profile);
        footprint_->configure({map.width, map.height, map.last_level, map.finer, draw.camera.eye});
    }
    displace_.configure(map);
    if (registers.use_bump) {
        bump_.emplace(profile);
        bump_->configure(map);
    }
    if (registers.use_shade) {
        shade_.emplace(profile);
        shade_->configure(registers.shade, registers.use_bump);
    }
}

template <class P>
bool SweepPipeline<P>::run(const Emit& emit) {
    for (const SweepBase<P>& triangle : draw_.triangles) {
        const OrderToken token = controller_(triangle.vertices, triangle.direct);
        if (controller_.bad_index()) break;
        if (!triangle_buffer_.expect(token)) {
            drain(emit);
            triangle_buffer_.expect(token);
        }
        if (triangle.direct) {
            pass(token.base, triangle, emit);
        } else {
            remesh(token.base, triangle, emit);
            triangle_buffer_.finish();
        }
    }
    drain(emit);
    return !controller_.bad_index() && !sweep_line_.runaway();
}

template <class P>
void SweepPipeline<P>::transform(uint32_t vertex) {
    Corner& corner = corners_[vertex];
    if (corner.ready) return;
    corner.ready = true;
    const Vertex<P>& base = draw_.vertices[vertex];
    corner.eye = vertex_transform_.eye(base.position);
    const GridPoint<P> point = grid_transform_(corner.eye);
    corner.slot = triangle_setup_.slot(point.position);
    grid_transform_.scale(base, point.c, draw_.registers.use_bump, corner.data);
}

template <class P>
void SweepPipeline<P>::pass(uint32_t base, const SweepBase<P>& triangle, const Emit& emit) {
    typename TriangleBuffer<SweepOutputVertex<P>>::Direct out;
    out.base = base;
    for (std::size_t k = 0; k < 3; ++k) {
        out.corners[k] =
            controller_.undisplaced(draw_.vertices[triangle.vertices[k]], static_cast<uint8_t>(k));
    }
    if (triangle_buffer_.push_direct(out)) return;
    drain(emit);
    triangle_buffer_.push_direct(out);
}

// ---- one base triangle --------------------------------------------------------------------------

// False: clipped away.
template <class P>
bool SweepPipeline<P>::set_up(const SweepBase<P>& triangle) {
    std::array<EyePoint<P>, 3> eye;
    std::array<SweepCorner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const uint32_t vertex = triangle.vertices[k];
        transform(vertex);
        const Corner& corner = corners_[vertex];
        eye[k] = corner.eye;
        corners[k].id = vertex;
        corners[k].slot = corner.slot;
        if constexpr (std::is_same_v<P, Fixed>) corners[k].data = corner.data;
    }
    if (view_clip_ && (*view_clip_)(eye, triangle.max_displacement)) return false;
    triangle_setup_(corners, triangle_);
    if (footprint_) set_texel_steps(triangle);
    return true;
}

template <class P>
void SweepPipeline<P>::set_texel_steps(const SweepBase<P>& triangle) {
    if constexpr (std::is_same_v<P, Fixed>) {
        texel_steps_ = triangle_.texel_steps;
    } else {
        const auto data = [&](std::size_t corner) -> const Data& {
            return corners_[triangle.vertices[corner]].data;
        };
        texel_steps_ = closed_form_steps(triangle_, data(0), data(1), data(2));
    }
}

template <class P>
void SweepPipeline<P>::remesh(uint32_t base, const SweepBase<P>& triangle, const Emit& emit) {
    if (!set_up(triangle)) return;
    sweep_line_.load(triangle_);
    while (sweep_line_.busy()) {
        sweep(triangle);
        perspective_.run(fine_);
        if (footprint_) footprint_->run(fine_, 0, fine_.size, texel_steps_);
        displace_.run(fine_);
        if (bump_) bump_->run(fine_);
        if (shade_) shade_->run(fine_);
        finish_vertices(emit);
        build_strips(base, emit);
    }
    // A triangle that was given up may leave vertices in the FIFOs that nobody will ask for.
    if (sweep_line_.runaway()) strip_.flush();
}

// Fills the batch.
template <class P>
void SweepPipeline<P>::sweep(const SweepBase<P>& triangle) {
    fine_.size = 0;
    if constexpr (std::is_same_v<P, Fixed>) {
        run_count_ = sweep_line_.fill(runs_, fine_);
    } else {
        swept_.size = 0;
        run_count_ = sweep_line_.fill(runs_, swept_);
        add_vertices(triangle);
    }
}

template <class P>
void SweepPipeline<P>::add_vertices(const SweepBase<P>& triangle) {
    const auto data = [&](std::size_t corner) -> const Data& {
        return corners_[triangle.vertices[corner]].data;
    };
    for (std::size_t i = 0; i < swept_.size; ++i) {
        const VertexName& name = swept_.names[i];
        fine_.push_back(name, closed_form(triangle_, name, data(0), data(1), data(2)));
    }
}

// Vertices and triangles enter the triangle buffer in the places where they wait; it is emptied
// when it is full.
template <class P>
void SweepPipeline<P>::finish_vertices(const Emit& emit) {
    for (std::size_t done = 0; done < fine_.size;) {
        done += triangle_buffer_.push_vertices(
            fine_.size - done,
            [&](std::size_t i, SweepOutputVertex<P>& vertex) { vertex = fine_.output(done + i); });
        if (done < fine_.size) drain(emit);
    }
}

template <class P>
void SweepPipeline<P>::build_strips(uint32_t base, const Emit& emit) {
    made_.clear();
    auto number = triangle_buffer_.vertex_count() - static_cast<uint32_t>(fine_.size);
    strip_.run(
        {runs_.data(), run_count_}, [&number] { return number++; }, made_);
    for (std::size_t done = 0; done < made_.size();) {
        done +=
            triangle_buffer_.push(made_.size() - done, [&](std::size_t i, FineTriangle& triangle) {
                triangle = {base, made_[done + i]};
            });
        if (done < made_.size()) drain(emit);
    }
}

template <class P>
void SweepPipeline<P>::drain(const Emit& emit) {
    struct {
        const Emit& emit;
        void operator()(Span<const SweepOutputVertex<P>> vertices) const { emit(vertices, {}); }
        void operator()(Span<const FineTriangle> triangles) const { emit({}, triangles); }
    } sink{emit};
    triangle_buffer_.drain(sink);
}

template <class P>
bool SweepPipeline<P>::run(SweepMesh<P>& mesh) {
    return run([&mesh](auto vertices, auto triangles) {
        mesh.append(vertices);
        mesh.append(triangles);
    });
}

template <class P>
SweepCounters SweepPipeline<P>::counters() const {
    SweepCounters counters;
    counters.controller = controller_.counters();
    counters.vertex_transform = vertex_transform_.counters();
    counters.grid_transform = grid_transform_.counters();
    if (view_clip_) counters.view_clip = view_clip_->counters();
    counters.triangle_setup = triangle_setup_.counters();
    counters.sweep_line = sweep_line_.counters();
    counters.perspective = perspective_.counters();
    counters.normalise = perspective_.normalise_counters();
    if (footprint_) counters.footprint = footprint_->counters();
    counters.displace = displace_.counters();
    if (bump_) counters.bump = bump_->counters();
    if (shade_) counters.shade = shade_->counters();
    counters.strip = strip_.counters();
    counters.triangle_buffer = triangle_buffer_.counters();
    return counters;
}

template class SweepPipeline<Fixed>;
template class SweepPipeline<Real>;

}  // namespace repousse

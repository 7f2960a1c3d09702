#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "datapath/pipelines/sweep.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/mesh/mesh_check.h"
#include "testbench/reference/coverage.h"
#include "testbench/reference/fine_mesh.h"

namespace repousse::host {

/// What a remeshed object must have none of; a seam of the base mesh's texture excepted.
struct SweepInvariants {
    std::size_t open_edges = 0;    ///< fine half-edges without a partner, the base mesh's rim and
                                   ///< its non-manifold edges excepted
    std::size_t cracked = 0;       ///< vertices of one name in different places or colours
    std::size_t seam_cracked = 0;  ///< vertices on a seam whose copies lie in different places
    std::size_t degenerate = 0;    ///< fine triangles that are not positive on the grid
    std::size_t uncovered = 0;     ///< base triangles that are not covered exactly once

    bool hold() const { return open_edges + cracked + degenerate + uncovered == 0; }
};

/// Judges the output of a draw by the names of its vertices (Gumhold and Huettner's edge
/// constraint). The base mesh is welded first: copies of a vertex on a texture seam have one name.
/// Base triangles without output were clipped away, and their edges are a rim.
template <class P>
class SweepJudge {
public:
    SweepJudge(const Profile& profile, const SweepDraw<P>& draw, const Mesh& mesh)
        : draw_(draw),
          welded_(weld(mesh.positions)),
          transform_(profile),
          grid_(profile),
          setup_([&] {
              TriangleSetupOptions options = setup_options(profile, false);
              options.components = 0;
              return options;
          }()) {
        transform_.configure(draw.camera);
        GridRegisters<P> registers = draw.registers.grid;
        registers.table = draw.z_table;
        grid_.configure(registers);
        setup_.configure(draw.registers.setup);
    }

    SweepInvariants judge(const SweepMesh<P>& mesh) {
        mesh_ = &mesh;
        const reference::FineReport joined = judge_names(true);
        SweepInvariants result;
        result.open_edges = joined.open_edges - joined.rim_edges;
        result.cracked = judge_names(false).cracked;
        result.seam_cracked = joined.cracked - std::min(joined.cracked, result.cracked);
        for_each_base([&](Span<const FineTriangle> part) {
            const reference::CoverReport cover = judge_cover(part);
            result.degenerate += cover.not_positive;
            result.uncovered += !cover.exact();
        });
        return result;
    }

private:
    using V = typename P::Value;
    using Steps = std::array<int32_t, 3>;  // of each edge

    template <class Sink>
    void for_each_base(Sink&& sink) const {
        std::vector<FineTriangle> part;
        for (const FineTriangle& triangle : mesh_->triangles) {
            if (!part.empty() && part.front().base != triangle.base) {
                sink(Span<const FineTriangle>(part));
                part.clear();
            }
            part.push_back(triangle);
        }
        if (!part.empty()) sink(Span<const FineTriangle>(part));
    }

    /// Corner ids: as stored, or the same for all copies of a vertex.
    std::array<uint32_t, 3> ids(uint32_t base, bool joined) const {
        std::array<uint32_t, 3> ids = draw_.triangles[base].vertices;
        for (uint32_t& id : ids) id = joined ? welded_[id] : id;
        return ids;
    }

    /// Every step of an edge is there, or the edge is open: the last one tells the number.
    Steps steps_of(Span<const FineTriangle> triangles) const {
        Steps steps = {1, 1, 1};
        for (const FineTriangle& triangle : triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexName& name = mesh_->corner(triangle, k).name;
                if (name.kind != NameKind::Edge) continue;
                int32_t& most = steps[name.part];
                most = std::max(most, name.a + 1);
            }
        }
        return steps;
    }

    /// The step of an edge's point as counted from corner `part`.
    int32_t step_from_part(const VertexName& name, uint32_t base, const Steps& steps) const {
        const auto& stored = draw_.triangles[base].vertices;
        const bool forward = stored[name.part] < stored[(name.part + 1u) % 3];
        return forward ? name.a : steps[name.part] - name.a;
    }

    reference::FineReport judge_names(bool joined) {
        using reference::FineName;
        std::vector<std::array<uint32_t, 3>> base;
        for_each_base(
            [&](Span<const FineTriangle> part) { base.push_back(ids(part[0].base, joined)); });
        checker_.start(base);
        for_each_base([&](Span<const FineTriangle> part) {
            const uint32_t number = part[0].base;
            const std::array<uint32_t, 3> id = ids(number, joined);
            const Steps steps = steps_of(part);
            const auto name_of = [&](const VertexName& name) -> FineName {
                if (name.kind == NameKind::Corner) {
                    return {FineName::Kind::Vertex, id[name.part], 0, 0, 0};
                }
                if (name.kind == NameKind::Interior) {
                    return {FineName::Kind::Inside, number, 0, name.a, name.b};
                }
                const uint32_t from = id[name.part], to = id[(name.part + 1u) % 3];
                const int32_t step = step_from_part(name, number, steps);
                return {FineName::Kind::Edge, std::min(from, to), std::max(from, to),
                        from < to ? step : steps[name.part] - step, 0};
            };
            for (const FineTriangle& triangle : part) {
                std::array<FineName, 3> names;
                for (std::size_t k = 0; k < 3; ++k) {
                    const SweepOutputVertex<P>& corner = mesh_->corner(triangle, k);
                    names[k] = name_of(corner.name);
                    // Copies on a seam may have normals, and so colours, of their own.
                    const Colour<V> colour = joined ? Colour<V>{} : corner.colour;
                    checker_.add_vertex(names[k], digest(corner.displaced, colour));
                }
                checker_.add_triangle(names);
            }
            checker_.finish_base();
        });
        return checker_.finish();
    }

    static uint64_t digest(const Vec3<V>& place, const Colour<V>& colour) {
        reference::Digest digest;
        for (const V value : {place.x, place.y, place.z, colour.red, colour.green, colour.blue}) {
            uint64_t word = 0;
            std::memcpy(&word, &value, sizeof value);
            digest.add(word);
        }
        return digest.value();
    }

    /// The slots and the remeshing plane are the device's own; the cover is judged without it.
    reference::CoverReport judge_cover(Span<const FineTriangle> triangles) {
        using Kind = reference::CoverVertex::Kind;
        const uint32_t number = triangles[0].base;
        if (draw_.triangles[number].direct) return direct_cover(triangles.size());
        std::array<SweepCorner, 3> corners;
        reference::CoverBase base;
        for (std::size_t k = 0; k < 3; ++k) {
            const uint32_t vertex = draw_.triangles[number].vertices[k];
            corners[k].id = vertex;
            corners[k].slot =
                setup_.slot(grid_(transform_.eye(draw_.vertices[vertex].position)).position);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                base.corners[k][axis] = corners[k].slot[axis];
            }
        }
        setup_(corners, plane_);
        if (!plane_.single) {
            base.axis_a = plane_.sweep_axis;
            base.axis_b = plane_.side_axis;
        }
        const Steps steps = steps_of(triangles);
        cover_.start(base);
        for (const FineTriangle& triangle : triangles) {
            reference::CoverTriangle covering;
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexName& name = mesh_->corner(triangle, k).name;
                switch (name.kind) {
                    case NameKind::Corner:
                        covering[k] = {Kind::Corner, name.part, 0, 0};
                        break;
                    case NameKind::Edge:
                        covering[k] = {Kind::Edge, name.part, step_from_part(name, number, steps),
                                       0};
                        break;
                    case NameKind::Interior:
                        covering[k] = {Kind::Interior, 0, name.a, name.b};
                        break;
                }
            }
            cover_.add(covering);
        }
        return cover_.finish();
    }

    static reference::CoverReport direct_cover(std::size_t triangles) {
        reference::CoverReport report;
        report.triangles = triangles;
        report.area_differs = triangles != 1;
        return report;
    }

    const SweepDraw<P>& draw_;
    const SweepMesh<P>* mesh_ = nullptr;  // that is judged
    std::vector<uint32_t> welded_;
    VertexTransform<P> transform_;
    GridTransform<P> grid_;
    TriangleSetup setup_;
    SweepTriangle plane_;
    reference::FineMeshChecker checker_;
    reference::CoverageChecker cover_;
};

}  // namespace repousse::host

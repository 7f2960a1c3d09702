#pragma once

#include <array>
#include <cstdint>

#include "datapath/fine_vertices.h"
#include "datapath/map_view.h"
#include "datapath/numbers/cast.h"
#include "datapath/numbers/functions.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/sweep_items.h"
#include "datapath/transaction.h"
#include "datapath/units/footprint_desc.h"

namespace repousse {

/// What `footprint` counted: functions of the vertices alone.
struct FootprintCounters {
    uint64_t items = 0;
    std::array<uint64_t, kMostLevels + 1> levels{};  ///< vertices that read each level
    uint64_t back = 0;                               ///< vertices seen from the back
    uint64_t cut = 0;  ///< footprints above 2^finer texels of the last level: not covered
};

/// A vertex as it enters the unit: the input ports of the description.
template <class P>
struct FootprintIn {
    using V = typename P::Value;
    NameKind kind = NameKind::Corner;
    Vec3<V> p, n;
    Uv u;
    V c{};
    /// On an edge the first one alone counts; inside those of the sweep and the side.
    std::array<TexelStep<V>, 2> steps;

    std::array<Word, 16> pack() const {
        const auto& [a, b] = steps;
        return {static_cast<Word>(kind),
                p.x,
                p.y,
                p.z,
                n.x,
                n.y,
                n.z,
                u.x,
                u.y,
                c,
                a.u,
                a.v,
                a.c,
                b.u,
                b.v,
                b.c};
    }
    static FootprintIn unpack(const Word* w) {
        const auto value = [w](std::size_t i) { return static_cast<V>(w[i]); };
        FootprintIn in;
        in.kind = static_cast<NameKind>(w[0]);
        in.p = {value(1), value(2), value(3)};
        in.n = {value(4), value(5), value(6)};
        in.u = uv_from_words(w + 7);
        in.c = value(9);
        in.steps = {{{value(10), value(11), value(12)}, {value(13), value(14), value(15)}}};
        return in;
    }
};
static_assert(ports_are(kFootprintDesc, PortKind::Input,
                        {"kind", "p_x", "p_y", "p_z", "n_x", "n_y", "n_z", "u_x", "u_y", "c",
                         "step0_u", "step0_v", "step0_c", "step1_u", "step1_v", "step1_c"}));

/// The registers of the unit.
template <class P>
struct FootprintRegisters {
    int map_width = 1;  ///< texels
    int map_height = 1;
    int last_level = 0;
    int finer = 0;                ///< levels below that of the footprint, 0..kMostFiner
    Vec3<typename P::Value> eye;  ///< `position`

    std::array<Word, 7> pack() const {
        return {map_width, map_height, last_level, finer, eye.x, eye.y, eye.z};
    }
};
static_assert(ports_are(kFootprintDesc, PortKind::Config,
                        {"map_width", "map_height", "last_level", "finer", "eye_x", "eye_y",
                         "eye_z"}));

/// What leaves: a LevelRead as the output ports carry it.
inline std::array<Word, 4> pack(const LevelRead& read) {
    return {read.reach_x, read.reach_y, read.level, read.back};
}
static_assert(ports_are(kFootprintDesc, PortKind::Output, {"reach_x", "reach_y", "level", "back"}));

/// Filter level access (Gumhold and Huettner 4.1): which texels a new vertex stands for.
///
///  1. Half a step of the walk, in texels: U = (U c) / c, so a change D of (U c, c) moves U by
///     (D_U - U D_c) / c, and the footprint reaches half of that to either side. Inside a triangle
///     steps are those of the sweep and the side difference, on an edge the edge's own.
///  2. The footprint as a rectangle U +- reach: around the parallelogram of both half steps; on an
///     edge, which has one only, the square around it (the paper stretches it to a square).
///  3. level = ceil(log2 of the rectangle's longer side) - `finer`, at least 0, at most the last
///     one. With finer = 0 texels of that level are no smaller than the rectangle, so it touches
///     two by two of them at most, and those under its four corners are all. The parallelogram's
///     own corners would miss some of them. Texels of a finer level are no smaller than a
///     2^finer-th of the rectangle: `displace` looks at 2^finer + 1 places along each axis.
///  4. Reach is limited to one texel less than the map: more would not be within one period. A
///     footprint that is larger has a level of one texel there.
///  5. back = (P - eye) . N > 0, an exact sum.
///
/// The edge constraint: a corner's footprint is the vertex alone, level 0. An edge's steps are
/// those from its end with the lower id, rounded towards zero, whichever triangle asks. U, c, P and
/// N are the vertex's own. So both triangles at an edge read the same.
template <class P>
class Footprint {
public:
    using V = typename P::Value;

    explicit Footprint(const Profile& profile);

    void configure(const FootprintRegisters<P>& registers);

    LevelRead operator()(const FootprintIn<P>& in);

    /// The same for a vertex behind `perspective`, whose data had `c`: sets what it reads.
    void operator()(V c, const TexelSteps<V>& steps, FineVertex<P>& vertex);

    /// The same for vertices first .. first + count - 1 of a batch, all of one base triangle.
    void run(FineVertices<P>& batch, std::size_t first, std::size_t count,
             const TexelSteps<V>& steps);

    const FootprintCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    /// Half a step, each way, with the fraction bits of `uv`.
    struct Reach {
        int64_t x = 0, y = 0;
    };
    Reach half_step(const TexelStep<V>& step, Uv u, const typename P::Inverse& r);
    int64_t half_step(V step, int32_t u, V step_c, const typename P::Inverse& r);
    /// The steps that a vertex looks at.
    static std::array<TexelStep<V>, 2> steps_at(const VertexName& name,
                                                const TexelSteps<V>& steps) {
        if (name.kind == NameKind::Edge) return {steps.edges[name.part], {}};
        return {steps.sweep, steps.side};
    }
    int level_of(int64_t reach) const;

    int uv_frac_;
    Reciprocal reciprocal_;
    Cast to_data_, limit_data_;
    typename P::Quotient to_uv_;
    FootprintRegisters<P> registers_;
    int32_t most_x_ = 0, most_y_ = 0;  // of the reach
    FootprintCounters counters_;
};

}  // namespace repousse

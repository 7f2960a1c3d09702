#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/transaction.h"
#include "datapath/units/grid_transform_desc.h"
#include "datapath/units/vertex_transform.h"

namespace repousse {

/// How z_grid is looked up; values of the profile's `z_table_kind`.
enum class ZTableKind : uint8_t {
    Uniform,    ///< the paper's: linear pieces, uniform in w; reloaded with every camera
    Linear,     ///< leading zeros, then linear minimax pieces of log2 over an octave: a ROM
    Quadratic,  ///< leading zeros, then quadratic pieces
};

/// The registers of `grid_transform`. Fixed: raw values in the profile's formats. A new camera
/// changes the depth by two of them, steps_per_octave and log2_near; with the uniform table by
/// table_near, scale, shift and 2^z_table_index_bits + 1 words.
template <class P>
struct GridRegisters {
    using V = typename P::Value;
    V w_min{};    ///< clip, > 0: w is clamped to at least this
    V w_scale{};  ///< clip, >= w_min: c = w_scale / w, saturated at 1; the least w of the object
    V focal_x{};  ///< focal: grid units per unit of x/w; the grid's origin is the view's centre
    V focal_y{};  ///< focal
    V steps_per_octave{};  ///< K = ln 2 / ln(1 + 2 tan(a/2) / H), over the coarseness
    V log2_near{};         ///< s6.20: z_grid = K (log2(w) - log2_near)

    // ZTableKind::Uniform with Fixed only.
    V table_near{};            ///< clip: w at the table's first word
    uint32_t table_scale = 0;  ///< 2^19 .. 2^20 - 1
    uint8_t table_shift =
        0;  ///< place = (w - table_near) * table_scale >> table_shift, 16 fraction bits
    Span<const uint32_t> table;  ///< u14.8, non-decreasing: made by the host for this camera
};

/// A vertex on the grid.
template <class P>
struct GridPoint {
    std::array<int32_t, 3> position{};  ///< kGridFractionBits fraction bits
    typename P::Value c{};              ///< inverse_w
};

/// A vertex as it enters the unit's RTL, which has one lane of `scale`.
struct GridTransformIn {
    EyePoint<Fixed> eye;
    int32_t attribute = 0;

    std::array<Word, 4> pack() const { return {eye.x, eye.y, eye.w, attribute}; }
    static GridTransformIn unpack(const Word* w) {
        return {
            {static_cast<int32_t>(w[0]), static_cast<int32_t>(w[1]), static_cast<int32_t>(w[2])},
            static_cast<int32_t>(w[3])};
    }
};
static_assert(ports_are(kGridTransformDesc, PortKind::Input, {"x", "y", "w", "attribute"}));
static_assert(ports_are(kGridTransformDesc, PortKind::Config,
                        {"w_min", "w_scale", "focal_x", "focal_y", "steps_per_octave", "log2_near",
                         "table_near", "table_scale", "table_shift"}));

struct GridTransformOut {
    GridPoint<Fixed> point;
    int32_t data = 0;

    std::array<Word, 5> pack() const {
        return {point.position[0], point.position[1], point.position[2], point.c, data};
    }
};
static_assert(ports_are(kGridTransformDesc, PortKind::Output,
                        {"x_grid", "y_grid", "z_grid", "c", "data"}));

/// What `grid_transform` counted.
struct GridTransformCounters {
    uint64_t items = 0;
    uint64_t w_clamped = 0;        ///< vertices with w < w_min
    uint64_t ratio_saturated = 0;  ///< x/w or y/w left `ndc`
    uint64_t grid_saturated = 0;   ///< coordinates beyond s15.6
    uint64_t c_saturated = 0;      ///< vertices nearer than w_scale: c = 1
    uint64_t data_saturated = 0;   ///< components that left `sweep_data`
};

/// The vertex-grid transform lookup (Gumhold and Huettner 3.1, equations 2 to 4): where a base
/// vertex lies on the grid whose voxels are as deep as a pixel is wide at that depth.
///
///  1. w = max(w, w_min), counted: a vertex at or behind the eye goes somewhere, and to the same
///     place for every triangle that has it;
///  2. one reciprocal of w; x/w and y/w to `ndc`; c = w_scale / w (equations 5, 6 up to a factor,
///     which cancels in `perspective`) to `inverse_w`, at most 1;
///  3. x_grid, y_grid = focal * ndc, rounded half up;
///  4. z_grid = ln(w / near) / ln(1 + s) = K (log2(w) - log2(near)), s = 2 tan(a/2) / H the width
///     of a pixel at w = 1; log2 from a ROM by octaves, or z_grid from the paper's table. Monotone
///     in w in each of the three forms.
///
/// The grid steers subdivision only, and every coordinate is a function of the vertex alone: an
/// error or a clamp here shifts resolution and cracks nothing.
template <class P>
class GridTransform {
public:
    using V = typename P::Value;
    using Wide = typename P::Wide;

    explicit GridTransform(const Profile& profile);
    GridTransform(const GridTransform&) = delete;
    GridTransform& operator=(const GridTransform&) = delete;

    /// The table must stay alive; ZTableKind::Uniform needs 2^z_table_index_bits + 1 words.
    void configure(const GridRegisters<P>& registers) { registers_ = registers; }

    GridPoint<P> operator()(const EyePoint<P>& eye);

    /// Vertex data as the sweep line interpolates them: every component times c, and c itself as
    /// component kInverseWComponent. Without `tangents` the last four are 0. Fixed: `sweep_data`,
    /// c in `inverse_w`. Real: texture coordinates in texels.
    void scale(const Vertex<P>& vertex, V c, bool tangents, std::array<V, kSweepComponents>& data);

    /// One component of a position times c: the lane that the RTL has.
    V scale_position(V component, V c) { return scaled(position_data_, component, c); }

    const GridTransformCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    V scaled(const Cast& to_data, Wide component, V c);
    int32_t depth(V w);
    int32_t uniform_depth(V w);

    ZTableKind kind_;
    int index_bits_;
    int clip_frac_;
    int uv_frac_;
    Wide one_;  // in inverse_w
    Reciprocal reciprocal_;
    OctaveLog2 log2_;
    typename P::Quotient to_ndc_;
    typename P::Quotient to_c_;
    Cast pixels_to_grid_;
    Cast steps_to_grid_;
    Cast table_to_grid_;
    Cast position_data_;
    Cast normal_data_;
    Cast uv_data_;
    Cast sign_data_;
    GridRegisters<P> registers_;
    GridTransformCounters counters_;
};

}  // namespace repousse

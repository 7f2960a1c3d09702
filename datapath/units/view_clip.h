#pragma once

#include <array>
#include <cstdint>

#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/transaction.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/view_clip_desc.h"

namespace repousse {

/// The registers of `view_clip`: the view volume by planes of unit length. The host rounds them
/// outwards (testbench/host/clip_registers.h).
template <class P>
struct ClipRegisters {
    using V = typename P::Value;
    V near{};      ///< clip
    V far{};       ///< clip
    V cosine_x{};  ///< view_row: cos(a_x/2), a_x the horizontal view angle
    V sine_x{};    ///< view_row: sin(a_x/2)
    V cosine_y{};  ///< view_row
    V sine_y{};    ///< view_row
    V margin{};    ///< clip: what rounding before this unit may have moved a corner by
};

/// One triangle as it enters the unit: the input ports of the description.
struct ViewClipIn {
    std::array<EyePoint<Fixed>, 3> corners;
    int32_t max_displacement = 0;

    std::array<Word, 10> pack() const {
        const auto& [a, b, c] = corners;
        return {a.x, a.y, a.w, b.x, b.y, b.w, c.x, c.y, c.w, max_displacement};
    }
    static ViewClipIn unpack(const Word* w) {
        const auto v = [w](int i) { return static_cast<int32_t>(w[i]); };
        return {{{{v(0), v(1), v(2)}, {v(3), v(4), v(5)}, {v(6), v(7), v(8)}}}, v(9)};
    }
};
static_assert(ports_are(kViewClipDesc, PortKind::Input,
                        {"x1", "y1", "w1", "x2", "y2", "w2", "x3", "y3", "w3",
                         "max_displacement"}));
static_assert(ports_are(kViewClipDesc, PortKind::Config,
                        {"near_w", "far_w", "cosine_x", "sine_x", "cosine_y", "sine_y", "margin"}));
static_assert(ports_are(kViewClipDesc, PortKind::Output, {"reject", "outside"}));

/// The planes of the view volume, in the order of the bits of `outside`.
enum class ClipPlane : uint8_t { Left, Right, Bottom, Top, Near, Far };
inline constexpr std::size_t kClipPlanes = 6;

/// What `view_clip` counted.
struct ViewClipCounters {
    uint64_t items = 0;
    uint64_t rejected = 0;
    std::array<uint64_t, kClipPlanes> planes{};  ///< triangles beyond each; one may be in several
};

/// Conservative clipping to the extended view volume (Gumhold and Huettner 3.2, equations 7, 8):
/// a base triangle of which no displaced point can be visible is rejected before its setup.
///
/// A displaced point is p + D n with |D n| <= d_max, so it lies within d_max of the base triangle,
/// and beyond a plane if the whole triangle lies beyond it by more than d_max. A triangle is
/// rejected if that holds for one plane with all three corners; it is never cut, for a new edge
/// would have no neighbour to match.
///
///  1. reach = d_max, rounded up to `clip`, + margin;
///  2. distance of each corner beyond each plane, exact:
///       left  -x cos(a_x/2) - w sin(a_x/2)     right   x cos(a_x/2) - w sin(a_x/2)
///       bottom, top likewise with y            near    near - w          far   w - far
///  3. outside a plane: all three distances > reach;  reject: outside any. A corner with a
///     coordinate at an end of its format has been saturated: it is outside of nothing.
///
/// The paper tests on the screen: d_xy = d_max / cos(a_xy/2) (equation 7) scaled by 1/z of the
/// nearest corner, and z' limits (equation 8) with poles at d_max = near. Left and right here are
/// equation 7 times the cosine, before the division by z: no pole, no corner behind the eye is a
/// special case, and displacements beyond the near distance need none either.
///
/// Nothing is rounded but d_max, upwards. What was rounded before the unit: a corner, by half a
/// unit of `clip` a coordinate, moves its distance from a plane by at most
/// (cos + sin) / 2 <= 0.71 units; `margin` must be that at least. Planes turned outwards by their
/// rounding, of length <= 1, keep a displacement of d_max one of d_max at most.
template <class P>
class ViewClip {
public:
    using V = typename P::Value;

    explicit ViewClip(const Profile& profile);

    void configure(const ClipRegisters<P>& registers) { registers_ = registers; }

    /// True: reject. `max_displacement` >= 0 in the format `displacement`.
    bool operator()(const std::array<EyePoint<P>, 3>& corners, V max_displacement);

    /// The planes beyond which the displaced triangle lies, one bit each; counts nothing.
    unsigned outside(const std::array<EyePoint<P>, 3>& corners, V max_displacement) const;

    const ViewClipCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    using Wide = typename P::Wide;

    bool saturated(const EyePoint<P>& e) const;

    V least_, most_;  // ends of `clip`, where it saturates
    int rise_;        // fraction bits of `clip` above those of `displacement`
    int row_frac_;    // of view_row
    ClipRegisters<P> registers_;
    ViewClipCounters counters_;
};

}  // namespace repousse

#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"

namespace repousse {

/// The camera registers, double-buffered at frame boundaries. Fixed: raw values in the profile's
/// formats, named behind each; Real: plain numbers.
template <class P>
struct ViewRegisters {
    using V = typename P::Value;
    Vec3<V> eye;      ///< position
    Vec3<V> right;    ///< view_row, a unit vector
    Vec3<V> up;       ///< view_row
    Vec3<V> forward;  ///< view_row
    V near{};         ///< clip: points with w <= near have no screen position
    V focal_x{};      ///< focal: pixels per unit of x/w
    V focal_y{};      ///< focal: negative where rows run downwards
    V centre_x{};     ///< focal: the viewport's centre in pixels
    V centre_y{};
};

/// A point in eye space, in the format of `clip`: x to the right, y up, w along the view.
template <class P>
struct EyePoint {
    typename P::Value x{};
    typename P::Value y{};
    typename P::Value w{};
};

/// What `vertex_transform` counted.
struct VertexTransformCounters {
    uint64_t items = 0;
    uint64_t overflows = 0;  ///< eye space, x/w or the screen position left its format
    uint64_t behind = 0;     ///< vertices with w <= near
};

/// The Transform stage (Doggett and Hirche, figure 7): a displaced vertex to pixels.
///
///  1. e = P' - eye; x, y, w = right . e, up . e, forward . e, cast to `clip`;
///  2. near = w <= near register; the screen position of such a vertex is (0, 0);
///  3. x/w, y/w with one reciprocal, cast to `ndc`;
///  4. x_s = centre_x + focal_x x/w, likewise y, saturated to `screen`.
template <class P>
class VertexTransform {
public:
    using V = typename P::Value;

    explicit VertexTransform(const Profile& profile);
    VertexTransform(const VertexTransform&) = delete;
    VertexTransform& operator=(const VertexTransform&) = delete;

    void configure(const ViewRegisters<P>& view) { view_ = view; }

    ScreenPoint<V> operator()(const Vec3<V>& displaced);

    /// Step 1 alone, for vertices that go on to the grid instead of the screen. Counted as an item.
    EyePoint<P> eye(const Vec3<V>& position);

    /// Transforms the new vertex of every edge that is split.
    void run(Span<Edge<P>> edges);

    const VertexTransformCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    V clip_coordinate(const Vec3<V>& row, const Vec3<typename P::Wide>& e);

    int ndc_frac_;
    Cast to_clip_;
    Cast to_screen_;
    Reciprocal reciprocal_;
    typename P::Divide divide_;
    ViewRegisters<P> view_;
    VertexTransformCounters counters_;
};

}  // namespace repousse

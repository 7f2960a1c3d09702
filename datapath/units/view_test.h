#pragma once

#include <array>

#include "datapath/items.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/view_test_desc.h"

namespace repousse {

/// One edge as it enters the View Test: the input ports of the description.
struct ViewTestIn {
    bool skip = false;
    ScreenPoint<int32_t> p1, p2;

    std::array<Word, 7> pack() const { return {skip, p1.near, p1.x, p1.y, p2.near, p2.x, p2.y}; }
    static ViewTestIn unpack(const Word* w) {
        return {w[0] != 0,
                {static_cast<int32_t>(w[2]), static_cast<int32_t>(w[3]), w[1] != 0},
                {static_cast<int32_t>(w[5]), static_cast<int32_t>(w[6]), w[4] != 0}};
    }
};
static_assert(ports_are(kViewTestDesc, PortKind::Input,
                        {"skip", "near1", "x1", "y1", "near2", "x2", "y2"}));
static_assert(ports_are(kViewTestDesc, PortKind::Config, {"threshold"}));

/// What the View Test says of it.
struct ViewTestOut {
    bool vt = false;

    std::array<Word, 1> pack() const { return {vt}; }
};
static_assert(ports_are(kViewTestDesc, PortKind::Output, {"vt"}));

/// The View Test (Doggett and Hirche 2000, section 2.4): refinement stops where an edge is short
/// on the screen. The Euclidean length would take squares and a root, so it is the Manhattan one:
///
///     vt = near1 or near2 or |x1 - x2| + |y1 - y2| > threshold        (strictly greater).
///
/// The paper is silent on ends behind the viewer, whose screen position means nothing: such an
/// edge counts as long. Screen positions arrive saturated, so an edge that leaves the guard band
/// is measured up to the band's border. The decision is symmetric in the two ends.
///
/// P = Fixed: raw values of the profile's `screen`. P = Real: pixels.
template <class P>
class ViewTest {
public:
    using Point = ScreenPoint<typename P::Value>;

    explicit ViewTest(const Profile& profile);

    /// `threshold` >= 0 in the unit of the points; for Fixed a raw value with the fraction bits of
    /// `screen`, at most max_threshold().
    void configure(typename P::Wide threshold) { threshold_ = threshold; }

    /// The largest threshold that the unit's register holds, as a raw value.
    static int64_t max_threshold(const Profile& profile) {
        return (int64_t{2} << profile.screen.width) - 1;
    }

    bool operator()(const Point& p1, const Point& p2) const {
        return p1.near | p2.near |
               (absolute_difference(p1.x, p2.x) + absolute_difference(p1.y, p2.y) > threshold_);
    }

    /// One transaction of the unit: a skipped item passes with result 0.
    ViewTestOut operator()(const ViewTestIn& in) const;

    /// Tests each edge that is not yet decided (all of them if `eager`) and stores the result.
    void run(Span<Edge<P>> edges, bool eager) {
        counters_.items += edges.size();
        for (Edge<P>& edge : edges) {
            if (!edge.undecided && !eager) continue;
            edge.vt = (*this)(edge.v1->screen, edge.v2->screen);
            edge.undecided &= edge.vt;
            ++counters_.tests;
            counters_.positives += edge.vt;
        }
    }

    const TestCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    using Wide = typename P::Wide;

    /// |a - b|: the difference of two W-bit numbers takes W + 1 bits, its magnitude W unsigned.
    static Wide absolute_difference(Wide a, Wide b) { return a < b ? b - a : a - b; }

    Wide threshold_{};
    TestCounters counters_;
};

}  // namespace repousse

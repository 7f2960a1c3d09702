#include "datapath/units/view_test.h"

#include "datapath/numbers/policy.h"

namespace repousse {

// The arithmetic is exact: raw values of one format are compared with each other, so no entry of
// the profile is needed to evaluate the test, only to check a threshold (max_threshold).
template <class P>
ViewTest<P>::ViewTest(const Profile&) {}

template <class P>
ViewTestOut ViewTest<P>::operator()(const ViewTestIn& in) const {
    const Point p1{static_cast<typename P::Value>(in.p1.x), static_cast<typename P::Value>(in.p1.y),
                   in.p1.near};
    const Point p2{static_cast<typename P::Value>(in.p2.x), static_cast<typename P::Value>(in.p2.y),
                   in.p2.near};
    return {!in.skip && (*this)(p1, p2)};
}

template class ViewTest<Fixed>;
template class ViewTest<Real>;

}  // namespace repousse

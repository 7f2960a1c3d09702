#pragma once

#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/units/normalise_desc.h"

namespace repousse {

/// What `normalise` counted.
struct NormaliseCounters {
    uint64_t items = 0;
    uint64_t degenerate = 0;  ///< zero vectors, which have no direction and stay zero
};

/// The normalisation of interpolated normals and tangents. Equation 1 of Gumhold and Huettner wants
/// n normalised after interpolation: the interpolated vector is shorter than its ends.
///
/// Kind 0 of `normalise_kind`, the inverse square root:
///  1. q = x^2 + y^2 + z^2, exact;
///  2. 1/sqrt(q) by table and Newton steps;
///  3. three products, cast to `normal`.
/// Kind 1, CORDIC: turns by arctangents of powers of two (datapath/numbers/cordic.h), cast to
/// `normal`.
///
/// `mid_vertex`, `bump` and `perspective` all normalise by one of these.
template <class P>
class Normalise {
public:
    using V = typename P::Value;

    explicit Normalise(const Profile& profile) : Normalise(profile, profile.normal) {}

    /// With another format of the result.
    Normalise(const Profile& profile, const Format& to);

    /// A vector in the format `unnormalised`, over its length.
    Vec3<V> operator()(const Vec3<V>& v) {
        ++counters_.items;
        return normalise_(v, counters_.degenerate);
    }

    /// A batch of n <= kFunctionBatch vectors, one array a component; `to` is not `from`.
    void operator()(const typename P::Columns& vectors, std::size_t n) {
        counters_.items += n;
        normalise_(vectors, n, counters_.degenerate);
    }

    /// The same inside another unit, which counts its zero vectors itself.
    Vec3<V> operator()(const Vec3<V>& v, uint64_t& degenerate) const {
        return normalise_(v, degenerate);
    }
    void operator()(const typename P::Columns& vectors, std::size_t n, uint64_t& degenerate) const {
        normalise_(vectors, n, degenerate);
    }

    const NormaliseCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    typename P::Normalise normalise_;
    NormaliseCounters counters_;
};

}  // namespace repousse

#pragma once

#include <array>
#include <cstdint>

#include "datapath/fine_vertices.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/sweep_items.h"
#include "datapath/transaction.h"
#include "datapath/units/normalise.h"
#include "datapath/units/perspective_desc.h"

namespace repousse {

/// What `perspective` counted.
struct PerspectiveCounters {
    uint64_t items = 0;
    uint64_t overflows = 0;  ///< a component left its format
    uint64_t clamped = 0;    ///< c <= 0, by rounding of a tiny one: taken as its LSB
};

/// A vertex before normalisation: the output ports of the description.
template <class P>
struct CorrectedVertex {
    using V = typename P::Value;
    Vec3<V> position;
    Vec3<V> normal;  ///< unnormalised
    Uv uv;
    Vec3<V> tangent;  ///< unnormalised; zero without tangents
    bool left_handed = false;
    bool clamped = false;

    std::array<Word, 13> pack() const {
        return {Word(position.x),
                Word(position.y),
                Word(position.z),
                Word(normal.x),
                Word(normal.y),
                Word(normal.z),
                uv.x,
                uv.y,
                Word(tangent.x),
                Word(tangent.y),
                Word(tangent.z),
                left_handed,
                clamped};
    }
};
static_assert(ports_are(kPerspectiveDesc, PortKind::Input,
                        {"x_c", "y_c", "z_c", "nx_c", "ny_c", "nz_c", "uv_x_c", "uv_y_c", "c",
                         "tx_c", "ty_c", "tz_c", "handedness_c"}));
static_assert(ports_are(kPerspectiveDesc, PortKind::Config, {"tangents"}));
static_assert(ports_are(kPerspectiveDesc, PortKind::Output,
                        {"x", "y", "z", "nx", "ny", "nz", "uv_x", "uv_y", "tx", "ty", "tz",
                         "left_handed", "clamped"}));

/// Perspective correction (Gumhold and Huettner 3.1): what was interpolated in the grid is v * c
/// with c = w_scale / w, which is affine in the grid's depth; v = (v * c) / c.
///
///  1. c <= 0, which only rounding can make of a tiny one, is taken as the least positive value;
///  2. r = 1/c, one reciprocal;
///  3. one product a component, cast to `position`, `unnormalised` and `uv`. All casts of this unit
///     round half up and saturate, also where the format has other modes: that of `uv` floors,
///     which would move a corner of the base mesh by a unit;
///  4. normal and tangent are normalised (equation 1) by `normalise`, a unit of its own.
///
/// A function of the vertex's bits alone, so equal vertices stay equal. The constant w_scale
/// cancels.
template <class P>
class Perspective {
public:
    using V = typename P::Value;
    using Data = std::array<V, kSweepComponents>;

    explicit Perspective(const Profile& profile);

    /// Whether vertices carry components 9 to 12, which a profile of 13 `components` has only.
    void configure(bool tangents) { tangents_ = tangents && has_tangents_; }

    /// A SweepVertex, or another struct of `name` and `data`. Sets all but what displace and bump
    /// add. With Real, data are plain numbers: world units, texels.
    template <class Vertex>
    void operator()(const Vertex& vertex, FineVertex<P>& out) {
        (*this)(vertex.data, vertex.name, out);
    }
    void operator()(const Data& data, const VertexName& name, FineVertex<P>& out);

    /// A batch of vertices that have name and data: adds what perspective and normalisation make.
    void run(FineVertices<P>& batch);

    /// Steps 1 to 3.
    CorrectedVertex<P> correct(const Data& data);

    const PerspectiveCounters& counters() const { return counters_; }
    const NormaliseCounters& normalise_counters() const { return normalise_.counters(); }
    void reset() { counters_ = {}, normalise_.reset(); }

private:
    int uv_frac_;
    bool has_tangents_;
    bool tangents_ = false;
    Reciprocal reciprocal_;
    typename P::Quotient to_position_, to_unnormalised_, to_uv_;
    Normalise<P> normalise_;
    FineVectors<V> unnormalised_;  // of the batch
    PerspectiveCounters counters_;
};

}  // namespace repousse

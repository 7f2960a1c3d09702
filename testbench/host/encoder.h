#pragma once

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "datapath/error.h"
#include "datapath/pipelines/draw.h"
#include "datapath/profile.h"
#include "testbench/host/draw.h"

namespace repousse::host {

/// Brings doubles into a profile's formats and remembers the first one that does not fit. With
/// Real they stay what they are.
template <class P>
class Encoder {
public:
    using V = typename P::Value;

    explicit Encoder(const Profile& profile) : profile_(profile) {}

    /// Rounded half up; 0 if it does not fit. `what` names it in the message.
    V value(double x, Format Profile::*member, const char* what) {
        if constexpr (std::is_same_v<P, Real>) return x;
        const Format& format = profile_.*member;
        const double scaled = std::floor(std::ldexp(x, format.frac) + 0.5);
        const bool fits = scaled >= static_cast<double>(format.min_raw()) &&
                          scaled <= static_cast<double>(format.max_raw());
        if (!fits) {
            refuse(std::string(what) + " " + std::to_string(x) + " does not fit " +
                   to_string(format));
        }
        return fits ? static_cast<V>(scaled) : V{};
    }

    Vec3<V> vector(const glm::dvec3& v, Format Profile::*member, const char* what) {
        return {value(v.x, member, what), value(v.y, member, what), value(v.z, member, what)};
    }

    void refuse(std::string what) {
        if (what_.empty()) what_ = std::move(what);
    }

    /// The first value that did not fit, as an error.
    Status status() const {
        if (what_.empty()) return done();
        return Error{ErrorKind::Input, {}, what_, {}, "scale the scene or choose a wider profile"};
    }

    /// The base mesh's vertices: uv, position, normal, tangent and handedness.
    std::vector<Vertex<P>> vertices(const DrawInputs& inputs);

    /// The displacement map's registers and heights, with filter levels if there are any, and its
    /// table for bump if it is wanted.
    void map(const DrawInputs& inputs, bool with_bump, MapView<P>& map, MapTables<P>& tables);

    ViewRegisters<P> camera(const ViewFrame& view);

private:
    // The table and registers of the profile's kind of bump: encoder_bump.cpp.
    void bump(const DrawInputs& inputs, MapView<P>& view, MapTables<P>& tables);
    SlopeScale<P> slope_scale(const HeightMap& map, double texel_size);

    const Profile& profile_;
    std::string what_;
};

}  // namespace repousse::host

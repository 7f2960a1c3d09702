#pragma once

#include <array>
#include <cstdint>

#include "datapath/fine_vertices.h"
#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/numbers/power.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/units/normalise.h"

namespace repousse {

/// Registers for lights that the unit can have; the profile's `lights` says how many it has.
inline constexpr int kMaxLights = 8;

/// A directional light on one material.
template <class P>
struct Light {
    using V = typename P::Value;
    Vec3<V> direction;   ///< towards the light, unit length, format `normal`
    Colour<V> diffuse;   ///< the light's colour times the material's, format `light`
    Colour<V> specular;  ///< the same for the highlight
};

/// The registers of `shade`. A light that is not wanted has no colours.
template <class P>
struct ShadeRegisters {
    using V = typename P::Value;
    Vec3<V> eye;             ///< format `position`
    Colour<V> ambient;       ///< format `light`
    int shininess = 1;       ///< n, 1 to 255
    bool two_sided = false;  ///< seen from the back, N points to the viewer instead
    std::array<Light<P>, kMaxLights> lights;
};

/// What `shade` counted.
struct ShadeCounters {
    uint64_t items = 0;       ///< vertices coloured
    uint64_t saturated = 0;   ///< components of colours brighter than their format holds
    uint64_t degenerate = 0;  ///< vertices at the eye itself: no highlights
};

/// Phong's illumination at a displaced vertex (Phong 1975), behind `bump`, or behind `displace`
/// with the interpolated normal:
///
///  1. V = (eye - P') / |eye - P'|, the difference exact, scaled by a power of two;
///  2. a = N.V, q = N.N, and for each light i b = N.L_i and c = L_i.V, cast to `cosine`; if
///     two_sided and a < 0, a and all b change their signs; a' = a (2 - q), cast to `cosine`;
///  3. r = R_i.V = 2 a' b - c, cast to `cosine`: R_i = 2 (N.L_i) N - L_i has unit length because N
///     and L_i have, so no light needs a normalisation of its own. N is rounded, so its length is
///     one only to an LSB, which the power would multiply by 2 n; 2 - q is 1/q but for the square
///     of that;
///  4. s = r^n (datapath/numbers/power.h), cast to `cosine`; 0 where r <= 0;
///  5. colour = ambient + sum of D_i b + S_i s over the lights with b > 0, exact, cast to `colour`.
///
/// A normal without direction is zero: all b are, and the ambient light is left.
template <class P>
class Shade {
public:
    using V = typename P::Value;

    explicit Shade(const Profile& profile);

    /// Sets the registers. Lights beyond the profile's are not used. `bumped`: vertices have N'.
    void configure(const ShadeRegisters<P>& registers, bool bumped = false);

    /// Step 1, in the format `normal`; zero at the eye.
    Vec3<V> view_vector(const Vec3<V>& displaced);

    /// Steps 2 to 5 for a normal and a view vector, both of unit length in the format `normal`.
    Colour<V> illuminate(const Vec3<V>& normal, const Vec3<V>& view);

    /// The colour of a vertex: P' in `position` and N in the format `normal`.
    Colour<V> operator()(const Vec3<V>& displaced, const Vec3<V>& normal) {
        return illuminate(normal, view_vector(displaced));
    }

    /// N' of `bump` in the format `normal`, which has as many fraction bits or more: exact.
    Vec3<V> widened(const Vec3<V>& displaced_normal) const;

    /// Colours a vertex that has P' and N' or, without `bump`, N.
    void operator()(Vertex<P>& vertex);

    /// Colours the new vertices of the edges that are split.
    void run(Span<Edge<P>> edges);

    /// Colours the vertices of the fine mesh.
    void run(FineVertices<P>& batch);

    const ShadeCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    V dot(const Vec3<V>& a, const Vec3<V>& b);
    /// a' of step 2.
    V corrected(typename P::Wide a, typename P::Wide q);

    int lights_;   // that the unit has
    int lit_ = 0;  // of these, up to the last one that has a colour: the others add nothing
    bool bumped_ = false;
    int view_bits_;  // of a vector before its normalisation
    int widening_;   // fraction bits from displaced_normal to normal
    int cosine_frac_;
    Cast to_cosine_;     // from products of `normal`
    Cast to_reflected_;  // from products of `cosine`
    Cast to_colour_;     // from products of `light` and `cosine`
    Normalise<P> normalise_;
    typename P::CosinePower power_;
    ShadeRegisters<P> registers_;
    ShadeCounters counters_;
};

}  // namespace repousse

#include "datapath/units/shade.h"

#include <cstddef>

namespace repousse {

template <class P>
Shade<P>::Shade(const Profile& profile)
    : lights_(profile.lights),
      view_bits_(profile.unnormalised.width),
      widening_(profile.normal.frac - profile.displaced_normal.frac),
      cosine_frac_(profile.cosine.frac),
      to_cosine_(2 * profile.normal.frac, profile.cosine),
      to_reflected_(2 * profile.cosine.frac, profile.cosine),
      to_colour_(profile.light.frac + profile.cosine.frac, profile.colour),
      normalise_(profile, profile.normal),
      power_(Power(profile.power_log_index_bits, profile.power_exp_index_bits), profile.cosine.frac,
             profile.cosine) {}

template <class P>
void Shade<P>::configure(const ShadeRegisters<P>& registers, bool bumped) {
    registers_ = registers;
    bumped_ = bumped;
    lit_ = 0;
    for (int i = 0; i < lights_; ++i) {
        const Light<P>& light = registers_.lights[static_cast<std::size_t>(i)];
        if (!(light.diffuse == Colour<V>{} && light.specular == Colour<V>{})) lit_ = i + 1;
    }
}

// Positions of 32 bits differ by 33; `scaled` leaves no more than a normalisation may have.
template <class P>
Vec3<typename P::Value> Shade<P>::view_vector(const Vec3<V>& displaced) {
    using Wide = typename P::Wide;
    const Vec3<V>& eye = registers_.eye;
    return normalise_(P::scaled({Wide(eye.x) - Wide(displaced.x), Wide(eye.y) - Wide(displaced.y),
                                 Wide(eye.z) - Wide(displaced.z)},
                                view_bits_),
                      counters_.degenerate);
}

template <class P>
Vec3<typename P::Value> Shade<P>::widened(const Vec3<V>& n) const {
    const auto wide = [this](V x) { return static_cast<V>(P::align(x, widening_)); };
    return {wide(n.x), wide(n.y), wide(n.z)};
}

// Three products of 20 x 20 bits at most. Vectors of unit length give one and its rounding, which
// the cast's integer bit takes; longer ones saturate, and are no event.
template <class P>
typename P::Value Shade<P>::dot(const Vec3<V>& a, const Vec3<V>& b) {
    uint64_t saturated = 0;
    return P::quantize(to_cosine_, P::mul(a.x, b.x) + P::mul(a.y, b.y) + P::mul(a.z, b.z),
                       saturated);
}

template <class P>
typename P::Value Shade<P>::corrected(typename P::Wide a, typename P::Wide q) {
    uint64_t saturated = 0;
    return P::quantize(to_reflected_, P::mul(a, P::align(P::exact(2, 0), cosine_frac_) - q),
                       saturated);
}

// Products of 22 x 23 bits, and of a light's 20 bits with 22: sixteen of these and the ambient
// light need five bits more, 48 in all.
template <class P>
Colour<typename P::Value> Shade<P>::illuminate(const Vec3<V>& normal, const Vec3<V>& view) {
    using Wide = typename P::Wide;
    ++counters_.items;
    Wide a = dot(normal, view);
    const bool turned = registers_.two_sided && a < 0;
    a = corrected(turned ? -a : a, dot(normal, normal));
    const auto ambient = [this](V x) { return P::align(x, cosine_frac_); };
    Wide red = ambient(registers_.ambient.red);
    Wide green = ambient(registers_.ambient.green);
    Wide blue = ambient(registers_.ambient.blue);
    for (int i = 0; i < lit_; ++i) {
        const Light<P>& light = registers_.lights[static_cast<std::size_t>(i)];
        Wide b = dot(normal, light.direction);
        b = turned ? -b : b;
        const V c = dot(light.direction, view);
        uint64_t saturated = 0;  // R.V is one at most, but for rounding
        const V r =
            P::quantize(to_reflected_, 2 * P::mul(a, b) - P::align(c, cosine_frac_), saturated);
        const Wide lit = b > 0 ? b : Wide(0);
        const Wide gleam = b > 0 ? Wide(power_(r, registers_.shininess)) : Wide(0);
        red += P::mul(light.diffuse.red, lit) + P::mul(light.specular.red, gleam);
        green += P::mul(light.diffuse.green, lit) + P::mul(light.specular.green, gleam);
        blue += P::mul(light.diffuse.blue, lit) + P::mul(light.specular.blue, gleam);
    }
    return {P::quantize(to_colour_, red, counters_.saturated),
            P::quantize(to_colour_, green, counters_.saturated),
            P::quantize(to_colour_, blue, counters_.saturated)};
}

template <class P>
void Shade<P>::operator()(Vertex<P>& v) {
    v.colour = (*this)(v.displaced, bumped_ ? widened(v.displaced_normal) : v.normal);
}

template <class P>
void Shade<P>::run(Span<Edge<P>> edges) {
    for (Edge<P>& edge : edges) {
        if (edge.split) (*this)(edge.mid);
    }
}

template <class P>
void Shade<P>::run(FineVertices<P>& batch) {
    for (std::size_t i = 0; i < batch.size; ++i) {
        const Vec3<V> normal = bumped_ ? widened(batch.displaced_normal[i]) : batch.normal[i];
        const Colour<V> colour = (*this)(batch.displaced[i], normal);
        batch.red[i] = colour.red;
        batch.green[i] = colour.green;
        batch.blue[i] = colour.blue;
    }
}

template class Shade<Fixed>;
template class Shade<Real>;

}  // namespace repousse

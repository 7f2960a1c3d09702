#include "testbench/host/shade_registers.h"

#include <cmath>
#include <string>
#include <type_traits>

#include <glm/common.hpp>

#include "testbench/host/encoder.h"
#include "testbench/host/view/shading.h"

namespace repousse::host {
namespace {

template <class P>
Colour<typename P::Value> encoded(Encoder<P>& encode, const glm::dvec3& c,
                                  const std::string& what) {
    const auto component = [&](double x) { return encode.value(x, &Profile::light, what.c_str()); };
    return {component(c.x), component(c.y), component(c.z)};
}

}  // namespace

template <class P>
Result<ShadeRegisters<P>> make_shade_registers(const Profile& profile, const DrawInputs& inputs) {
    const Material& material = *inputs.shade;
    const std::string where = material.mark.text();
    if (inputs.lights.size() > static_cast<std::size_t>(profile.lights)) {
        return Error{ErrorKind::Input, where,
                     "the scene has " + std::to_string(inputs.lights.size()) +
                         " lights, and the unit `shade` of the profile has " +
                         std::to_string(profile.lights),
                     "at most as many",
                     "leave out lights or choose a profile with a larger `lights`"};
    }
    Encoder<P> encode(profile);
    ShadeRegisters<P> r;
    r.eye = encode.vector(inputs.view.eye, &Profile::position, "camera position");
    r.ambient = encoded(encode, to_linear(material.ambient), "the ambient colour");
    r.shininess = material.shininess;
    r.two_sided = material.two_sided;
    for (std::size_t i = 0; i < inputs.lights.size(); ++i) {
        const std::string light = "light " + std::to_string(i + 1) + " times the ";
        const glm::dvec3 colour = to_linear(inputs.lights[i].colour);
        r.lights[i].direction =
            encode.vector(inputs.lights[i].direction, &Profile::normal, "direction of a light");
        r.lights[i].diffuse =
            encoded(encode, colour * to_linear(material.diffuse), light + "diffuse colour");
        r.lights[i].specular =
            encoded(encode, colour * to_linear(material.specular), light + "specular colour");
    }
    const Status fits = encode.status();
    if (fits) return r;
    Error error = fits.error();
    error.where = where;
    return error;
}

template <class P>
glm::dvec3 linear_light(const Colour<typename P::Value>& c, const Profile& profile) {
    const int frac = std::is_same_v<P, Real> ? 0 : profile.colour.frac;
    const auto component = [frac](typename P::Value x) { return std::ldexp(double(x), -frac); };
    return glm::min(glm::dvec3(component(c.red), component(c.green), component(c.blue)), 1.0);
}

template Result<ShadeRegisters<Fixed>> make_shade_registers(const Profile&, const DrawInputs&);
template Result<ShadeRegisters<Real>> make_shade_registers(const Profile&, const DrawInputs&);
template glm::dvec3 linear_light<Fixed>(const Colour<int32_t>&, const Profile&);
template glm::dvec3 linear_light<Real>(const Colour<double>&, const Profile&);

}  // namespace repousse::host

#include "datapath/units/normalise.h"

namespace repousse {

template <class P>
Normalise<P>::Normalise(const Profile& profile, const Format& to)
    : normalise_(static_cast<NormaliseKind>(profile.normalise_kind),
                 InverseSqrt(profile.inverse_sqrt_index_bits, profile.inverse_sqrt_newton_steps,
                             profile.inverse_sqrt_bits),
                 to) {}

template class Normalise<Fixed>;
template class Normalise<Real>;

}  // namespace repousse

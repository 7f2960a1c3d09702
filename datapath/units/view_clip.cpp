#include "datapath/units/view_clip.h"

namespace repousse {

template <class P>
ViewClip<P>::ViewClip(const Profile& profile)
    : least_(V(-P::limit(profile.clip))),
      most_(V(P::limit(profile.clip))),
      rise_(profile.clip.frac - profile.displacement.frac),
      row_frac_(profile.view_row.frac) {}

template <class P>
bool ViewClip<P>::saturated(const EyePoint<P>& e) const {
    const auto at_end = [this](V v) { return (v <= least_) | (v >= most_); };
    return at_end(e.x) | at_end(e.y) | at_end(e.w);
}

template <class P>
unsigned ViewClip<P>::outside(const std::array<EyePoint<P>, 3>& corners, V max_displacement) const {
    const ClipRegisters<P>& r = registers_;
    // align() floors where bits are dropped, so the negative of the negative rounds upwards. 32
    // bits, or more where `clip` has the finer LSB: check_growth sees to 63 for what follows.
    const Wide reach = -P::align(-Wide(max_displacement), rise_) + r.margin;
    const Wide side_reach = P::align(reach, row_frac_);

    unsigned all = (1U << kClipPlanes) - 1;
    for (const EyePoint<P>& e : corners) {
        if (saturated(e)) return 0;
        // Products of 32 and 24 bits, two of them: 57 bits.
        const Wide x = P::mul(e.x, r.cosine_x);
        const Wide y = P::mul(e.y, r.cosine_y);
        const Wide wx = P::mul(e.w, r.sine_x);
        const Wide wy = P::mul(e.w, r.sine_y);
        const bool beyond[kClipPlanes] = {-x - wx > side_reach,       x - wx > side_reach,
                                          -y - wy > side_reach,       y - wy > side_reach,
                                          Wide(r.near) - e.w > reach, Wide(e.w) - r.far > reach};
        unsigned planes = 0;
        for (unsigned k = 0; k < kClipPlanes; ++k) planes |= unsigned(beyond[k]) << k;
        all &= planes;
    }
    return all;
}

template <class P>
bool ViewClip<P>::operator()(const std::array<EyePoint<P>, 3>& corners, V max_displacement) {
    const unsigned planes = outside(corners, max_displacement);
    ++counters_.items;
    counters_.rejected += planes != 0;
    for (unsigned k = 0; k < kClipPlanes; ++k) counters_.planes[k] += planes >> k & 1;
    return planes != 0;
}

template class ViewClip<Fixed>;
template class ViewClip<Real>;

}  // namespace repousse

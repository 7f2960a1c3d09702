#include "datapath/units/footprint.h"

namespace repousse {

// Half a step is a step with one more fraction bit.
template <class P>
Footprint<P>::Footprint(const Profile& profile)
    : uv_frac_(profile.uv.frac),
      reciprocal_(profile.reciprocal_index_bits, profile.reciprocal_newton_steps,
                  profile.reciprocal_bits),
      to_data_(profile.uv.frac + profile.inverse_w.frac, profile.sweep_data),
      limit_data_(profile.sweep_data.frac, profile.sweep_data),
      to_uv_(profile.sweep_data.frac + 1, profile.inverse_w.frac, profile.uv) {}

template <class P>
void Footprint<P>::configure(const FootprintRegisters<P>& registers) {
    registers_ = registers;
    most_x_ = (registers.map_width - 1) << uv_frac_;
    most_y_ = (registers.map_height - 1) << uv_frac_;
}

// U * D_c has 31 + 32 bits at most. It is cast to the format of D_U, and so is the difference.
template <class P>
int64_t Footprint<P>::half_step(V step, int32_t u, V step_c, const typename P::Inverse& r) {
    uint64_t saturated = 0;  // as good as any other footprint of the whole map
    const V turned = P::quantize(to_data_, P::mul(P::exact(u, uv_frac_), step_c), saturated);
    const V change = P::quantize(limit_data_, typename P::Wide(step) - turned, saturated);
    const int64_t half = P::raw(to_uv_(change, r, saturated), uv_frac_);
    return half < 0 ? -half : half;
}

template <class P>
typename Footprint<P>::Reach Footprint<P>::half_step(const TexelStep<V>& step, Uv u,
                                                     const typename P::Inverse& r) {
    return {half_step(step.u, u.x, step.c, r), half_step(step.v, u.y, step.c, r)};
}

// The least level whose texels are not smaller than 2 * reach: ceil(log2(2 * reach)) is the number
// of bits of 2 * reach - 1 above the fraction.
template <class P>
int Footprint<P>::level_of(int64_t reach) const {
    const int64_t whole = (2 * reach - 1) >> uv_frac_;
    return whole > 0 ? 64 - __builtin_clzll(static_cast<uint64_t>(whole)) : 0;
}

template <class P>
LevelRead Footprint<P>::operator()(const FootprintIn<P>& in) {
    using Wide = typename P::Wide;
    ++counters_.items;
    LevelRead read;
    if (in.kind != NameKind::Corner) {
        const auto r = P::invert(reciprocal_, in.c > 0 ? in.c : V{1});
        Reach reach = half_step(in.steps[0], in.u, r);
        if (in.kind == NameKind::Edge) {
            reach.x = reach.y = reach.x > reach.y ? reach.x : reach.y;
        } else {
            const Reach side = half_step(in.steps[1], in.u, r);
            reach.x += side.x;
            reach.y += side.y;
        }
        const int coarse = level_of(reach.x > reach.y ? reach.x : reach.y);
        const int level = coarse > registers_.finer ? coarse - registers_.finer : 0;
        counters_.cut += level > registers_.last_level;
        read.level =
            static_cast<uint8_t>(level < registers_.last_level ? level : registers_.last_level);
        read.reach_x = static_cast<int32_t>(reach.x < most_x_ ? reach.x : most_x_);
        read.reach_y = static_cast<int32_t>(reach.y < most_y_ ? reach.y : most_y_);
    }
    // 33-bit differences times 20-bit components, three of them: 55 bits.
    const Vec3<V>&eye = registers_.eye, &p = in.p, &n = in.n;
    const Wide along = P::mul(Wide(p.x) - eye.x, n.x) + P::mul(Wide(p.y) - eye.y, n.y) +
                       P::mul(Wide(p.z) - eye.z, n.z);
    read.back = along > 0;
    ++counters_.levels[read.level];
    counters_.back += read.back;
    return read;
}

template <class P>
void Footprint<P>::operator()(V c, const TexelSteps<V>& steps, FineVertex<P>& vertex) {
    vertex.read = (*this)({vertex.name.kind, vertex.position, vertex.normal, vertex.uv, c,
                           steps_at(vertex.name, steps)});
}

template <class P>
void Footprint<P>::run(FineVertices<P>& batch, std::size_t first, std::size_t count,
                       const TexelSteps<V>& steps) {
    for (std::size_t i = first; i < first + count; ++i) {
        const VertexName& name = batch.names[i];
        batch.reads[i] = (*this)({name.kind, batch.position[i], batch.normal[i], batch.uv(i),
                                  batch.data[kInverseWComponent][i], steps_at(name, steps)});
    }
}

template class Footprint<Fixed>;
template class Footprint<Real>;

}  // namespace repousse

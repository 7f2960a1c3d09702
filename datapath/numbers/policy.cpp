// The batches of policy Fixed: the arithmetic of the single values in loops that vectorise.
//
// Values nearly never leave their formats. So a loop only looks whether one of them has, without a
// clamp or a count; then the batch is made once more, value by value.

#include "datapath/numbers/policy.h"

#include <cassert>

namespace repousse {
namespace {

using Value = Fixed::Value;
using Wide = Fixed::Wide;

/// A shift for each value of a batch.
struct Shifts {
    uint64_t right[kFunctionBatch];
    uint64_t bias[kFunctionBatch];  // Shift::below is bias >> right: half a unit leaves nothing
};

/// to[i] = from[i] * mantissas[i], shifted and rounded. True if all lie within low .. high.
REPOUSSE_VECTOR_CLONES
bool shifted_products(const Value* from, const int32_t* mantissas, const Shifts& shifts,
                      std::size_t n, Wide low, Wide high, Value* to) {
    Wide outside = 0;  // negative if any value is
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const auto product = static_cast<uint64_t>(Wide{from[i]} * mantissas[i]);
        const auto wanted = static_cast<Wide>(((product + shifts.bias[i]) >> shifts.right[i]) -
                                              (shifts.bias[i] >> shifts.right[i]));
        outside |= (wanted - low) | (high - wanted);
        to[i] = static_cast<Value>(wanted);
    }
    return outside >= 0;
}

/// Shifts to the right by exponents[i] + more. True if none of them is one to the left.
REPOUSSE_VECTOR_CLONES
bool set_shifts(const int32_t* exponents, int more, std::size_t n, Shifts& shifts) {
    int32_t any_left = 0;  // negative if any is
    // g++ vectorises a shift of what lies in memory, but none of a constant.
    for (std::size_t i = 0; i < n; ++i) {
        const int32_t wanted = exponents[i] + more;
        any_left |= wanted;
        const int32_t right = wanted < 0 ? 0 : wanted;
        shifts.right[i] = static_cast<uint32_t>(right > 63 ? 63 : right);
        shifts.bias[i] = 1;
    }
    for (std::size_t i = 0; i < n; ++i) {
        shifts.bias[i] = Fixed::Shift::kTop + ((shifts.bias[i] << shifts.right[i]) >> 1);
    }
    return any_left >= 0;
}

REPOUSSE_VECTOR_CLONES
void squares(const Fixed::Columns& v, std::size_t n, Wide* to) {
    const Value *x = v.from[0], *y = v.from[1], *z = v.from[2];
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        to[i] = Wide{x[i]} * x[i] + Wide{y[i]} * y[i] + Wide{z[i]} * z[i];
    }
}

}  // namespace

void Fixed::Quotient::operator()(const Value* const* from, Value* const* to, std::size_t count,
                                 const Inverses& r, std::size_t n, uint64_t& overflows) const {
    assert(n <= kFunctionBatch);
    Shifts shifts;
    const bool plain = set_shifts(r.exponents.data(), shift_, n, shifts);
    for (std::size_t k = 0; k < count; ++k) {
        if (plain && shifted_products(from[k], r.mantissas.data(), shifts, n, low_, high_, to[k])) {
            continue;
        }
        for (std::size_t i = 0; i < n; ++i) {
            to[k][i] = (*this)(from[k][i], {r.mantissas[i], r.exponents[i]}, overflows);
        }
    }
}

void Fixed::ShiftedCast::operator()(const Columns& vectors, const int32_t* mantissas,
                                    const int32_t* exponents, std::size_t n) const {
    assert(n <= kFunctionBatch);
    Shifts shifts;
    const Format& to = casts_[0].format();
    const bool plain = to.quantization == Quantization::SC_RND &&
                       casts_.back().kind() == CastKind::Clamp &&
                       set_shifts(exponents, -to.frac, n, shifts);
    const CastSteps& steps = casts_[0].steps();
    uint64_t saturated = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Value* from = vectors.from[k];
        Value* result = vectors.to[k];
        if (plain && shifted_products(from, mantissas, shifts, n, steps.low, steps.high, result)) {
            continue;
        }
        for (std::size_t i = 0; i < n; ++i) {
            result[i] = (*this)(mul(from[i], mantissas[i]), exponents[i], saturated);
        }
    }
}

// The zero vector stays zero whatever it is multiplied with.
void Fixed::Normalise::operator()(const Columns& vectors, std::size_t n,
                                  uint64_t& degenerate) const {
    if (kind_ == NormaliseKind::Cordic) {
        const auto& [from, to] = vectors;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3<Value> v = (*this)({from[0][i], from[1][i], from[2][i]}, degenerate);
            to[0][i] = v.x, to[1][i] = v.y, to[2][i] = v.z;
        }
        return;
    }
    Wide square[kFunctionBatch];
    int32_t mantissas[kFunctionBatch], exponents[kFunctionBatch];
    squares(vectors, n, square);
    for (std::size_t i = 0; i < n; ++i) degenerate += square[i] == 0;
    inverse_sqrt_(square, n, mantissas, exponents);
    round_(vectors, mantissas, exponents, n);
}

}  // namespace repousse

#pragma once

#define SC_INCLUDE_FX
#include <cstdint>
#include <optional>
#include <systemc>

#include "datapath/numbers/format.h"

namespace repousse::test {

inline sc_dt::sc_q_mode sc_mode(Quantization mode) {
    switch (mode) {
        case Quantization::SC_TRN:
            return sc_dt::SC_TRN;
        case Quantization::SC_TRN_ZERO:
            return sc_dt::SC_TRN_ZERO;
        case Quantization::SC_RND:
            return sc_dt::SC_RND;
        case Quantization::SC_RND_MIN_INF:
            return sc_dt::SC_RND_MIN_INF;
        case Quantization::SC_RND_ZERO:
            return sc_dt::SC_RND_ZERO;
        case Quantization::SC_RND_INF:
            return sc_dt::SC_RND_INF;
        case Quantization::SC_RND_CONV:
            return sc_dt::SC_RND_CONV;
    }
    return sc_dt::SC_TRN;
}

inline sc_dt::sc_o_mode sc_mode(Overflow mode) {
    switch (mode) {
        case Overflow::SC_WRAP:
            return sc_dt::SC_WRAP;
        case Overflow::SC_SAT:
            return sc_dt::SC_SAT;
        case Overflow::SC_SAT_ZERO:
            return sc_dt::SC_SAT_ZERO;
        case Overflow::SC_SAT_SYM:
            return sc_dt::SC_SAT_SYM;
        case Overflow::SC_WRAP_SM:
            return sc_dt::SC_WRAP_SM;
    }
    return sc_dt::SC_WRAP;
}

/// A raw result in target LSB and the overflow flag of IEEE 1666.
struct CastResult {
    std::int64_t value = 0;
    bool overflow = false;
};

inline bool operator==(const CastResult& a, const CastResult& b) {
    return a.value == b.value && a.overflow == b.overflow;
}

/// The same cast by SystemC's arbitrary-precision sc_fix or sc_ufix (never the *_fast types, which
/// lose bits beyond 53). The source is an integer, so the target has -`dropped` fraction bits.
class ScFixOracle {
public:
    ScFixOracle(const Format& to, int dropped) : dropped_(dropped) {
        const int integer_width = to.width + dropped;
        if (to.is_signed) {
            signed_.emplace(to.width, integer_width, sc_mode(to.quantization), sc_mode(to.overflow),
                            to.saturated_bits);
        } else {
            unsigned_.emplace(to.width, integer_width, sc_mode(to.quantization),
                              sc_mode(to.overflow), to.saturated_bits);
        }
    }

    CastResult operator()(std::int64_t x) {
        return signed_ ? cast(*signed_, x) : cast(*unsigned_, x);
    }

private:
    template <class ScFix>
    CastResult cast(ScFix& number, std::int64_t x) const {
        number = static_cast<sc_dt::int64>(x);
        // Read as 2 raw + 1, because SystemC 2.3.4 converts every value whose low 32 bits are zero
        // to 0 (scfx_rep::to_uint64 stops at the least significant word in use). 64 bits hold it.
        const sc_dt::sc_fxval exact(number);
        const int doubled = dropped_ - 1;
        const sc_dt::sc_fxval twice = doubled >= 0 ? exact >> doubled : exact << -doubled;
        const sc_dt::sc_fxval odd = twice + sc_dt::sc_fxval(1);
        const sc_dt::uint64 bits = odd.to_uint64();
        const bool is_signed = signed_.has_value();
        return {
            is_signed ? static_cast<std::int64_t>(bits) >> 1 : static_cast<std::int64_t>(bits >> 1),
            number.overflow_flag()};
    }

    int dropped_;
    std::optional<sc_dt::sc_fix> signed_;
    std::optional<sc_dt::sc_ufix> unsigned_;
};

}  // namespace repousse::test

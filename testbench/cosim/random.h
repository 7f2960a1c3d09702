#pragma once

#include <cstdint>

namespace repousse::cosim {

/// xorshift64*: small, quick, and the same sequence everywhere, also inside engines.
class Random {
public:
    explicit Random(uint64_t seed, uint64_t stream = 0)
        : state_(mix(seed + 0x9e3779b97f4a7c15ULL * (stream + 1))) {}

    uint64_t next() {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return state_ * 0x2545f4914f6cdd1dULL;
    }

    /// Uniform in 0 .. n - 1, n < 2^32. (The bias of at most n / 2^32 is no matter here.)
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(((next() >> 32) * n) >> 32); }

    /// Uniform in low .. high, less than 2^32 apart.
    int64_t between(int64_t low, int64_t high) {
        return low + static_cast<int64_t>(((next() >> 32) * (uint64_t(high - low) + 1)) >> 32);
    }

    bool percent(uint32_t p) { return below(100) < p; }

    /// At most `bits` bits, each length equally likely.
    uint64_t of_any_length(int bits) {
        const auto length = static_cast<int>(below(static_cast<uint32_t>(bits) + 1));
        return length == 0 ? 0 : next() >> (64 - length);
    }

private:
    static uint64_t mix(uint64_t x) {  // splitmix64's output function; never 0 afterwards
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
        x ^= x >> 31;
        return x == 0 ? 1 : x;
    }

    uint64_t state_;
};

}  // namespace repousse::cosim

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace repousse::cosim {

/// FNV-1a, 64 bits, over texts with their ends marked.
class Hash {
public:
    void add(std::string_view text) {
        for (const char c : text) step(static_cast<unsigned char>(c));
        step(0xff);
    }
    uint64_t value() const { return value_; }

private:
    void step(uint64_t byte) { value_ = (value_ ^ byte) * 1099511628211ULL; }
    uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace repousse::cosim

#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "datapath/items.h"
#include "datapath/unit_desc.h"

namespace repousse {

/// What each of the edge tests counts: functions of the items alone, so equal at every level.
struct TestCounters {
    uint64_t items = 0;      ///< edges that came by
    uint64_t tests = 0;      ///< those that were not skipped
    uint64_t positives = 0;  ///< tests that found something
};

/// The number of ports of one kind.
constexpr std::size_t port_count(const UnitDesc& desc, PortKind kind) {
    std::size_t count = 0;
    for (const Port& port : desc.ports) count += port.kind == kind ? 1 : 0;
    return count;
}

/// Whether the ports of one kind are exactly these, in this order. Transaction structs are written
/// by hand; a static_assert of this beside their `pack` is what ties them to the description.
constexpr bool ports_are(const UnitDesc& desc, PortKind kind,
                         std::initializer_list<std::string_view> names) {
    const std::string_view* expected = names.begin();
    for (const Port& port : desc.ports) {
        if (port.kind != kind) continue;
        if (expected == names.end() || *expected != port.name) return false;
        ++expected;
    }
    return expected == names.end();
}

/// A transaction outside the model is one 64-bit word a port, in the order of the description:
/// signed fields sign-extended, the others zero-extended. `Word` is that word.
using Word = int64_t;

/// A texture coordinate from two words.
inline Uv uv_from_words(const Word* words) {
    return {static_cast<int32_t>(words[0]), static_cast<int32_t>(words[1])};
}

}  // namespace repousse

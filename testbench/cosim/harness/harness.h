#pragma once

// Compiled into engines, together with what Verilator makes of a unit: <Vunit.h>. The builder
// defines SIMULATOR, and each parameter of the RTL under its own name.

#include <Vunit.h>
#include <verilated.h>

#include <array>
#include <cstdint>
#include <new>
#include <type_traits>

#include "testbench/cosim/harness/pacer.h"
#include "testbench/cosim/harness/read_port.h"
#include "tlm/engine.h"

namespace repousse::harness {

/// The low `width` bits of a word: Verilated ports must not carry more than they are wide.
template <int width>
constexpr uint64_t bits(int64_t word) {
    static_assert(width >= 1 && width <= 64);
    return static_cast<uint64_t>(word) & (~uint64_t(0) >> (64 - width));
}

/// A signed port of `width` bits as a word: Verilated ports are unsigned.
template <int width>
constexpr int64_t extended(uint64_t port) {
    static_assert(width >= 1 && width <= 64);
    return static_cast<int64_t>(port << (64 - width)) >> (64 - width);
}

/// Writes a vector port: `count` words, the last element first, of `width` bits each.
template <int width, class Vector>
void drive_vector(Vector& port, const int64_t* words, int count) {
    if constexpr (std::is_integral_v<Vector>) {
        uint64_t all = 0;
        for (int i = 0; i < count; ++i)
            all = (width < 64 ? all << width : 0) | bits<width>(words[i]);
        port = static_cast<Vector>(all);
    } else {
        for (int i = 0; i < (count * width + 31) / 32; ++i) port[i] = 0;
        for (int i = 0; i < count; ++i) {
            const uint64_t word = bits<width>(words[count - 1 - i]);
            const int at = i * width % 32;
            uint32_t* to = &port[i * width / 32];
            to[0] |= static_cast<uint32_t>(word << at);
            if (at + width > 32) to[1] |= static_cast<uint32_t>(word >> (32 - at));
            if (at + width > 64) to[2] |= static_cast<uint32_t>(word >> (64 - at));
        }
    }
}

/// Reads a vector port likewise, sign-extended if `is_signed`.
template <int width, bool is_signed, class Vector>
void sample_vector(const Vector& port, int64_t* words, int count) {
    for (int i = 0; i < count; ++i) {
        uint64_t word = 0;
        if constexpr (std::is_integral_v<Vector>) {
            word = static_cast<uint64_t>(port) >> (i * width);
        } else {
            const int at = i * width % 32;
            const uint32_t* from = &port[i * width / 32];
            word = from[0] >> at;
            if (at + width > 32) word |= static_cast<uint64_t>(from[1]) << (32 - at);
            if (at + width > 64) word |= static_cast<uint64_t>(from[2]) << (64 - at);
        }
        const uint64_t raised = word << (64 - width);
        words[count - 1 - i] = is_signed ? static_cast<int64_t>(raised) >> (64 - width)
                                         : static_cast<int64_t>(raised >> (64 - width));
    }
}

/// The output word that marks an item's last beat: Unit::kLast, where there is one.
template <class Unit, class = void>
inline constexpr int kLastWord = -1;
template <class Unit>
inline constexpr int kLastWord<Unit, std::void_t<decltype(Unit::kLast)>> = Unit::kLast;

/// Units that keep a table of their own have load(Vunit&, const RepousseTable&), which writes it
/// while the unit is empty; these cycles are not counted.
template <class Unit, class = void>
struct TableLoader {
    template <class Top>
    static void load_table(Top&, const RepousseTable&) {}
};
template <class Unit>
struct TableLoader<Unit, std::void_t<decltype(&Unit::load)>> {
    template <class Top>
    static void load_table(Top& top, const RepousseTable& table) {
        Unit::load(top, table);
    }
};

/// A self-ticking Verilated unit. The whole loop over a batch stands here, inside the shared
/// object, so that thousands of transactions cost one call through the C interface.
///
/// `Unit` connects the ports by name:
///     kName, kConfigs, kInputs, kOutputs, kReadEntries
///     configure(Vunit&, const int64_t*), drive(Vunit&, const int64_t*), sample(Vunit&, int64_t*)
///     with items of several beats, kLast: the output word that marks the last one
///     and, with a read port, the functions that ReadPort asks for.
template <class Unit>
class Harness {
public:
    Harness() : top_(&context_, "top") { reset(); }

    void configure(const int64_t* config, const RepousseTable* table) {
        Unit::configure(top_, config);
        if (table == nullptr) return;
        port_.configure(*table);
        TableLoader<Unit>::load_table(top_, *table);
    }

    void reset() {
        top_.rst_n = 0;
        top_.in_valid = 0;
        top_.out_ready = 0;
        port_.reset(top_);
        for (int i = 0; i < 2; ++i) tick();
        top_.rst_n = 1;
        cycle_ = 0;
    }

    int32_t run(const RepousseBatch& batch);
    uint64_t cycle() const { return cycle_; }

private:
    static constexpr uint64_t kPatience = 100000;  // cycles without any transfer

    /// Inputs are in place: let the handshakes settle.
    void settle() {
        top_.clk = 0;
        top_.eval();
    }
    void edge() {
        top_.clk = 1;
        top_.eval();
        ++cycle_;
    }
    void tick() { settle(), edge(); }

    VerilatedContext context_;
    Vunit top_;
    ReadPort<Unit> port_;
    uint64_t cycle_ = 0;
};

template <class Unit>
int32_t Harness<Unit>::run(const RepousseBatch& batch) {
    Random random(batch.seed);
    Pacer source(batch.source);
    Pacer sink(batch.sink);
    port_.pace(batch.requests, batch.responses);

    std::array<int64_t, Unit::kOutputs> result{};
    std::array<int64_t, Unit::kOutputs> stalled{};
    uint64_t sent = 0;
    uint64_t done = 0;   // items of which the last beat is out
    uint64_t beats = 0;  // out
    uint64_t unseen = 0;
    uint64_t& reported = batch.beats != nullptr ? *batch.beats : unseen;
    reported = 0;
    uint64_t quiet = 0;
    bool offering = false;     // item `sent` stands at the input
    bool was_stalled = false;  // beat `beats` stood at the output and was not taken

    while (done < batch.count) {
        if (!offering && sent < batch.count) {
            offering =
                batch.offer != nullptr ? cycle_ >= batch.offer[sent] : source.willing(random);
            if (offering) Unit::drive(top_, batch.in + sent * Unit::kInputs);
        }
        const bool taking =
            batch.ready != nullptr ? cycle_ >= batch.ready[beats] : sink.willing(random);
        top_.in_valid = offering;
        top_.out_ready = taking;
        port_.drive(top_, cycle_, random);
        settle();

        const bool accepted = offering && top_.in_ready;
        const bool offered = top_.out_valid;
        if (const int32_t wrong = port_.sample(top_, cycle_)) return wrong;
        if (offered) {
            if (done == sent || beats == batch.capacity) return kRepousseExcess;
            Unit::sample(top_, result.data());
            if (was_stalled && result != stalled) return kRepousseUnstable;
            stalled = result;
        } else if (was_stalled) {
            return kRepousseUnstable;
        }
        was_stalled = offered && !taking;
        if (offered && taking) {
            for (int i = 0; i < Unit::kOutputs; ++i)
                batch.out[beats * Unit::kOutputs + i] = result[i];
            if (batch.depart != nullptr) batch.depart[beats] = cycle_;
            reported = ++beats;
            if constexpr (kLastWord<Unit> < 0) {
                ++done;
            } else {
                done += result[kLastWord<Unit>] != 0;
            }
        }
        if (accepted) {
            if (batch.accept != nullptr) batch.accept[sent] = cycle_;
            ++sent;
            offering = false;
        }
        // Waiting for a cycle that the batch names is no standstill.
        const bool asleep = (batch.offer != nullptr && sent < batch.count && !offering) || !taking;
        quiet = accepted || (offered && taking) || asleep ? 0 : quiet + 1;
        if (quiet > kPatience) return kRepousseStuck;
        edge();
    }
    return kRepousseDone;
}

/// The table of entry points for a unit.
template <class Unit>
const RepousseEngine* engine() {
    using H = Harness<Unit>;
    static const RepousseEngine table = {
        kRepousseEngineAbi,
        Unit::kName,
        SIMULATOR,
        Unit::kConfigs,
        Unit::kInputs,
        Unit::kOutputs,
        kLastWord<Unit>,
        Unit::kReadEntries,
        []() -> void* { return new (std::nothrow) H; },
        [](void* h) { delete static_cast<H*>(h); },
        [](void* h, const int64_t* config, const RepousseTable* memory) {
            static_cast<H*>(h)->configure(config, memory);
        },
        [](void* h, const RepousseBatch* batch) { return static_cast<H*>(h)->run(*batch); },
        [](void* h) { return static_cast<H*>(h)->cycle(); },
        [](void* h) { static_cast<H*>(h)->reset(); },
    };
    return &table;
}

}  // namespace repousse::harness

/// What an engine exports; defined once, by the unit's own file.
extern "C" __attribute__((visibility("default"))) const RepousseEngine* repousse_engine();

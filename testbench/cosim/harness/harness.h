#pragma once

// Compiled into engines, together with what Verilator makes of a unit: <Vunit.h>. The builder
// defines SIMULATOR, and each parameter of the RTL under its own name.

#include <Vunit.h>
#include <verilated.h>

#include <array>
#include <cstdint>
#include <new>

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

/// A self-ticking Verilated unit. The whole loop over a batch stands here, inside the shared
/// object, so that thousands of transactions cost one call through the C interface.
///
/// `Unit` connects the ports by name:
///     kName, kConfigs, kInputs, kOutputs, kReadEntries
///     configure(Vunit&, const int64_t*), drive(Vunit&, const int64_t*), sample(Vunit&, int64_t*)
///     and, with a read port, the functions that ReadPort asks for.
template <class Unit>
class Harness {
public:
    Harness() : top_(&context_, "top") { reset(); }

    void configure(const int64_t* config, const RepousseTable* table) {
        Unit::configure(top_, config);
        if (table != nullptr) port_.configure(*table);
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
    uint64_t done = 0;
    uint64_t quiet = 0;
    bool offering = false;     // item `sent` stands at the input
    bool was_stalled = false;  // item `done` stood at the output and was not taken

    while (done < batch.count) {
        if (!offering && sent < batch.count) {
            offering =
                batch.offer != nullptr ? cycle_ >= batch.offer[sent] : source.willing(random);
            if (offering) Unit::drive(top_, batch.in + sent * Unit::kInputs);
        }
        const bool taking =
            batch.ready != nullptr ? cycle_ >= batch.ready[done] : sink.willing(random);
        top_.in_valid = offering;
        top_.out_ready = taking;
        port_.drive(top_, cycle_, random);
        settle();

        const bool accepted = offering && top_.in_ready;
        const bool offered = top_.out_valid;
        if (const int32_t wrong = port_.sample(top_, cycle_)) return wrong;
        if (offered) {
            if (done == sent) return kRepousseExcess;
            Unit::sample(top_, result.data());
            if (was_stalled && result != stalled) return kRepousseUnstable;
            stalled = result;
        } else if (was_stalled) {
            return kRepousseUnstable;
        }
        was_stalled = offered && !taking;
        if (offered && taking) {
            for (int i = 0; i < Unit::kOutputs; ++i)
                batch.out[done * Unit::kOutputs + i] = result[i];
            if (batch.depart != nullptr) batch.depart[done] = cycle_;
            ++done;
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

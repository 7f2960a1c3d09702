#pragma once

#include <cstdint>

/// An engine is a unit's RTL, simulated, behind a small C interface: one shared object a unit and
/// parameter set, opened with RTLD_LOCAL and hiding every symbol but `repousse_engine`, so that
/// several of them, even of different Verilator versions, live in one process. `repousse cosim`
/// builds them from rtl/; a user's own RTL becomes one by exporting the same function.
///
/// A transaction is one 64-bit word a scalar port, in the order of the unit's description: signed
/// fields sign-extended, unsigned ones zero-extended. Cycles count rising edges with rst_n = 1, the
/// first of which ends cycle 0; a transfer happens in cycle t if valid and ready are both high in
/// it.
///
/// Most units deliver one beat for each item that they accept. One that expands items delivers one
/// or more, in the order of the items, and sets an output field in each item's last beat. A vector
/// port is one word an element, the last element first.
extern "C" {

/// Version of this interface: an engine of another version is refused.
inline constexpr uint32_t kRepousseEngineAbi = 2;

/// What stands behind the unit's read port: entry (x, y) is entries[y * columns + x].
struct RepousseTable {
    const uint64_t* entries;  ///< must outlive its use; null for units without one
    uint64_t count;
    uint64_t columns;
    uint32_t latency;  ///< cycles from a request to its answer, >= 1
};

/// How readily one side of a handshake acts while it is not told cycle by cycle: it is willing in
/// `percent` of all stretches of `burst` cycles, at random.
struct RepoussePace {
    uint32_t percent;  ///< 100: always
    uint32_t burst;    ///< >= 1
};

/// A stream of transactions through an engine, which is empty before and after it.
struct RepousseBatch {
    uint64_t count;     ///< items
    uint64_t capacity;  ///< beats that there is room for: at least `count`
    const int64_t* in;  ///< count * inputs words
    int64_t* out;       ///< capacity * outputs words, filled in
    uint64_t* beats;    ///< null, or filled in, whatever the outcome: beats that came out

    const uint64_t* offer;  ///< null, or the first cycle in which item i is offered
    const uint64_t* ready;  ///< null, or the first cycle in which beat i would be taken
    uint64_t* accept;       ///< null, or filled in: the cycle in which the unit took item i
    uint64_t* depart;       ///< null, or filled in: the cycle in which beat i left

    uint64_t seed;           ///< of the paces below
    RepoussePace source;     ///< where `offer` is null
    RepoussePace sink;       ///< where `ready` is null
    RepoussePace requests;   ///< of the read port: requests are taken
    RepoussePace responses;  ///< of the read port: answers that are due are given
};

/// How a batch ended. Anything but kRepousseDone leaves the engine in need of a reset.
enum RepousseOutcome : int32_t {
    kRepousseDone = 0,
    kRepousseStuck = 1,     ///< nothing moved for 100,000 willing cycles
    kRepousseUnstable = 2,  ///< a valid was withdrawn, or its data changed, before the transfer
    kRepousseAddress = 3,   ///< a read outside the table
    kRepousseRefused = 4,   ///< an answer was not taken
    kRepousseExcess = 5,    ///< more came out than went in, or than there was room for
};

/// The engine's entry points. An instance belongs to one thread at a time.
struct RepousseEngine {
    uint32_t abi;           ///< kRepousseEngineAbi
    const char* unit;       ///< the unit's name
    const char* simulator;  ///< what runs it, with its version
    uint32_t configs;       ///< words of the Config ports
    uint32_t inputs;        ///< words of the Input ports
    uint32_t outputs;       ///< words of the Output ports
    int32_t last;           ///< output word that is 1 in an item's last beat; -1: one beat an item
    uint32_t read_entries;  ///< table entries a request of the read port asks for; 0: no port

    void* (*create)();  ///< a new instance, reset; null if out of memory
    void (*destroy)(void* instance);

    /// Loads the registers (`configs` words) and the table. Only between batches.
    void (*configure)(void* instance, const int64_t* config, const RepousseTable* table);

    /// Runs a batch; the cycle counter goes on from one batch to the next.
    int32_t (*run)(void* instance, const RepousseBatch* batch);

    uint64_t (*cycle)(void* instance);  ///< the next cycle's number
    void (*reset)(void* instance);      ///< power-on state and cycle 0; registers are kept
};

/// The one exported symbol of an engine.
using RepousseEngineFunction = const RepousseEngine* (*)();

}  // extern "C"

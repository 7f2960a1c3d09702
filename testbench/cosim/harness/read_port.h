#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "testbench/cosim/harness/pacer.h"
#include "tlm/engine.h"

namespace repousse::harness {

/// The coordinates of a table entry, as a unit asks for it.
struct Address {
    uint32_t x = 0;
    uint32_t y = 0;
};

/// The memory behind a unit's read port: answers in order, `latency` cycles after the request or
/// later. A request asks for up to kReadEntries entries of the table. `Unit` connects the ports:
///
///     drive_memory(Vunit&, bool ready, bool rvalid, const uint64_t* rdata)
///     requests(const Vunit&) -> bool                  valid of the request channel
///     takes_answer(const Vunit&) -> bool              ready of the answer channel
///     wants(const Vunit&, int entry) -> bool,  address(const Vunit&, int entry) -> Address
template <class Unit, bool = (Unit::kReadEntries > 0)>
class ReadPort {
public:
    void configure(const RepousseTable& table) { table_ = table; }

    template <class Top>
    void reset(Top& top) {
        head_ = tail_ = 0;
        stalled_ = false;
        Unit::drive_memory(top, false, false, nullptr);
    }

    void pace(RepoussePace requests, RepoussePace responses) {
        requests_ = Pacer(requests);
        responses_ = Pacer(responses);
    }

    /// Before the handshakes settle: is a request taken, is an answer due?
    template <class Top>
    void drive(Top& top, uint64_t cycle, Random& random) {
        const Answer& oldest = pending_[head_ % kPending];
        ready_ = requests_.willing(random) && tail_ - head_ < kPending;
        rvalid_ = head_ != tail_ && cycle >= oldest.due && responses_.willing(random);
        Unit::drive_memory(top, ready_, rvalid_, oldest.data.data());
    }

    /// After they have settled: retires an answer, takes a request.
    template <class Top>
    int32_t sample(const Top& top, uint64_t cycle) {
        if (rvalid_ && !Unit::takes_answer(top)) return kRepousseRefused;
        head_ += rvalid_;
        if (!Unit::requests(top)) return stalled_ ? kRepousseUnstable : kRepousseDone;

        // The oldest free place takes the answer; while the request is stalled it is filled again,
        // and must be filled with the same.
        Answer& answer = pending_[tail_ % kPending];
        const Answer before = stalled_ ? answer : Answer{};
        answer.due = cycle + table_.latency;
        for (int e = 0; e < Unit::kReadEntries; ++e) {
            if (!Unit::wants(top, e)) continue;
            const Address at = Unit::address(top, e);
            const uint64_t index = at.y * table_.columns + at.x;
            if (at.x >= table_.columns || index >= table_.count) return kRepousseAddress;
            answer.data[static_cast<std::size_t>(e)] = table_.entries[index];
            answer.index[static_cast<std::size_t>(e)] = index;
        }
        if (stalled_ && answer.index != before.index) return kRepousseUnstable;
        stalled_ = !ready_;
        tail_ += ready_;
        return kRepousseDone;
    }

private:
    static constexpr uint64_t kPending = 64;  // more than any client has in flight

    struct Answer {
        std::array<uint64_t, Unit::kReadEntries> data{};
        std::array<uint64_t, Unit::kReadEntries> index{};  // in the table
        uint64_t due = 0;                                  // cycle
    };

    RepousseTable table_{};
    std::array<Answer, kPending> pending_{};
    uint64_t head_ = 0;
    uint64_t tail_ = 0;
    Pacer requests_, responses_;
    bool ready_ = false;
    bool rvalid_ = false;
    bool stalled_ = false;  // the request of the last cycle was not taken
};

/// Units that read nothing.
template <class Unit>
class ReadPort<Unit, false> {
public:
    void configure(const RepousseTable&) {}
    template <class Top>
    void reset(Top&) {}
    void pace(RepoussePace, RepoussePace) {}
    template <class Top>
    void drive(Top&, uint64_t, Random&) {}
    template <class Top>
    int32_t sample(const Top&, uint64_t) {
        return kRepousseDone;
    }
};

}  // namespace repousse::harness

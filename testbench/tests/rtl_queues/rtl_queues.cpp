// Items with 0 to 4 parts through rtl_queues.sv, under random gaps and stalls: the data that come
// out, and the cycle of every transfer against the recurrences of rp_scatter, rp_pipe and
// rp_gather. rtl_queues_test.sh builds this with Verilator and defines the depths.

#include <Vrtl_queues.h>
#include <verilated.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

namespace {

using Cycle = int64_t;
constexpr int kItems = 40000;
constexpr int kMost = 4;

/// Share of cycles with a gap before an item, and in which a beat would be taken, in percent.
struct Mood {
    unsigned gaps, ready;
};
constexpr Mood kMoods[] = {{0, 100}, {50, 100}, {0, 50}, {40, 70},
                           {86, 23}, {23, 40},  {0, 12}, {16, 86}};

/// Cycles of all transfers: of items into rp_scatter, of parts out of it and into rp_gather, of
/// items out of that.
struct Times {
    std::vector<Cycle> accept, leave, arrive, depart;
};

class Run {
public:
    Run(Mood mood, unsigned seed) : random_(seed), mood_(mood) {
        for (int i = 0; i < kItems; ++i) {
            // Any number of parts, or mostly one, as the sweep line has it.
            const unsigned any = random_() % 10;
            parts_.push_back(seed % 2 ? (any < 6 ? 1 : static_cast<int>(any % 5))
                                      : static_cast<int>(random_() % 5));
            first_.push_back(first_.back() + parts_.back());
        }
    }

    /// Transfers that are not where the recurrences say, and wrong data.
    long errors() {
        simulate();
        const Times expected = model();
        return wrong_data_ + different(seen_.accept, expected.accept) +
               different(seen_.leave, expected.leave) + different(seen_.arrive, expected.arrive) +
               different(seen_.depart, expected.depart);
    }
    long transfers() const { return 2L * kItems + 2L * first_.back(); }

private:
    static long different(const std::vector<Cycle>& a, const std::vector<Cycle>& b) {
        long count = static_cast<long>(std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i];
        return count;
    }

    void simulate();
    Times model() const;

    std::mt19937 random_;
    Mood mood_;
    std::vector<int> parts_;
    std::vector<int> first_ = {0};      // number of an item's first part
    std::vector<Cycle> offer_, ready_;  // first cycle in which item i is offered, would be taken
    Times seen_;
    long wrong_data_ = 0;
};

void Run::simulate() {
    const auto gap = [&] { return random_() % 100 < mood_.gaps ? 1 + random_() % 8 : 0; };
    const auto stall = [&] {
        Cycle cycles = 0;
        while (random_() % 100 >= mood_.ready) ++cycles;
        return cycles;
    };
    Vrtl_queues top;
    const auto half = [&](int level) {
        top.clk = level;
        top.eval();
    };
    top.rst_n = top.in_valid = top.out_ready = 0;
    for (int i = 0; i < 4; ++i) half(i % 2);
    top.rst_n = 1;
    offer_ = {static_cast<Cycle>(gap())};
    ready_ = {stall()};
    for (Cycle now = 0; seen_.depart.size() < kItems && now < 4'000'000; ++now) {
        const std::size_t in = seen_.accept.size(), out = seen_.depart.size();
        top.in_valid = in < kItems && now >= offer_[in];
        top.out_ready = now >= ready_[out];
        if (top.in_valid) {
            top.in_item = static_cast<uint16_t>(in);
            top.in_n = static_cast<uint8_t>(parts_[in]);
            top.in_parts = 0;
            for (int k = 0; k < parts_[in]; ++k) {
                top.in_parts |= uint64_t{static_cast<uint16_t>(first_[in] + k)} << (16 * k);
            }
        }
        half(0);
        if (top.part_leaves) seen_.leave.push_back(now);
        if (top.part_arrives) seen_.arrive.push_back(now);
        if (top.in_valid && top.in_ready) {
            seen_.accept.push_back(now);
            offer_.push_back(now + 1 + static_cast<Cycle>(gap()));
        }
        if (top.out_valid && top.out_ready) {
            wrong_data_ += top.out_item != static_cast<uint16_t>(out) || top.out_n != parts_[out];
            for (int k = 0; k < parts_[out]; ++k) {
                wrong_data_ += static_cast<uint16_t>(top.out_parts >> (16 * k)) !=
                               static_cast<uint16_t>(first_[out] + k);
            }
            seen_.depart.push_back(now);
            ready_.push_back(now + 1 + stall());
        }
        half(1);
    }
}

Times Run::model() const {
    Times t;
    std::vector<std::size_t> item_of;
    const auto at = [](const std::vector<Cycle>& list, int64_t i) {
        return i < 0 ? Cycle{-1'000'000} : list[static_cast<std::size_t>(i)];
    };
    for (int64_t i = 0; i < kItems; ++i) {
        const auto n = static_cast<std::size_t>(i);
        if (n >= offer_.size() || n >= ready_.size()) break;  // it got stuck
        t.accept.push_back(
            std::max({offer_[n], at(t.accept, i - 1) + 1, at(t.depart, i - STEPS) + 1,
                      at(t.leave, first_[n] + kMost - SCATTER - 1) + 1}));
        for (int64_t m = first_[n]; m < first_[n + 1]; ++m) {
            item_of.push_back(n);
            t.leave.push_back(
                std::max({t.accept[n] + 1, at(t.leave, m - 1) + 1, at(t.arrive, m - STAGES)}));
            const Cycle place =
                m < GATHER ? 0 : t.depart[item_of[static_cast<std::size_t>(m - GATHER)]] + 1;
            t.arrive.push_back(std::max({t.leave.back() + STAGES, at(t.arrive, m - 1) + 1, place}));
        }
        const Cycle whole = parts_[n] == 0 ? 0 : t.arrive.back() + 1;
        t.depart.push_back(std::max({t.accept[n] + 1, whole, at(t.depart, i - 1) + 1, ready_[n]}));
    }
    return t;
}

}  // namespace

int main() {
    long errors = 0, transfers = 0;
    unsigned seed = 0;
    for (const Mood& mood : kMoods) {
        Run run(mood, ++seed);
        errors += run.errors();
        transfers += run.transfers();
    }
    std::printf("depths %d %d %d, %d stages: %ld transfers, %ld wrong\n", SCATTER, STEPS, GATHER,
                STAGES, transfers, errors);
    return errors == 0 ? 0 : 1;
}

#include "testbench/cosim/height_test_cases.h"

#include <algorithm>

#include "testbench/cosim/table_pool.h"

namespace repousse::cosim {
namespace {

using TablePtr = std::shared_ptr<const Table>;

/// Writes scenarios: every case comes in four kinds (box, mode), each under the two thresholds on
/// either side of one edge's decision, or under the least and the greatest.
class CaseWriter {
public:
    explicit CaseWriter(const Profile& profile) : profile_(profile), unit_(profile) {}

    int32_t texel() const { return int32_t{1} << profile_.uv.frac; }

    /// Starts a case: edges follow, and are written when the next case starts.
    void begin(const char* name, TablePtr table, bool wrap, bool thresholds_at_the_ends = false) {
        finish();
        at_the_ends_ = thresholds_at_the_ends;
        name_ = name;
        table_ = std::move(table);
        wrap_ = wrap;
    }

    /// An edge, from both sides. One that the unit is not defined for passes as skipped.
    void edge(Uv u1, Uv u2, bool skip = false) {
        const Uv u12{(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1};
        edges_.push_back({skip, u1, u2, u12});
        edges_.push_back({skip, u2, u1, u12});
    }

    std::vector<Scenario> take() {
        finish();
        return std::move(cases_);
    }

private:
    void finish() {
        if (edges_.empty()) return;
        for (const BoxKind box : {BoxKind::Square, BoxKind::Literal}) {
            for (const HeightMode mode : {HeightMode::Average, HeightMode::Sum}) write(box, mode);
        }
        edges_.clear();
    }

    void write(BoxKind box, HeightMode mode) {
        HeightTestRegisters registers;
        registers.width = table_->width;
        registers.height = table_->height;
        registers.wrap = wrap_;
        registers.box = box;
        registers.mode = mode;
        const int bits = mode == HeightMode::Average ? profile_.height.width : profile_.sat_width;
        const uint64_t most = (uint64_t{1} << bits) - 1;
        const HeightTestIn& judged = edges_[edges_.size() / 4 * 2];
        const uint64_t border = border_threshold(unit_, registers, table_->entries, judged, most);
        const std::vector<uint64_t> thresholds =
            at_the_ends_ ? std::vector<uint64_t>{0, most}
                         : std::vector<uint64_t>{border - (border > 0), border};
        for (const uint64_t threshold : thresholds) {
            registers.threshold = threshold;
            unit_.configure(registers, table_->entries);
            const auto config = registers.pack();
            cases_.push_back({name_, {config.begin(), config.end()}, table_, {}});
            for (HeightTestIn in : edges_) {
                in.skip |= !unit_.accepts(in.u1, in.u2, in.u12);
                cases_.back().add(in);
            }
        }
    }

    Profile profile_;
    HeightTest unit_;
    std::string name_;
    TablePtr table_;
    bool wrap_ = false;
    bool at_the_ends_ = false;
    std::vector<HeightTestIn> edges_;
    std::vector<Scenario> cases_;
};

}  // namespace

HeightTestRegisters unpack_registers(const std::vector<int64_t>& config) {
    HeightTestRegisters r;
    r.width = static_cast<int>(config.at(0));
    r.height = static_cast<int>(config.at(1));
    r.wrap = config.at(2) != 0;
    r.box = config.at(3) != 0 ? BoxKind::Literal : BoxKind::Square;
    r.mode = config.at(4) != 0 ? HeightMode::Sum : HeightMode::Average;
    r.threshold = static_cast<uint64_t>(config.at(5));
    return r;
}

uint64_t border_threshold(HeightTest& unit, HeightTestRegisters registers,
                          Span<const uint64_t> table, const HeightTestIn& edge, uint64_t most) {
    uint64_t low = 0;
    uint64_t high = most;
    HeightTestStats stats;
    while (low < high) {
        registers.threshold = low + (high - low) / 2;
        unit.configure(registers, table);
        if (unit(edge.u1, edge.u2, edge.u12, stats)) {
            low = registers.threshold + 1;
        } else {
            high = registers.threshold;
        }
    }
    return low;
}

std::vector<Scenario> height_test_cases(const Profile& profile) {
    CaseWriter cases(profile);
    const int32_t t = cases.texel();
    const int sat = profile.sat_width;
    const uint64_t most = (uint64_t{1} << profile.height.width) - 1;
    Random random(2000);
    const TablePtr noise = prefix_sums(8, 8, sat, [&](int, int) { return random.next() & most; });
    const TablePtr flat = prefix_sums(8, 8, sat, [&](int, int) { return most; });
    const TablePtr ramp = prefix_sums(
        8, 8, sat, [&](int x, int y) { return static_cast<uint64_t>(100 * x + 100 * y) & most; });
    const TablePtr odd = prefix_sums(7, 5, sat, [&](int, int) { return random.next() & most; });
    const TablePtr dot = prefix_sums(1, 1, sat, [&](int, int) { return most; });

    for (const bool wrap : {false, true}) {
        // Literal boxes are empty here: SUM never fires, AVG widens to one texel.
        cases.begin(wrap ? "axis_aligned_wrap" : "axis_aligned", noise, wrap);
        cases.edge({0, 0}, {8 * t, 0});
        cases.edge({0, 3 * t}, {0, 7 * t});
        cases.edge({2 * t, 5 * t}, {6 * t, 5 * t});
        cases.edge({t / 2, t / 2}, {t / 2, 7 * t + t / 2});

        cases.begin(wrap ? "degenerate_wrap" : "degenerate", noise, wrap);
        for (const int32_t x : {-1, 0, 4 * t, 8 * t - 1, 8 * t}) cases.edge({x, x}, {x, x});

        // Corners at 0 and W exactly, one LSB inside and one outside.
        cases.begin(wrap ? "corners_at_w_wrap" : "corners_at_w", noise, wrap);
        for (const int32_t off : {-1, 0, 1}) {
            cases.edge({8 * t + off, 8 * t + off}, {4 * t, 4 * t});
            cases.edge({off, off}, {4 * t, 2 * t});
            cases.edge({8 * t + off, 0}, {8 * t + off, 1});
        }

        cases.begin(wrap ? "flat_wrap" : "flat", flat, wrap);
        cases.edge({0, 0}, {8 * t, 8 * t});
        cases.edge({t, 2 * t}, {5 * t, 3 * t + t / 2});

        cases.begin(wrap ? "ramp_wrap" : "ramp", ramp, wrap);
        cases.edge({t + t / 2, t + t / 2}, {6 * t, 5 * t});
        cases.edge({0, 0}, {8 * t, 4 * t});

        cases.begin(wrap ? "odd_size_wrap" : "odd_size", odd, wrap);
        cases.edge({0, 0}, {7 * t, 5 * t});
        cases.edge({3 * t + 1, t + 3}, {6 * t + t / 2, 4 * t});
        cases.edge({6 * t, 0}, {7 * t, 5 * t});

        cases.begin(wrap ? "one_texel_map_wrap" : "one_texel_map", dot, wrap);
        cases.edge({0, 0}, {t, t});
        cases.edge({0, 0}, {t / 2, 0});
        cases.edge({-t / 2, 0}, {t + t / 2, t});

        cases.begin(wrap ? "threshold_ends_wrap" : "threshold_ends", noise, wrap, true);
        cases.edge({0, 0}, {8 * t, 8 * t});
        cases.edge({t, 2 * t}, {5 * t, 3 * t + t / 2});
        cases.edge({4 * t, 4 * t}, {4 * t, 4 * t});

        // All bits of the adders: entries that are sums of nothing.
        cases.begin(wrap ? "full_range_wrap" : "full_range", random_words(8, 8, sat, random), wrap);
        cases.edge({0, 0}, {8 * t, 8 * t});
        cases.edge({t, 7 * t}, {6 * t, 2 * t});
        cases.edge({7 * t, t}, {4 * t, 8 * t});
    }

    // Every stored entry wraps around 2^sat_width, and no box does.
    cases.begin("modular", offset_table(*noise, ~uint64_t{0}, sat), false);
    cases.edge({0, 0}, {8 * t, 8 * t});
    cases.edge({t, 7 * t}, {6 * t, 2 * t});

    cases.begin("seam_in_x", noise, true);  // 6 reads a box
    cases.edge({7 * t, 4 * t}, {9 * t, 4 * t});
    cases.edge({-t, 4 * t}, {t, 5 * t});
    cases.edge({0, 4 * t}, {0, 6 * t});
    cases.edge({8 * t, 4 * t}, {8 * t, 6 * t});  // the same edge, a period on

    cases.begin("seam_in_y", noise, true);
    cases.edge({4 * t, 7 * t}, {4 * t, 9 * t});
    cases.edge({4 * t, -t}, {5 * t, t});

    cases.begin("seam_in_both", noise, true);  // 9 reads a box
    cases.edge({-t, -t}, {t, t});
    cases.edge({7 * t, 7 * t}, {9 * t, 9 * t});
    cases.edge({0, 0}, {8 * t, 8 * t});

    cases.begin("negative_and_odd_sums", noise, true);
    for (int32_t x = -3; x <= 3; ++x) cases.edge({x, -x}, {x + 2 * t + 1, 3 * t - x});

    cases.begin("outside", noise, false);  // boxes beside a clamped map: clipped to nothing
    cases.edge({-6 * t, -6 * t}, {-2 * t, -t});
    cases.edge({9 * t, 9 * t}, {14 * t, 11 * t});
    cases.edge({-4 * t, 4 * t}, {12 * t, 4 * t});

    cases.begin("longest", noise, true);  // two periods: a box of one
    cases.edge({-4 * t, -4 * t}, {12 * t, 12 * t});
    cases.edge({-4 * t, 0}, {12 * t, 0});

    cases.begin("skipped", noise, false);
    cases.edge({0, 0}, {8 * t, 8 * t}, true);
    cases.edge({0, 0}, {8 * t, 0}, false);
    cases.edge({0, 0}, {8 * t, 8 * t}, true);
    return cases.take();
}

}  // namespace repousse::cosim

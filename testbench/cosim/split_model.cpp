#include "datapath/units/split.h"

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

constexpr uint8_t kAll = 7;

/// Edges to split in a triangle that is split along just these.
SplitIn split_along(uint8_t edges) { return {kAll, kAll, kAll, edges, 0, {}}; }

class SplitModel : public UnitModel {
public:
    explicit SplitModel(const Profile& profile) : UnitModel(profile, kSplitDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kSplitDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(scenario.config.at(0) != 0);
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
            const SplitBeats item = unit_(SplitIn::unpack(&scenario.inputs[i]));
            for (std::size_t b = 0; b < static_cast<std::size_t>(item.count); ++b) {
                for (const int64_t word : item.beats[b].pack()) outputs.push_back(word);
            }
        }
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_split_model(profile);
    }

    /// s1.1 positions; diagonals of two bits, which drop a bit and saturate.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.position.width = 3, tiny.position.frac = 1;
        tiny.diagonal.width = 2, tiny.diagonal.frac = 0;
        return tiny;
    }

private:
    int32_t most() const { return static_cast<int32_t>(profile().position.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile().position.min_raw()); }
    SplitIn quad(uint8_t unsplit_edge, const Vec3<int32_t>& d1, const Vec3<int32_t>& d2) const;
    Scenario every_decision(uint64_t portion) const;
    Scenario every_diagonal(uint64_t portion) const;

    Split<Fixed> unit_;
};

/// Two split edges, with A - M1 = d1 and B - M2 = d2.
SplitIn SplitModel::quad(uint8_t unsplit_edge, const Vec3<int32_t>& d1,
                         const Vec3<int32_t>& d2) const {
    const unsigned i = unsplit_edge;
    SplitIn in = split_along(static_cast<uint8_t>(kAll & ~(1U << i)));
    in.displaced[i] = d1;                   // A; M1 at the origin
    in.displaced[(i + 1) % 3] = d2;         // B; M2 at the origin
    in.displaced[(i + 2) % 3] = {1, 1, 1};  // C, which does not matter
    return in;
}

std::vector<Scenario> SplitModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name, bool has_surface_test = true) {
        cases.push_back({name, {has_surface_test}, nullptr, {}});
    };
    const auto add = [&cases](const SplitIn& in) { cases.back().add(in); };

    begin("every_pattern");
    for (uint8_t edges = 0; edges < 8; ++edges) add(split_along(edges));

    begin("each_condition_alone");  // each one missing keeps the edge
    for (uint8_t edge = 1; edge < 8; edge = static_cast<uint8_t>(edge * 2)) {
        add({edge, kAll, kAll, kAll, 0, {}});
        add({kAll, edge, kAll, kAll, 0, {}});
        add({kAll, kAll, edge, kAll, 0, {}});
        add({kAll, kAll, kAll, edge, 0, {}});
        add({kAll, kAll, kAll, 0, edge, {}});
        add({kAll, kAll, kAll, edge, static_cast<uint8_t>(kAll & ~edge), {}});
    }

    begin("no_surface_test", false);  // every edge counts as detailed
    for (uint8_t edges = 0; edges < 8; ++edges) add({edges, kAll, kAll, 0, 0, {}});
    add({0, kAll, kAll, kAll, kAll, {}});

    begin("surface_test_says_no");
    add({kAll, kAll, kAll, 0, 0, {}});

    const auto diagonals = [&](const Vec3<int32_t>& d1, const Vec3<int32_t>& d2) {
        for (uint8_t edge = 0; edge < 3; ++edge) {
            add(quad(edge, d1, d2));
            add(quad(edge, d2, d1));
        }
    };
    const int32_t one = 1 << profile().position.frac;
    begin("equal_diagonals");  // the first one wins
    diagonals({}, {});
    diagonals({one, 0, 0}, {0, -one, 0});
    diagonals({one, -one, 2 * one}, {2 * one, one, one});
    begin("diagonals_one_lsb_apart");
    diagonals({one, 0, 0}, {one + 1, 0, 0});
    diagonals({one, one, one}, {one, one, one - 1});
    diagonals({-one, 0, 0}, {0, 0, -one - 1});  // truncated downwards, where a cast drops bits
    begin("saturated_diagonals");               // beyond the format they are as long as each other
    diagonals({most(), 0, 0}, {0, most() - 1, 0});
    diagonals({least(), 0, 0}, {0, least() + 1, 0});
    diagonals({most(), most(), most()}, {least(), least(), least()});
    begin("longest_differences");
    SplitIn in = split_along(6);
    in.displaced = {Vec3<int32_t>{most(), most(), most()}, {least(), least(), least()}, {}, {},
                    {least(), least(), least()},           {most(), most(), most()}};
    add(in);
    in.displaced[1] = {};
    in.displaced[5] = {};
    add(in);
    return cases;
}

Scenario SplitModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {random.percent(85)}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    const auto bits = [&random](uint32_t percent) {
        return static_cast<uint8_t>(random.percent(percent) ? kAll : random.below(8));
    };
    for (std::size_t i = 0; i < count; ++i) {
        SplitIn in{bits(60), bits(60), bits(60), bits(30), bits(30), {}};
        if (random.percent(50)) {  // a quad for certain
            in = split_along(static_cast<uint8_t>(kAll & ~(1U << random.below(3))));
            in.sht = s.config[0] == 0 ? kAll : 0;
            if (s.config[0] == 0) in.eligible = in.nt;
        }
        // Coordinates within a span of any length about a point: short diagonals and long ones.
        const int reach =
            static_cast<int>(random.below(static_cast<uint32_t>(profile().position.width)));
        const int64_t about = random.between(least(), most());
        for (Vec3<int32_t>& p : in.displaced) {
            for (int32_t* c : {&p.x, &p.y, &p.z}) {
                const int64_t x = (about >> random.below(2)) +
                                  random.between(-(int64_t{1} << reach), int64_t{1} << reach);
                *c = static_cast<int32_t>(x < least() ? least() : x > most() ? most() : x);
            }
        }
        // Diagonals that differ by an LSB, or by which component is which.
        if (random.percent(40)) {
            const Vec3<int32_t> a = in.displaced[0];
            in.displaced[1] = random.percent(50) ? a : Vec3<int32_t>{a.y, a.x, a.z};
            in.displaced[2] = {a.x, a.z, a.y};
            in.displaced[4] = in.displaced[5] = in.displaced[3];
            if (random.percent(50)) in.displaced[4].x ^= 1;
        }
        s.add(in);
    }
    return s;
}

/// All decisions of three edges, under both registers, with 2^8 placements of the six points.
Scenario SplitModel::every_decision(uint64_t portion) const {
    Scenario s{"exhaustive", {static_cast<int64_t>(portion >> 8)}, nullptr, {}};
    const auto place = [portion](int bit, int32_t low, int32_t high) {
        return (portion >> bit & 1) != 0 ? high : low;
    };
    for (uint64_t i = 0; i < uint64_t{1} << 15; ++i) {
        const auto three = [i](int at) { return static_cast<uint8_t>(i >> at & 7); };
        SplitIn in{three(0), three(3), three(6), three(9), three(12), {}};
        for (int p = 0; p < 6; ++p) in.displaced[static_cast<std::size_t>(p)].x = place(p, -1, 1);
        in.displaced[0].y = place(6, 0, 3);
        in.displaced[4].y = place(7, 0, 3);
        s.add(in);
    }
    return s;
}

/// For each of the three quads, x of the four ends of its diagonals, y of A and B, z of M2.
Scenario SplitModel::every_diagonal(uint64_t portion) const {
    const auto edge = static_cast<unsigned>(portion >> 4);
    Scenario s{"exhaustive", {1}, nullptr, {}};
    for (uint64_t i = 0; i < uint64_t{1} << 17; ++i) {
        const uint64_t all = (portion & 15) << 17 | i;
        const auto word = [all](int place) {
            return static_cast<int32_t>(static_cast<uint32_t>(all >> 3 * place & 7) << 29) >> 29;
        };
        SplitIn in = split_along(static_cast<uint8_t>(kAll & ~(1U << edge)));
        in.displaced[edge] = {word(0), word(4), 0};
        in.displaced[(edge + 1) % 3] = {word(1), word(5), 0};
        in.displaced[3 + (edge + 1) % 3] = {word(2), 0, 0};
        in.displaced[3 + (edge + 2) % 3] = {word(3), 0, word(6)};
        s.add(in);
    }
    return s;
}

Scenario SplitModel::exhaustive(uint64_t portion) const {
    if (portion < 512) return every_decision(portion);
    if (portion < 512 + 48) return every_diagonal(portion - 512);
    return {};
}

}  // namespace

std::unique_ptr<UnitModel> make_split_model(const Profile& profile) {
    return std::make_unique<SplitModel>(profile);
}

}  // namespace repousse::cosim

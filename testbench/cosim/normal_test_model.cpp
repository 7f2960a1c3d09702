#include <algorithm>
#include <array>

#include "datapath/numbers/policy.h"
#include "datapath/units/normal_test.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

constexpr std::array kComponents = {&Vec3<int32_t>::x, &Vec3<int32_t>::y, &Vec3<int32_t>::z};

class NormalTestModel : public UnitModel {
public:
    explicit NormalTestModel(const Profile& profile)
        : UnitModel(profile, kNormalTestDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kNormalTestDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(static_cast<int32_t>(scenario.config.at(0)),
                        scenario.config.at(1) != 0 ? NormalSpace::Map : NormalSpace::World);
        answer_each(scenario, outputs,
                    [this](const Word* in) { return unit_(NormalTestIn::unpack(in)).pack(); });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_normal_test_model(profile);
    }

    /// Three bits for each kind of normal, each with another number of fraction bits.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.displaced_normal.width = 3, tiny.displaced_normal.frac = 1;
        tiny.map_normal.width = 3, tiny.map_normal.frac = 0;
        tiny.normal.width = 3, tiny.normal.frac = 2;
        return tiny;
    }

private:
    /// One of the three normals of a vertex, with its format.
    struct Kind {
        Vec3<int32_t> VertexNormals::*normal;
        Format format;
    };
    std::array<Kind, 3> kinds() const {
        return {Kind{&VertexNormals::displaced_normal, profile().displaced_normal},
                Kind{&VertexNormals::map_normal, profile().map_normal},
                Kind{&VertexNormals::normal, profile().normal}};
    }

    /// The threshold in LSB of a kind, rounded down.
    int64_t threshold_of(const Kind& kind, int64_t threshold) const {
        return Fixed::align(threshold, kind.format.frac - profile().displaced_normal.frac);
    }
    int64_t max_threshold() const { return (int64_t{1} << profile().displaced_normal.width) - 1; }

    NormalTest<Fixed> unit_;
};

std::vector<Scenario> NormalTestModel::hard_cases() const {
    std::vector<Scenario> cases;
    const int64_t one = int64_t{1} << profile().displaced_normal.frac;
    const auto begin = [&cases](const std::string& name, int64_t threshold, NormalSpace space) {
        cases.push_back({name, {threshold, space == NormalSpace::Map}, nullptr, {}});
    };
    const auto edge = [&cases](NormalTestIn in) {
        cases.back().add(in);
        std::swap(in.vertices[0], in.vertices[1]);  // from the other side
        cases.back().add(in);
    };
    // Each kind, component, end and sign alone, `d` LSB away from the midpoint.
    const auto each = [&](int64_t beyond, int64_t threshold, bool skip) {
        for (const Kind& kind : kinds()) {
            for (int32_t Vec3<int32_t>::*component : kComponents) {
                for (const int sign : {-1, 1}) {
                    NormalTestIn in{skip, {}};
                    const int64_t d = threshold_of(kind, threshold) + beyond;
                    // The difference is reached from below zero, so that it fits.
                    const int64_t from = -sign * std::min(d / 2, kind.format.max_raw());
                    for (VertexNormals& v : in.vertices) {
                        (v.*kind.normal).*component = limited(kind.format, from);
                    }
                    (in.vertices[0].*kind.normal).*component =
                        limited(kind.format, from + sign * d);
                    edge(in);
                }
            }
        }
    };
    const auto both = [&](const char* name, int64_t threshold, const auto& fill) {
        for (const NormalSpace space : {NormalSpace::World, NormalSpace::Map}) {
            begin(std::string(name) + (space == NormalSpace::Map ? "_map_space" : ""), threshold,
                  space);
            fill();
        }
    };

    both("threshold_zero", 0, [&] {
        edge({});  // equal normals do not split
        each(1, 0, false);
    });
    // Strictly greater. An odd threshold, so that a coarser N_D does not see its lowest bit.
    const int64_t middle = one / 4 + 1;
    both("threshold_equal", middle, [&] {
        for (const int64_t beyond : {-1, 0, 1}) each(beyond, middle, false);
    });
    const auto opposite = [&](int64_t ends) {
        NormalTestIn in;
        for (std::size_t i = 0; i < in.vertices.size(); ++i) {
            for (const Kind& kind : kinds()) {
                const auto c = limited(kind.format,
                                       (i == 2 ? -ends : ends) * (int64_t{1} << kind.format.frac));
                in.vertices[i].*kind.normal = {c, c, c};
            }
        }
        edge(in);
    };
    both("opposite_normals", 2 * one - 1, [&] { opposite(1); });
    both("opposite_is_not_more_than_two", 2 * one, [&] { opposite(1); });
    both("ends_of_the_formats", max_threshold() - 1, [&] {  // |d| = 2^W - 1 is the most there is
        opposite(2);
        opposite(-2);
    });
    both("threshold_max", max_threshold(), [&] {
        opposite(2);
        opposite(-2);
    });
    both("skipped", 0, [&] {
        each(1, 0, true);
        each(one, 0, true);
    });
    return cases;
}

Scenario NormalTestModel::random(Random& random, std::size_t count) const {
    const auto bits = profile().displaced_normal.width;
    const auto threshold =
        static_cast<int64_t>(random.percent(90)   ? random.of_any_length(bits)
                             : random.percent(50) ? 0
                                                  : static_cast<uint64_t>(max_threshold()));
    const bool map_space = random.percent(50);
    Scenario s{"random", {threshold, map_space}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    const auto sides = kinds();
    for (std::size_t i = 0; i < count; ++i) {
        NormalTestIn in;
        in.skip = random.percent(5);
        const bool anywhere = random.percent(10);
        for (const Kind& kind : sides) {
            const int64_t t = threshold_of(kind, threshold);
            for (int32_t Vec3<int32_t>::*component : kComponents) {
                const int64_t mid = random.between(kind.format.min_raw(), kind.format.max_raw());
                (in.vertices[2].*kind.normal).*component = static_cast<int32_t>(mid);
                for (std::size_t end = 0; end < 2; ++end) {
                    // On the threshold or just below it, seldom one beyond: about every second
                    // edge is to pass.
                    const int64_t d = t + (random.percent(6) ? 1 : -int64_t{random.below(2)});
                    const int64_t near = mid > 0 ? mid - d : mid + d;
                    const int64_t far =
                        random.between(kind.format.min_raw(), kind.format.max_raw());
                    (in.vertices[end].*kind.normal).*component =
                        limited(kind.format, anywhere ? far : near);
                }
            }
        }
        s.add(in);
    }
    return s;
}

/// x of all three vertices, y of end 1 and z of end 2 against the midpoint's: 2^20 edges for each
/// threshold, of N' in world space, of N_D and of N in map space; z of the midpoint is not
/// negative.
Scenario NormalTestModel::exhaustive(uint64_t portion) const {
    constexpr int kPortionBits = 17;
    const uint64_t high = portion & 7;  // the other three of 20 bits
    const uint64_t threshold = portion >> 3 & 7;
    const uint64_t kind = portion >> 6;
    if (kind >= 3) return {};
    Scenario s{"exhaustive", {static_cast<int64_t>(threshold), kind != 0}, nullptr, {}};
    const auto sides = kinds();
    for (uint64_t i = 0; i < uint64_t{1} << kPortionBits; ++i) {
        const uint64_t all = high << kPortionBits | i;
        const auto word = [all](int place) {
            return static_cast<int32_t>(static_cast<uint32_t>(all >> 3 * place & 7) << 29) >> 29;
        };
        const Vec3<int32_t> end1{word(0), word(3), 0};
        const Vec3<int32_t> end2{word(1), 0, word(5)};
        const Vec3<int32_t> mid{word(2), word(4), word(6)};
        NormalTestIn in;
        const std::array vectors = {end1, end2, mid};
        for (std::size_t v = 0; v < vectors.size(); ++v) {
            in.vertices[v].*sides[kind].normal = vectors[v];
        }
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_normal_test_model(const Profile& profile) {
    return std::make_unique<NormalTestModel>(profile);
}

}  // namespace repousse::cosim

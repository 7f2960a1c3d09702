#include <utility>

#include "datapath/numbers/policy.h"
#include "datapath/units/mid_vertex.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

constexpr uint8_t kMostGeneration = 14;  // of an end: its midpoint's must fit four bits

class MidVertexModel : public UnitModel {
public:
    explicit MidVertexModel(const Profile& profile)
        : UnitModel(profile, kMidVertexDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kMidVertexDesc; }
    uint64_t weight() const override { return 4; }
    uint64_t icarus_weight() const override { return 10; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        answer_each(scenario, outputs,
                    [this](const Word* in) { return unit_(MidVertexIn::unpack(in)).pack(); });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_mid_vertex_model(profile);
    }

    /// Components of 4 bits, whose sums lose one and saturate.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 4, tiny.uv.frac = 1;
        tiny.position.width = 4, tiny.position.frac = 1;
        tiny.normal.width = 4, tiny.normal.frac = 2;
        tiny.unnormalised.width = 4, tiny.unnormalised.frac = 1;
        return tiny;
    }

private:
    using Vector = Vec3<int32_t>;
    int32_t one() const { return 1 << profile().normal.frac; }
    static Vector any_vector(Random& random, const Format& format) {
        return {any_raw(random, format), any_raw(random, format), any_raw(random, format)};
    }
    /// Both ends' tangents are their normals, turned.
    static void add(Scenario& s, MidVertexIn in) {
        for (MidVertexEnd& end : in.ends) end.t = {end.n.z, end.n.x, end.n.y};
        s.add(in);
        std::swap(in.ends[0], in.ends[1]);  // from the other side
        s.add(in);
    }

    MidVertex<Fixed> unit_;
};

std::vector<Scenario> MidVertexModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name) { cases.push_back({name, {}, nullptr, {}}); };
    const auto normals = [&cases](const Vector& a, const Vector& b) {
        MidVertexIn in;
        in.ends[0].n = a;
        in.ends[1].n = b;
        add(cases.back(), in);
    };
    const auto places = [&cases](int64_t a, int64_t b, const Format& uv, const Format& position) {
        MidVertexIn in;
        for (std::size_t i = 0; i < 2; ++i) {
            const int64_t x = i == 0 ? a : b;
            in.ends[i].u = {limited(uv, x), limited(uv, ~x)};
            in.ends[i].p = {limited(position, x), limited(position, ~x), limited(position, x >> 1)};
        }
        add(cases.back(), in);
    };
    const Format& uv = profile().uv;
    const Format& position = profile().position;
    const int64_t most = position.max_raw();
    const auto least_n = static_cast<int32_t>(profile().normal.min_raw());
    const auto most_n = static_cast<int32_t>(profile().normal.max_raw());

    begin("odd_sums");  // floored, also below zero, from both sides alike
    for (int64_t a = -3; a <= 3; ++a) {
        for (int64_t b = -2; b <= 3; ++b) places(a, b, uv, position);
    }
    begin("ends_of_the_formats");  // the sums have a bit more
    for (const int64_t a : {most, -most - 1}) {
        for (const int64_t b : {most, -most - 1, int64_t{0}, int64_t{1}})
            places(a, b, uv, position);
    }
    begin("generations_and_handedness");
    for (const uint8_t a : {uint8_t{0}, uint8_t{1}, uint8_t{7}, kMostGeneration}) {
        for (const bool left : {false, true}) {
            MidVertexIn in;
            in.ends[0].generation = a, in.ends[1].generation = 1;
            in.ends[0].left = left;
            add(cases.back(), in);
            in.ends[1].left = true;
            add(cases.back(), in);
        }
    }
    begin("equal_normals");  // axes do not drift
    for (const int32_t c : {one(), -one()}) {
        normals({c, 0, 0}, {c, 0, 0});
        normals({0, c, 0}, {0, c, 0});
        normals({0, 0, c}, {0, 0, c});
    }
    begin("antiparallel_normals");  // no direction: the zero vector
    for (const Vector& n : {Vector{one(), 0, 0}, Vector{0, -one(), 0}, Vector{3, -5, 7}}) {
        normals(n, {-n.x, -n.y, -n.z});
    }
    begin("nearly_antiparallel");  // one LSB is left, which is a direction
    for (const int32_t d : {1, -1}) {
        normals({one(), 0, 0}, {-one() + d, 0, 0});
        normals({one(), d, 0}, {-one(), 0, 0});
        normals({one() - 1, d, -d}, {1 - one(), d, d});
    }
    begin("zero_normals");  // what opposite normals have left further up
    normals({}, {});
    normals({}, {one(), 0, 0});
    normals({0, -1, 0}, {});
    begin("longest_normals");  // |min| + |min| does not saturate in `unnormalised`
    normals({least_n, least_n, least_n}, {least_n, least_n, least_n});
    normals({most_n, most_n, most_n}, {most_n, most_n, most_n});
    normals({least_n, most_n, 0}, {least_n, most_n, 1});
    return cases;
}

Scenario MidVertexModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        MidVertexIn in;
        for (MidVertexEnd& end : in.ends) {
            end.u = {any_raw(random, profile().uv), any_raw(random, profile().uv)};
            end.generation = static_cast<uint8_t>(random.below(kMostGeneration + 1));
            end.p = any_vector(random, profile().position);
            end.n = any_vector(random, profile().normal);
            end.t = any_vector(random, profile().normal);
            end.left = random.percent(50);
        }
        if (random.percent(20)) {  // opposite, but for an LSB now and then
            const Format& normal = profile().normal;
            const auto limit = [&normal](int64_t x) { return limited(normal, x); };
            const Vector& n = in.ends[0].n;
            const int64_t d = random.between(-1, 1);
            in.ends[1].n = {limit(d - n.x), limit(-int64_t{n.y}), limit(-int64_t{n.z})};
        }
        s.add(in);
    }
    return s;
}

/// All pairs of normals: 2^24. The tangents are others of them, and so are places, generations and
/// handedness.
Scenario MidVertexModel::exhaustive(uint64_t portion) const {
    if (portion >= 256 || profile().normal.width != 4) return {};
    Scenario s{"exhaustive", {}, nullptr, {}};
    s.inputs.reserve(inputs() << 16);
    for (uint64_t i = 0; i < uint64_t{1} << 16; ++i) {
        const uint64_t all = portion << 16 | i;
        const auto word = [all](unsigned place) {
            return static_cast<int32_t>(static_cast<uint32_t>(all >> (place % 24) & 15) << 28) >>
                   28;
        };
        MidVertexIn in;
        for (unsigned e = 0; e < 2; ++e) {
            MidVertexEnd& end = in.ends[e];
            const unsigned at = 12 * e;
            end.n = {word(at), word(at + 4), word(at + 8)};
            end.t = {word(at + 5), word(at + 9), word(at + 13)};
            end.u = {word(at), word(at + 4)};
            end.p = {word(at + 8), word(at + 1), word(at + 6)};
            end.generation = static_cast<uint8_t>((all >> at & 15) % (kMostGeneration + 1));
            end.left = (all >> (at + 7) & 1) != 0;
        }
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_mid_vertex_model(const Profile& profile) {
    return std::make_unique<MidVertexModel>(profile);
}

}  // namespace repousse::cosim

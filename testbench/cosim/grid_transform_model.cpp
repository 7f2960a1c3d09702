#include <algorithm>
#include <vector>

#include "datapath/units/grid_transform.h"
#include "testbench/cosim/grid_transform_cases.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class GridTransformModel : public UnitModel {
public:
    explicit GridTransformModel(const Profile& profile)
        : UnitModel(profile, kGridTransformDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kGridTransformDesc; }
    bool reads_table() const override { return has_depth_words(profile()); }
    std::vector<Scenario> hard_cases() const override { return grid_transform_cases(profile()); }
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;
    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override;

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_grid_transform_model(profile);
    }

    /// s3.0 and s2.1: 2^4 values for each of x, y, w and the attribute.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        const auto narrow = [](Format& format, int width, int frac) {
            format.width = width;
            format.frac = frac;
        };
        narrow(tiny.position, 4, 0);
        narrow(tiny.clip, 4, 1);
        narrow(tiny.ndc, 9, 5);
        narrow(tiny.focal, 8, 2);
        narrow(tiny.sweep_data, 6, 2);
        narrow(tiny.inverse_w, 8, 6);
        narrow(tiny.steps_per_octave, 8, 2);
        tiny.z_table_index_bits = 2;
        tiny.reciprocal_index_bits = 4;
        tiny.reciprocal_newton_steps = 1;
        tiny.reciprocal_bits = 8;
        return tiny;
    }

private:
    GridTransformWords anything(Random& random) const;

    GridTransform<Fixed> unit_;
    std::vector<uint32_t> words_;  // of the scenario's table
};

void GridTransformModel::evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) {
    const std::vector<int64_t>& c = scenario.config;
    GridRegisters<Fixed> r;
    r.w_min = static_cast<int32_t>(c.at(0));
    r.w_scale = static_cast<int32_t>(c.at(1));
    r.focal_x = static_cast<int32_t>(c.at(2));
    r.focal_y = static_cast<int32_t>(c.at(3));
    r.steps_per_octave = static_cast<int32_t>(c.at(4));
    r.log2_near = static_cast<int32_t>(c.at(5));
    r.table_near = static_cast<int32_t>(c.at(6));
    r.table_scale = static_cast<uint32_t>(c.at(7));
    r.table_shift = static_cast<uint8_t>(c.at(8));
    if (scenario.table != nullptr) {
        words_.assign(scenario.table->entries.begin(), scenario.table->entries.end());
        r.table = words_;
    }
    unit_.configure(r);
    answer_each(scenario, outputs, [this](const Word* words) {
        const GridTransformIn in = GridTransformIn::unpack(words);
        GridTransformOut out;
        out.point = unit_(in.eye);
        out.data = unit_.scale_position(in.attribute, out.point.c);
        return out.pack();
    });
}

GridTransformWords GridTransformModel::anything(Random& random) const {
    const Profile& p = profile();
    const auto positive = [&random](const Format& format) {
        const uint64_t raw = random.of_any_length(format.width - (format.is_signed ? 1 : 0));
        return std::max<int64_t>(1, static_cast<int64_t>(raw));
    };
    const auto either_sign = [&](const Format& format) {
        return random.percent(50) ? positive(format) : -positive(format);
    };
    if (random.percent(20)) return usual_grid_transform(p);
    GridTransformWords r{};
    r.w_min = positive(p.clip);
    r.w_scale = random.percent(50) ? std::min(r.w_min * 2, p.clip.max_raw()) : positive(p.clip);
    r.focal_x = either_sign(p.focal);
    r.focal_y = either_sign(p.focal);
    r.steps_per_octave = positive(p.steps_per_octave);
    // Between the least and the largest logarithm of the format.
    constexpr int64_t kOctave = int64_t{1} << OctaveLog2::kFractionBits;
    r.log2_near = kOctave * random.between(-p.clip.frac, p.clip.width - 2 - p.clip.frac) +
                  random.between(0, kOctave - 1);
    r.table_near = either_sign(p.clip);
    r.table_scale = random.between(1 << (kUniformScaleBits - 1), (1 << kUniformScaleBits) - 1);
    r.table_shift =
        std::clamp<int64_t>(usual_grid_transform(p).table_shift + random.between(-12, 4), 0, 63);
    return r;
}

Scenario GridTransformModel::random(Random& random, std::size_t count) const {
    const Profile& p = profile();
    const GridTransformWords r = anything(random);
    Scenario s{"random", r.pack(), random_depths(p, random), {}};
    s.inputs.reserve(count * inputs());
    const auto signed_value = [&random](const Format& format) {
        const auto raw = static_cast<int64_t>(random.of_any_length(format.width - 1));
        return static_cast<int32_t>(random.percent(50) ? raw : -raw - 1);
    };
    for (std::size_t i = 0; i < count; ++i) {
        GridTransformIn in;
        in.attribute = signed_value(p.position);
        int64_t w = static_cast<int64_t>(random.of_any_length(p.clip.width - 1));
        if (random.percent(10)) w = r.w_min + random.between(-2, 2);
        if (random.percent(10)) w = r.w_scale + random.between(-2, 2);
        if (random.percent(5)) w = -w;
        in.eye.w = limited(p.clip, w);
        // Half of the vertices within the view, at most |w| from its axis.
        const bool visible = random.percent(50);
        const int64_t reach = std::max<int64_t>(1, std::min<int64_t>(std::abs(w), 1 << 30));
        in.eye.x = visible ? limited(p.clip, random.between(-reach, reach)) : signed_value(p.clip);
        in.eye.y = visible ? limited(p.clip, random.between(-reach, reach)) : signed_value(p.clip);
        s.add(in);
    }
    return s;
}

Scenario GridTransformModel::exhaustive(uint64_t portion) const {
    constexpr uint64_t kSettings = 256;
    if (portion >= kSettings) return {};
    Random random(11, portion);
    Scenario s{"exhaustive", anything(random).pack(), random_depths(profile(), random), {}};
    const auto word = [](uint64_t bits, int width) {
        const int spare = 32 - width;
        return static_cast<int32_t>(static_cast<uint32_t>(bits) << spare) >> spare;
    };
    const int width = profile().clip.width;
    const int attribute = profile().position.width;
    for (uint64_t i = 0; i < uint64_t{1} << (3 * width + attribute); ++i) {
        s.add(
            GridTransformIn{{word(i, width), word(i >> width, width), word(i >> 2 * width, width)},
                            word(i >> 3 * width, attribute)});
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_grid_transform_model(const Profile& profile) {
    return std::make_unique<GridTransformModel>(profile);
}

}  // namespace repousse::cosim

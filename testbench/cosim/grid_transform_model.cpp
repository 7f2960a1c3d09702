#include <algorithm>
#include <vector>

#include "datapath/units/grid_transform.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class GridTransformModel : public UnitModel {
public:
    explicit GridTransformModel(const Profile& profile)
        : UnitModel(profile, kGridTransformDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kGridTransformDesc; }
    bool reads_table() const override {
        return static_cast<ZTableKind>(profile().z_table_kind) == ZTableKind::Uniform;
    }
    std::vector<Scenario> hard_cases() const override;
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
    /// The registers in the order of the description.
    struct Registers {
        int64_t w_min, w_scale, focal_x, focal_y, steps_per_octave;
        int64_t log2_near, table_near, table_scale, table_shift;

        std::vector<int64_t> pack() const {
            return {w_min,     w_scale,    focal_x,     focal_y,    steps_per_octave,
                    log2_near, table_near, table_scale, table_shift};
        }
    };

    Registers usual() const;
    Registers anything(Random& random) const;
    std::shared_ptr<const Table> table(Random& random) const;
    Scenario begin(const char* name, const Registers& registers) const;

    int64_t w_end() const { return profile().clip.max_raw(); }
    int32_t clip(int64_t raw) const {
        return static_cast<int32_t>(std::clamp(raw, profile().clip.min_raw(), w_end()));
    }
    /// Depths on both sides of each octave's and piece's border, as far as the format goes.
    std::vector<int64_t> depth_borders() const;

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
    outputs.clear();
    for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
        const GridTransformIn in = GridTransformIn::unpack(&scenario.inputs[i]);
        GridTransformOut out;
        out.point = unit_(in.eye);
        out.data = unit_.scale_position(in.attribute, out.point.c);
        for (const int64_t word : out.pack()) outputs.push_back(word);
    }
}

/// A camera: near at 1/2, 64 grid units per unit of x/w, as many steps an octave; the uniform table
/// covers all depths.
GridTransformModel::Registers GridTransformModel::usual() const {
    const Profile& p = profile();
    const int64_t half = std::max<int64_t>(1, (int64_t{1} << p.clip.frac) / 2);
    const auto at_most = [](int64_t value, const Format& format) {
        return std::min(value, format.max_raw());
    };
    Registers r{};
    r.w_min = half;
    r.w_scale = std::min(2 * half, w_end());
    r.focal_x = at_most(int64_t{64} << p.focal.frac, p.focal);
    r.focal_y = -r.focal_x;
    r.steps_per_octave = at_most(int64_t{45} << p.steps_per_octave.frac, p.steps_per_octave);
    r.log2_near = -(int64_t{1} << OctaveLog2::kFractionBits);
    r.table_near = half;
    r.table_scale = int64_t{1} << (kUniformScaleBits - 1);
    // 2^(width - 1) LSB of w are 2^(index_bits + 16) places.
    const int places = p.z_table_index_bits + kUniformFractionBits;
    r.table_shift = std::max(0, kUniformScaleBits - 1 + p.clip.width - 1 - places);
    return r;
}

GridTransformModel::Registers GridTransformModel::anything(Random& random) const {
    const Profile& p = profile();
    const auto positive = [&random](const Format& format) {
        const uint64_t raw = random.of_any_length(format.width - (format.is_signed ? 1 : 0));
        return std::max<int64_t>(1, static_cast<int64_t>(raw));
    };
    const auto either_sign = [&](const Format& format) {
        return random.percent(50) ? positive(format) : -positive(format);
    };
    if (random.percent(20)) return usual();
    Registers r{};
    r.w_min = positive(p.clip);
    r.w_scale = random.percent(50) ? std::min(r.w_min * 2, w_end()) : positive(p.clip);
    r.focal_x = either_sign(p.focal);
    r.focal_y = either_sign(p.focal);
    r.steps_per_octave = positive(p.steps_per_octave);
    // Between the least and the largest logarithm of the format.
    constexpr int64_t kOctave = int64_t{1} << OctaveLog2::kFractionBits;
    r.log2_near = kOctave * random.between(-p.clip.frac, p.clip.width - 2 - p.clip.frac) +
                  random.between(0, kOctave - 1);
    r.table_near = either_sign(p.clip);
    r.table_scale = random.between(1 << (kUniformScaleBits - 1), (1 << kUniformScaleBits) - 1);
    r.table_shift = std::clamp<int64_t>(usual().table_shift + random.between(-12, 4), 0, 63);
    return r;
}

std::shared_ptr<const Table> GridTransformModel::table(Random& random) const {
    if (!reads_table()) return nullptr;
    const std::size_t count = (std::size_t{1} << profile().z_table_index_bits) + 1;
    auto made = std::make_shared<Table>();
    made->width = static_cast<int>(count) - 1;
    for (std::size_t i = 0; i < count; ++i) made->entries.push_back(random.of_any_length(22));
    std::sort(made->entries.begin(), made->entries.end());
    return made;
}

Scenario GridTransformModel::begin(const char* name, const Registers& registers) const {
    Random random(7);
    return {name, registers.pack(), table(random), {}};
}

std::vector<int64_t> GridTransformModel::depth_borders() const {
    std::vector<int64_t> depths;
    const auto around = [&](int64_t w) {
        for (int64_t d = -1; d <= 1; ++d) {
            if (w + d > 0 && w + d <= w_end()) depths.push_back(w + d);
        }
    };
    const int pieces = std::min(profile().z_table_index_bits, 3);
    for (int octave = 0; octave < profile().clip.width - 1; ++octave) {
        const int64_t w = int64_t{1} << octave;
        around(w);
        for (int64_t i = 1; octave % 5 == 4 && i >> pieces == 0; ++i) around(w + (w * i >> pieces));
    }
    return depths;
}

std::vector<Scenario> GridTransformModel::hard_cases() const {
    const Profile& p = profile();
    const Registers camera = usual();
    const int64_t one = std::min(int64_t{1} << p.clip.frac, w_end());
    const int32_t attribute = static_cast<int32_t>(p.position.max_raw() / 3);
    std::vector<Scenario> cases;
    const auto vertex = [&](int64_t x, int64_t y, int64_t w, int32_t a) {
        cases.back().add(GridTransformIn{{clip(x), clip(y), clip(w)}, a});
    };

    cases.push_back(begin("w_at_its_clamp", camera));
    for (int64_t d = -2; d <= 2; ++d) {
        vertex(one / 3, -one / 5, camera.w_min + d, attribute);
        vertex(0, 0, camera.w_min + d, -attribute);
    }

    cases.push_back(begin("through_the_eye_and_behind", camera));
    for (const int64_t w : {int64_t{0}, int64_t{-1}, -one, p.clip.min_raw()}) {
        vertex(0, 0, w, attribute);
        vertex(one, -one, w, attribute);
    }

    cases.push_back(begin("octaves_and_pieces", camera));
    for (const int64_t w : depth_borders()) vertex(w / 2, -w / 3, w, attribute);

    cases.push_back(begin("c_at_one", camera));
    for (int64_t d = -2; d <= 2; ++d) {
        vertex(0, 0, camera.w_scale + d, static_cast<int32_t>(p.position.max_raw()));
        vertex(0, 0, camera.w_scale + d, static_cast<int32_t>(p.position.min_raw()));
    }

    // x / w = odd / 128 with a power of two as w: exact, and half-way between grid positions.
    Registers unit_focal = camera;
    unit_focal.focal_x = unit_focal.focal_y =
        std::min(int64_t{1} << p.focal.frac, p.focal.max_raw());
    cases.push_back(begin("half_way", unit_focal));
    for (int64_t odd = -5; odd <= 5; odd += 2) vertex(one * odd >> 7, one * -odd >> 7, one, 1);

    Registers steep = camera;
    steep.focal_x = p.focal.max_raw();
    steep.focal_y = p.focal.min_raw();
    steep.w_min = 1;
    steep.w_scale = w_end();
    steep.steps_per_octave = p.steps_per_octave.max_raw();
    cases.push_back(begin("range_ends", steep));
    for (const int64_t w : {int64_t{1}, int64_t{3}, one, w_end()}) {
        for (const int64_t x : {p.clip.min_raw(), int64_t{-1}, int64_t{1}, p.clip.max_raw()}) {
            vertex(x, -x - 1, w, static_cast<int32_t>(p.position.min_raw()));
            vertex(-x - 1, x, w, static_cast<int32_t>(p.position.max_raw()));
        }
    }
    return cases;
}

Scenario GridTransformModel::random(Random& random, std::size_t count) const {
    const Profile& p = profile();
    const Registers r = anything(random);
    Scenario s{"random", r.pack(), table(random), {}};
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
        in.eye.w = clip(w);
        // Half of the vertices within the view, at most |w| from its axis.
        const bool visible = random.percent(50);
        const int64_t reach = std::max<int64_t>(1, std::min<int64_t>(std::abs(w), 1 << 30));
        in.eye.x = visible ? clip(random.between(-reach, reach)) : signed_value(p.clip);
        in.eye.y = visible ? clip(random.between(-reach, reach)) : signed_value(p.clip);
        s.add(in);
    }
    return s;
}

Scenario GridTransformModel::exhaustive(uint64_t portion) const {
    constexpr uint64_t kSettings = 256;
    if (portion >= kSettings) return {};
    Random random(11, portion);
    Scenario s{"exhaustive", anything(random).pack(), table(random), {}};
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

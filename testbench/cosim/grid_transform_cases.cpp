#include "testbench/cosim/grid_transform_cases.h"

#include <algorithm>

#include "datapath/units/grid_transform.h"
#include "testbench/cosim/raw_words.h"

namespace repousse::cosim {

GridTransformWords usual_grid_transform(const Profile& profile) {
    const int64_t half = std::max<int64_t>(1, (int64_t{1} << profile.clip.frac) / 2);
    const auto at_most = [](int64_t value, const Format& format) {
        return std::min(value, format.max_raw());
    };
    GridTransformWords r{};
    r.w_min = half;
    r.w_scale = std::min(2 * half, profile.clip.max_raw());
    r.focal_x = at_most(int64_t{64} << profile.focal.frac, profile.focal);
    r.focal_y = -r.focal_x;
    r.steps_per_octave =
        at_most(int64_t{45} << profile.steps_per_octave.frac, profile.steps_per_octave);
    r.log2_near = -(int64_t{1} << OctaveLog2::kFractionBits);
    r.table_near = half;
    r.table_scale = int64_t{1} << (kUniformScaleBits - 1);
    // 2^(width - 1) LSB of w are 2^(index_bits + 16) places.
    const int places = profile.z_table_index_bits + kUniformFractionBits;
    r.table_shift = std::max(0, kUniformScaleBits - 1 + profile.clip.width - 1 - places);
    return r;
}

bool has_depth_words(const Profile& profile) {
    return static_cast<ZTableKind>(profile.z_table_kind) == ZTableKind::Uniform;
}

std::shared_ptr<const Table> random_depths(const Profile& profile, Random& random) {
    if (!has_depth_words(profile)) return nullptr;
    const std::size_t count = (std::size_t{1} << profile.z_table_index_bits) + 1;
    auto made = std::make_shared<Table>();
    made->width = static_cast<int>(count) - 1;
    for (std::size_t i = 0; i < count; ++i) made->entries.push_back(random.of_any_length(22));
    std::sort(made->entries.begin(), made->entries.end());
    return made;
}

namespace {

/// Depths on both sides of each octave's and piece's border, as far as the format goes.
std::vector<int64_t> depth_borders(const Profile& profile) {
    std::vector<int64_t> depths;
    const auto around = [&](int64_t w) {
        for (int64_t d = -1; d <= 1; ++d) {
            if (w + d > 0 && w + d <= profile.clip.max_raw()) depths.push_back(w + d);
        }
    };
    const int pieces = std::min(profile.z_table_index_bits, 3);
    for (int octave = 0; octave < profile.clip.width - 1; ++octave) {
        const int64_t w = int64_t{1} << octave;
        around(w);
        for (int64_t i = 1; octave % 5 == 4 && i >> pieces == 0; ++i) around(w + (w * i >> pieces));
    }
    return depths;
}

}  // namespace

std::vector<Scenario> grid_transform_cases(const Profile& p) {
    const GridTransformWords camera = usual_grid_transform(p);
    const int64_t one = std::min(int64_t{1} << p.clip.frac, p.clip.max_raw());
    const int32_t attribute = static_cast<int32_t>(p.position.max_raw() / 3);
    std::vector<Scenario> cases;
    const auto begin = [&](const char* name, const GridTransformWords& registers) {
        Random random(7);
        cases.push_back({name, registers.pack(), random_depths(p, random), {}});
    };
    const auto clip = [&p](int64_t raw) { return limited(p.clip, raw); };
    const auto vertex = [&](int64_t x, int64_t y, int64_t w, int32_t a) {
        cases.back().add(GridTransformIn{{clip(x), clip(y), clip(w)}, a});
    };

    begin("w_at_its_clamp", camera);
    for (int64_t d = -2; d <= 2; ++d) {
        vertex(one / 3, -one / 5, camera.w_min + d, attribute);
        vertex(0, 0, camera.w_min + d, -attribute);
    }

    begin("through_the_eye_and_behind", camera);
    for (const int64_t w : {int64_t{0}, int64_t{-1}, -one, p.clip.min_raw()}) {
        vertex(0, 0, w, attribute);
        vertex(one, -one, w, attribute);
    }

    begin("octaves_and_pieces", camera);
    for (const int64_t w : depth_borders(p)) vertex(w / 2, -w / 3, w, attribute);

    begin("c_at_one", camera);
    for (int64_t d = -2; d <= 2; ++d) {
        vertex(0, 0, camera.w_scale + d, static_cast<int32_t>(p.position.max_raw()));
        vertex(0, 0, camera.w_scale + d, static_cast<int32_t>(p.position.min_raw()));
    }

    // x / w = odd / 128 with a power of two as w: exact, and half-way between grid positions.
    GridTransformWords unit_focal = camera;
    unit_focal.focal_x = unit_focal.focal_y =
        std::min(int64_t{1} << p.focal.frac, p.focal.max_raw());
    begin("half_way", unit_focal);
    for (int64_t odd = -5; odd <= 5; odd += 2) vertex(one * odd >> 7, one * -odd >> 7, one, 1);

    GridTransformWords steep = camera;
    steep.focal_x = p.focal.max_raw();
    steep.focal_y = p.focal.min_raw();
    steep.w_min = 1;
    steep.w_scale = p.clip.max_raw();
    steep.steps_per_octave = p.steps_per_octave.max_raw();
    begin("range_ends", steep);
    for (const int64_t w : {int64_t{1}, int64_t{3}, one, p.clip.max_raw()}) {
        for (const int64_t x : {p.clip.min_raw(), int64_t{-1}, int64_t{1}, p.clip.max_raw()}) {
            vertex(x, -x - 1, w, static_cast<int32_t>(p.position.min_raw()));
            vertex(-x - 1, x, w, static_cast<int32_t>(p.position.max_raw()));
        }
    }
    return cases;
}

}  // namespace repousse::cosim

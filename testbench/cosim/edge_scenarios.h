#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "datapath/pipelines/tessellation_tests.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// Scenarios of the Tessellation Tests under construction. An edge stands in them from both sides.
class EdgeScenarios {
public:
    using Registers = AdaptiveRegisters<Fixed>;
    using In = TessellationTestsIn;
    using TablePtr = std::shared_ptr<const Table>;

    explicit EdgeScenarios(const Profile& profile) : profile_(profile) {
        Random random(2000);
        const uint64_t most = (uint64_t{1} << profile.height.width) - 1;
        map_ = prefix_sums(kMapSize, kMapSize, profile.sat_width,
                           [&](int, int) { return random.next() & most; });
    }

    int32_t texel() const { return int32_t{1} << profile_.uv.frac; }
    int64_t max_height() const { return (int64_t{1} << profile_.height.width) - 1; }

    /// All four tests, with thresholds in the middle of what they measure.
    Registers registers() const {
        Registers r;
        r.use_view_test = r.use_normal_test = r.use_height_test = true;
        r.view_threshold = std::min<int64_t>(profile_.screen.max_raw(), 100);
        r.normal_threshold = (1 << profile_.displaced_normal.frac) / 4 + 1;
        r.height_test.width = r.height_test.height = kMapSize;
        r.height_test.threshold = static_cast<uint64_t>(max_height() / 16);
        return r;
    }

    /// The tests `view`, `normal`, `height` and no others.
    Registers only(bool view, bool normal, bool height) const {
        Registers r = registers();
        r.use_view_test = view, r.use_normal_test = normal, r.use_height_test = height;
        return r;
    }

    void begin(const std::string& name, const Registers& r) {
        const auto config = pack_registers(r);
        cases_.push_back({name, {config.begin(), config.end()}, map_, {}});
    }

    void edge(In in) {
        cases_.back().add(in);
        std::swap(in.u1, in.u2), std::swap(in.p1, in.p2);
        std::swap(in.vertices[0], in.vertices[1]);
        cases_.back().add(in);
    }

    /// An edge on the map and nothing else: no length on the screen, normals all alike.
    In between(Uv u1, Uv u2) const {
        In in;
        in.u1 = u1, in.u2 = u2;
        in.u12 = {(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1};
        return in;
    }

    /// Edges of which the Tex Coord Test and, at `r`, the Summed Height Test say what is wanted.
    In found(const Registers& r, bool ct, bool sht) const {
        const TexcoordTest texcoord(profile_);
        HeightTest height(profile_);
        height.configure(r.height_test, map_->entries);
        HeightTestStats stats;
        Random random(11);
        for (;;) {
            const auto anywhere = [&] {
                return static_cast<int32_t>(random.below(unsigned(kMapSize * texel())));
            };
            const Uv u1{anywhere(), anywhere()};
            const int32_t reach = ct ? 3 * texel() : texel() / 2;
            const In in = between(u1, {u1.x + int32_t(random.below(unsigned(reach))), u1.y});
            if (texcoord(in.u1, in.u2, in.u12) == ct &&
                height(in.u1, in.u2, in.u12, stats) == sht) {
                return in;
            }
        }
    }

    const TablePtr& map() const { return map_; }
    std::vector<Scenario> take() { return std::move(cases_); }

private:
    static constexpr int kMapSize = 8;

    Profile profile_;
    TablePtr map_;
    std::vector<Scenario> cases_;
};

}  // namespace repousse::cosim

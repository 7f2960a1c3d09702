// Batches of fine vertices: `perspective`, `displace` and `bump` must make of each vertex what they
// make of it alone, and count the same, also where values leave their formats.

#include "datapath/fine_vertices.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "datapath/units/bump.h"
#include "datapath/units/displace.h"
#include "datapath/units/perspective.h"
#include "testbench/tests/support/profiles.h"

namespace repousse {
namespace {

struct Setting {
    const char* profile;
    std::vector<std::pair<std::string, std::string>> replaced;
};

/// Shipped profiles, the other normalisation, other roundings and overflows, few bits, and formats
/// that most values leave.
const Setting kSettings[] = {
    {"default", {}},
    {"narrow", {}},
    {"default", {{"normalise_kind", "1"}}},
    {"default", {{"normal", "s1.14 SC_TRN SC_SAT"}, {"position", "s15.16 SC_RND_CONV SC_SAT"}}},
    {"default", {{"unnormalised", "s2.16 SC_RND SC_WRAP"}, {"normal", "s1.14 SC_RND SC_WRAP"}}},
    {"default", {{"position", "s3.16 SC_RND SC_SAT"}, {"unnormalised", "s0.16 SC_RND SC_SAT"}}},
    {"default", {{"displacement", "s1.20 SC_RND SC_SAT"}, {"normal", "s0.14 SC_RND SC_SAT_SYM"}}},
    {"default", {{"reciprocal_newton_steps", "0"}, {"inverse_sqrt_newton_steps", "0"}}},
};

class Batches : public testing::TestWithParam<std::size_t> {
protected:
    void SetUp() override {
        map_.width = kWidth;
        map_.height = kHeight;
        map_.filter = HeightFilter::Bilinear;
        map_.scale_mantissa = 1 << 20;
        map_.scale_exponent = 24;
        heights_.resize(kWidth * kHeight);
        normals_.resize(kWidth * kHeight);
        for (auto& height : heights_) height = uint16_t(random_());
        for (auto& n : normals_) {
            n = {int16_t(random_() % 4096 - 2048), int16_t(random_() % 4096 - 2048), 1500};
        }
        map_.heights = heights_;
        map_.normals = normals_;
        perspective_.configure(true);
        batch_perspective_.configure(true);
        displace_.attach(&displace_reads_);
        batch_displace_.attach(&batch_displace_reads_);
        bump_.attach(&bump_reads_);
        batch_bump_.attach(&batch_bump_reads_);
        configure(false);
    }

    void configure(bool wrap) {
        map_.wrap = wrap;
        displace_.configure(map_);
        batch_displace_.configure(map_);
        if (tangents_) bump_.configure(map_), batch_bump_.configure(map_);
    }

    /// What a unit read, in its order.
    struct Reads : TexelPort {
        void read(uint32_t address) override { addresses.push_back(address); }
        std::vector<uint32_t> addresses;
    };

    /// Data of a vertex: mostly sensible, sometimes anything, sometimes zero.
    std::array<int32_t, kSweepComponents> data() {
        std::array<int32_t, kSweepComponents> out{};
        const unsigned kind = random_() % 16;
        const int c_frac = profile_.inverse_w.frac, frac = profile_.sweep_data.frac;
        const int64_t c = kind == 0 ? int64_t(random_() % 5) - 2
                                    : (int64_t(random_() >> 8) << c_frac >> 24) / 8 + 1;
        for (int32_t& x : out) {
            const int64_t v = int64_t(random_() % 2000) - 1000;  // thousandths
            x = kind == 1 ? int32_t(random_()) >> (32 - profile_.sweep_data.width)
                          : int32_t((v * c >> (c_frac - 12)) * (int64_t{1} << frac) / 1000 >> 12);
        }
        if (kind == 2) out[3] = out[4] = out[5] = 0;
        out[kInverseWComponent] = int32_t(c);
        return out;
    }

    /// Brings a vertex's place in the map, by the same means on both sides, into the map.
    static int32_t wrapped(int32_t u, int size, int frac) { return u & ((size << frac) - 1); }

    static constexpr int kWidth = 64, kHeight = 32;
    const Setting& setting_ = kSettings[GetParam()];
    const Profile profile_ = test::profile_with(setting_.profile, setting_.replaced);
    const bool tangents_ = profile_.components == kSweepComponents;
    std::mt19937 random_{77};
    MapView<Fixed> map_;
    std::vector<uint16_t> heights_;
    std::vector<Vec3<int16_t>> normals_;
    Reads displace_reads_, batch_displace_reads_, bump_reads_, batch_bump_reads_;
    Perspective<Fixed> perspective_{profile_}, batch_perspective_{profile_};
    Displace<Fixed> displace_{profile_}, batch_displace_{profile_};
    Bump<Fixed> bump_{profile_}, batch_bump_{profile_};
};

INSTANTIATE_TEST_SUITE_P(Profiles, Batches, testing::Range<std::size_t>(0, std::size(kSettings)));

TEST_P(Batches, MakeWhatSingleVerticesGive) {
    FineVertices<Fixed> batch{};
    const int frac = profile_.uv.frac;
    for (int round = 0; round < 300; ++round) {
        configure(round % 2 == 1);
        batch.size = 0;
        std::vector<std::array<int32_t, kSweepComponents>> all(1 + random_() % kFineVertices);
        for (auto& one : all) {
            one = data();
            batch.push_back({NameKind::Interior, 0, int16_t(batch.size), 0}, one);
        }
        batch_perspective_.run(batch);
        for (std::size_t i = 0; i < all.size(); ++i) {
            FineVertex<Fixed> v;
            perspective_(all[i], batch.names[i], v);
            ASSERT_EQ(batch.uv(i), v.uv);
            ASSERT_EQ(batch.position[i], v.position);
            ASSERT_EQ(batch.normal[i], v.normal);
            ASSERT_EQ(batch.handedness[i], v.handedness);
            batch.u[i] = wrapped(batch.u[i], kWidth, frac);
            batch.v[i] = wrapped(batch.v[i], kHeight, frac);
        }
        batch_displace_.run(batch);
        if (tangents_) batch_bump_.run(batch);
        for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(batch.displaced[i],
                      displace_(batch.position[i], batch.normal[i], batch.uv(i)));
            if (!tangents_) continue;
            FineVertex<Fixed> v;
            v.uv = batch.uv(i);
            v.normal = batch.normal[i];
            v.tangent = batch.tangent[i];
            v.handedness = int8_t(batch.handedness[i]);
            bump_(v);
            ASSERT_EQ(batch.displaced_normal[i], v.displaced_normal);
        }
    }
    EXPECT_GT(displace_reads_.addresses.size(), 0U);
    EXPECT_EQ(displace_reads_.addresses, batch_displace_reads_.addresses);
    EXPECT_EQ(bump_reads_.addresses, batch_bump_reads_.addresses);
    const PerspectiveCounters &p = perspective_.counters(), &bp = batch_perspective_.counters();
    EXPECT_EQ(bp.items, p.items);
    EXPECT_EQ(bp.overflows, p.overflows);
    EXPECT_EQ(bp.clamped, p.clamped);
    EXPECT_GT(p.clamped, 100U);
    EXPECT_GT(p.overflows, 100U);
    const auto &n = perspective_.normalise_counters(),
               &bn = batch_perspective_.normalise_counters();
    EXPECT_EQ(bn.items, n.items);
    EXPECT_EQ(bn.degenerate, n.degenerate);
    EXPECT_GT(n.degenerate, 100U);
    EXPECT_EQ(batch_displace_.counters().items, displace_.counters().items);
    EXPECT_EQ(batch_displace_.counters().reads, displace_.counters().reads);
    EXPECT_EQ(batch_displace_.counters().overflows, displace_.counters().overflows);
    EXPECT_EQ(batch_bump_.counters().items, bump_.counters().items);
    EXPECT_EQ(batch_bump_.counters().reads, bump_.counters().reads);
    EXPECT_EQ(batch_bump_.counters().overflows, bump_.counters().overflows);
    EXPECT_EQ(batch_bump_.counters().degenerate, bump_.counters().degenerate);
}

}  // namespace
}  // namespace repousse

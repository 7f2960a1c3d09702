// bump on whole maps as the host encodes them: slopes and two angles against the stored normals of
// the same map, batches against single vertices.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "testbench/host/draw.h"
#include "testbench/host/encoder.h"
#include "testbench/host/map/normal_map.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/bump_kinds.h"

namespace repousse {
namespace {

using study::angle_deg;
using study::kDegrees;
using test::Dice;
using test::kPi;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 43;

class BumpMaps : public test::BumpKinds {};

/// What the host makes of a map for each kind.
struct Encoded {
    MapView<Fixed> view;
    MapTables<Fixed> tables;
};

void encode(const Profile& profile, const host::HeightMap& map, Encoded& e) {
    static const host::Mesh mesh = host::make_grid(2, 2);
    host::DrawInputs inputs;
    inputs.mesh = &mesh;
    inputs.map = &map;
    inputs.texel_size = {1.0 / map.width, 0.75 / map.height};
    host::Encoder<Fixed> encoder(profile);
    encoder.map(inputs, true, e.view, e.tables);
    ASSERT_TRUE(encoder.status().ok());
    e.view.heights = e.tables.heights;
    e.view.normals = e.tables.normals;
    e.view.turns = e.tables.turns;
}

// Kinds 1 and 2 say of a whole map what the stored normals say, borders and seams included; what a
// stored normal's own rounding may add is in the tolerance.
TEST_P(BumpMaps, AgreesWithStoredNormalsOnAWholeMap) {
    const Profile stored = test::profile_with(GetParam().profile, {{"bump_kind", "0"}});
    const int32_t one = 1 << profile_.normal.frac;
    for (const bool wrap : {false, true}) {
        host::HeightMap map = host::make_donut_map(24, 17);
        map.wrap = wrap;
        map.range_low = 0.0, map.range_high = 0.4;
        Encoded own, normals;
        encode(profile_, map, own);
        encode(stored, map, normals);
        EXPECT_EQ(own.tables.normals.empty(), kind_ != BumpKind::Normals);
        EXPECT_EQ(own.tables.turns.empty(), kind_ != BumpKind::Turns);
        Bump<Fixed> reference(stored);
        unit_.configure(own.view);
        reference.configure(normals.view);
        // Narrow heights are rounded before they are differenced, stored normals are made of
        // whole ones.
        const double step = 0.4 / double(profile_.height.max_raw()) * 24;
        const double of_heights = kind_ == BumpKind::Slopes ? kDegrees * step : 0.0;
        const double of_normals =
            kDegrees * std::sqrt(3.0) * std::ldexp(1.0, -profile_.map_normal.frac);
        const double of_sines = kDegrees * std::pow(kPi / 2 / (1 << profile_.sine_index_bits), 2);
        for (int y = 0; y < map.height; ++y) {
            for (int x = 0; x < map.width; ++x) {
                Vertex<Fixed> a = vertex({0, one, 0}, {one, 0, 0}, x % 2 == 0 ? 1 : -1);
                a.uv = {x << profile_.uv.frac, y << profile_.uv.frac};
                Vertex<Fixed> b = a;
                unit_(a);
                reference(b);
                ASSERT_LE(angle_deg(to_real(a.displaced_normal, profile_.displaced_normal),
                                    to_real(b.displaced_normal, profile_.displaced_normal)),
                          of_heights + of_normals + of_sines + 2 * last_rounding_deg())
                    << x << ", " << y << (wrap ? ", periodic" : "");
            }
        }
    }
}

// Through vector registers or not: the same bits and counts, frames that are none included.
TEST_P(BumpMaps, ABatchIsItsVerticesOneByOne) {
    host::HeightMap map = host::make_donut_map(24, 17);
    map.wrap = true;
    Encoded own;
    encode(profile_, map, own);
    Bump<Fixed> one_by_one(profile_);
    unit_.configure(own.view);
    one_by_one.configure(own.view);
    const auto batch = std::make_unique<FineVertices<Fixed>>();
    Dice dice(kSeed + 5);
    for (int round = 0; round < 200; ++round) {
        batch->size = static_cast<std::size_t>(dice.integer(0, kFineVertices));
        std::vector<Vec3<int32_t>> expected;
        for (std::size_t i = 0; i < batch->size; ++i) {
            FineVertex<Fixed> v;
            v.uv = {static_cast<int32_t>(dice.integer(0, (24 << profile_.uv.frac) - 1)),
                    static_cast<int32_t>(dice.integer(0, (17 << profile_.uv.frac) - 1))};
            const auto pick = dice.integer(0, 19);
            if (pick == 0) {  // any vectors: B and v saturate
                v.normal = {dice.raw(profile_.normal), dice.raw(profile_.normal), 1};
                v.tangent = {dice.raw(profile_.normal), 2, dice.raw(profile_.normal)};
            } else {
                v.normal = pick == 1 ? Vec3<int32_t>{} : to_raw(dice.direction(), profile_.normal);
                v.tangent = pick == 2   ? v.normal
                            : pick == 3 ? Vec3<int32_t>{}
                                        : to_raw(dice.direction(), profile_.normal);
            }
            v.handedness = dice.flip() ? 1 : -1;
            batch->u[i] = v.uv.x, batch->v[i] = v.uv.y;
            batch->normal.set(i, v.normal);
            batch->tangent.set(i, v.tangent);
            batch->handedness[i] = v.handedness;
            one_by_one(v);
            expected.push_back(v.displaced_normal);
        }
        unit_.run(*batch);
        for (std::size_t i = 0; i < batch->size; ++i) {
            ASSERT_EQ(batch->displaced_normal[i], expected[i]) << round << ", " << i;
        }
    }
    const BumpCounters &a = unit_.counters(), &b = one_by_one.counters();
    EXPECT_EQ(a.items, b.items);
    EXPECT_EQ(a.reads, b.reads);
    EXPECT_EQ(a.overflows, b.overflows);
    EXPECT_EQ(a.degenerate, b.degenerate);
    EXPECT_EQ(a.degenerate_frames, b.degenerate_frames);
    EXPECT_GT(a.degenerate, 0u);
    EXPECT_GT(a.degenerate_frames, a.degenerate);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BumpMaps, test::kBumpCases, test::bump_case_name);

TEST(BumpTurns, AreTheAnglesOfANormal) {
    Dice dice(kSeed);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = dice.direction();
        const glm::dvec2 turn = kPi * host::turns_of(n);
        const glm::dvec3 back(std::sin(turn.x), std::cos(turn.x) * std::sin(turn.y),
                              std::cos(turn.x) * std::cos(turn.y));
        EXPECT_LE(test::farthest(n, back), 1e-12);
    }
    EXPECT_EQ(host::turns_of({0, 0, 1}), glm::dvec2(0, 0));
}

}  // namespace
}  // namespace repousse

// The three units' RTL against their datapaths: random, exhaustive, in Icarus, and with engines
// that are wrong on purpose, which must be found.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/vector_file.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

Engine engine_of(const UnitModel& model, const fs::path& root = source_folder()) {
    const auto path = build_engine(model.desc(), model.profile(), root);
    if (!path) throw std::runtime_error(path.error().message());
    auto engine = Engine::open(*path, model.desc());
    if (!engine) throw std::runtime_error(engine.error().message());
    return *engine;
}

std::unique_ptr<UnitModel> model_of(const std::string& unit, const char* profile = "default") {
    return make_unit_model(unit, *shipped_profile(profile));
}

Effort effort(uint64_t vectors) {
    Effort e;
    e.vectors = vectors;
    e.stalled_percent = 50;
    return e;
}

class RtlEquivalence : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Units, RtlEquivalence,
                         testing::Values("texcoord_test", "view_test", "height_test"),
                         [](const auto& unit) { return unit.param; });

TEST_P(RtlEquivalence, HardCasesAndRandomOnesInVerilator) {
    const auto model = model_of(GetParam());
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(200'000), {});
    EXPECT_GE(outcome.cases, 200'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(RtlEquivalence, NarrowProfile) {
    const auto model = model_of(GetParam(), "narrow");
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(50'000), {});
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(RtlEquivalence, EveryTransactionOfATinyProfile) {
    const auto model = model_of(GetParam());
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome = run_exhaustive(*tiny, engine_of(*tiny), effort(0), {});
    EXPECT_GE(outcome.cases, uint64_t{1} << 24);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
    RecordProperty("cases", std::to_string(outcome.cases));
}

TEST_P(RtlEquivalence, HardCasesAndRandomOnesInIcarus) {
    const auto model = model_of(GetParam());
    const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 5'000, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GE(outcome->cases, 5'000U);
    EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
}

TEST_P(RtlEquivalence, TheNumberOfJobsDoesNotMatter) {
    const auto model = model_of(GetParam());
    const Engine engine = engine_of(*model);
    Effort two = effort(50'000);
    two.jobs = 2;
    const Outcome a = run_random(*model, engine, {}, effort(50'000), {});
    const Outcome b = run_random(*model, engine, {}, two, {});
    EXPECT_EQ(a.cases, b.cases);
    EXPECT_EQ(a.mismatches + b.mismatches, 0U);
}

TEST(HeightTestRtl, LargestMap) {
    // 4096 x 4096 texels at the maximum: table entries wrap around 2^38, edges are 4096 texels.
    const auto model = model_of("height_test");
    const auto table = prefix_sums(4096, 4096, model->profile().sat_width,
                                   [](int, int) { return uint64_t{65535}; });
    const Engine engine = engine_of(*model);
    std::vector<Scenario> scenarios;
    for (int kind = 0; kind < 8; ++kind) {
        const int64_t threshold = kind & 4 ? (int64_t{1} << 37) - 1 : 0;
        scenarios.push_back({"largest map",
                             {4096, 4096, kind & 1, kind >> 1 & 1, kind >> 2 & 1, threshold},
                             table,
                             {}});
        Random random(9, static_cast<uint64_t>(kind));
        for (int i = 0; i < 2'000; ++i) {
            const auto c = [&] { return random.between(0, 4096 << 8); };
            const int64_t x1 = c(), y1 = c(), x2 = c(), y2 = c();
            for (const int64_t word :
                 {int64_t{0}, x1, y1, x2, y2, (x1 + x2) >> 1, (y1 + y2) >> 1}) {
                scenarios.back().inputs.push_back(word);
            }
        }
    }
    const Outcome outcome = run_random(*model, engine, scenarios, effort(0), {});
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

/// A copy of rtl/ in which one text is replaced by another.
class Mutant {
public:
    Mutant(const std::string& file, const std::string& from, const std::string& to) {
        std::string pattern = (fs::temp_directory_path() / "repousse-mutant-XXXXXX").string();
        root_ = mkdtemp(pattern.data());
        fs::copy(source_folder() / "rtl", root_ / "rtl", fs::copy_options::recursive);
        std::stringstream text;
        text << std::ifstream(root_ / "rtl" / file).rdbuf();
        std::string changed = text.str();
        const std::size_t at = changed.find(from);
        if (at == std::string::npos) throw std::runtime_error(from + " is not in " + file);
        changed.replace(at, from.size(), to);
        std::ofstream(root_ / "rtl" / file) << changed;
    }
    ~Mutant() { fs::remove_all(root_); }
    Mutant(const Mutant&) = delete;
    Mutant& operator=(const Mutant&) = delete;
    const fs::path& root() const { return root_; }

private:
    fs::path root_;
};

struct Mutation {
    const char* name;
    const char* unit;
    const char* file;
    const char* from;
    const char* to;
};

class WrongRtl : public testing::TestWithParam<Mutation> {};

INSTANTIATE_TEST_SUITE_P(
    IsFound, WrongRtl,
    testing::Values(Mutation{"TexcoordWantsBothEnds", "texcoord_test", "units/texcoord_test.sv",
                             "~same_as_1 & ~same_as_2", "~same_as_1 | ~same_as_2"},
                    Mutation{"ViewTestIsNotStrict", "view_test", "units/view_test.sv",
                             "distance > threshold", "distance >= threshold"},
                    Mutation{"HeightTestSubtractsTooMuch", "height_test", "units/height_test.sv",
                             "(column == 2'd1) ^ (row == 2'd1)",
                             "(column == 2'd1) | (row == 2'd1)"},
                    Mutation{"HeightTestForgetsTheSeam", "height_test", "units/height_test_side.sv",
                             "periodic && period(a", "0 && period(a"},
                    Mutation{"HeightTestDifferenceHasOneBitLess", "height_test",
                             "units/height_test_decision.sv", "if (d[SW]) d = -d;",
                             "if (d[SW-1]) d = -d;"}),
    [](const auto& mutation) { return mutation.param.name; });

TEST_P(WrongRtl, InVerilator) {
    const Mutation& m = GetParam();
    const auto model = model_of(m.unit);
    const Mutant mutant(m.file, m.from, m.to);
    const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                       model->hard_cases(), effort(50'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
    // What a person needs to find it.
    for (const char* part : {m.unit, ": transaction ", ", cycle ", ", field ", ": engine 0x",
                             ", datapath 0x", " LSB; with ", "skip=0x"}) {
        EXPECT_NE(outcome.first_mismatch.find(part), std::string::npos)
            << part << " is missing in: " << outcome.first_mismatch;
    }
}

TEST(WrongEngines, InIcarus) {
    const auto model = model_of("view_test");
    const Mutant mutant("units/view_test.sv", "distance > threshold", "distance >= threshold");
    const auto outcome = run_icarus(*model, mutant.root(), model->hard_cases(), 1'000, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GT(outcome->mismatches, 0U);
    EXPECT_NE(outcome->first_mismatch.find("field vt"), std::string::npos)
        << outcome->first_mismatch;
}

TEST(WrongEngines, AnEngineOfAnotherProfile) {
    // The engine drops 8 fraction bits, the datapath 7.
    const auto model = model_of("texcoord_test");
    Profile other = model->profile();
    other.uv.frac = 7;
    const auto judge = model->with(other);
    const Outcome outcome = run_random(*judge, engine_of(*model), {}, effort(50'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
}

TEST(WrongEngines, AUnitThatLosesTransactionsIsStuck) {
    const auto model = model_of("texcoord_test");
    const Mutant mutant("common/rp_pipe.sv", "load | (valid & ~ready)", "load");
    const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                       model->hard_cases(), effort(50'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
}

TEST(Engines, AMissingToolIsAnEnvironmentErrorThatNamesThePackage) {
    const auto model = model_of("texcoord_test");
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    const auto engine = build_engine(model->desc(), model->profile(), source_folder());
    const auto icarus = run_icarus(*model, source_folder(), {}, 10, 1);
    setenv("PATH", path.c_str(), 1);
    ASSERT_FALSE(engine.ok());
    EXPECT_EQ(engine.error().kind, ErrorKind::Environment);
    EXPECT_NE(engine.error().message().find("apt-get install verilator"), std::string::npos);
    ASSERT_FALSE(icarus.ok());
    EXPECT_EQ(icarus.error().kind, ErrorKind::Environment);
    EXPECT_NE(icarus.error().message().find("apt-get install iverilog"), std::string::npos);
}

TEST(Engines, AnotherUnitsEngineIsRefused) {
    const auto model = model_of("texcoord_test");
    const auto path = build_engine(model->desc(), model->profile(), source_folder());
    ASSERT_TRUE(path.ok());
    const auto engine = Engine::open(*path, model_of("view_test")->desc());
    ASSERT_FALSE(engine.ok());
    EXPECT_NE(engine.error().message().find("an engine of texcoord_test"), std::string::npos);
}

}  // namespace
}  // namespace repousse::cosim

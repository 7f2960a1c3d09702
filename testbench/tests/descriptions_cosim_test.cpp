// What is printed from the descriptions, and the committed vectors, are not stale.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "testbench/cosim/descriptions.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/parameters.h"
#include "testbench/cosim/vector_file.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

TEST(Descriptions, PrintedFilesAreNotStale) {
    const auto files = print_descriptions(source_folder(), *shipped_profile("default"));
    ASSERT_TRUE(files.ok()) << files.error().message();
    EXPECT_GE(files->size(), 3U);
    for (const PrintedFile& file : *files) {
        EXPECT_FALSE(file.is_stale) << file.path << ": run print_descriptions and commit";
    }
}

TEST(Descriptions, StalenessIsSeen) {
    Profile other = *shipped_profile("default");
    other.uv.width += 1;
    const auto files = print_descriptions(source_folder(), other);
    ASSERT_TRUE(files.ok());
    EXPECT_TRUE(std::any_of(files->begin(), files->end(),
                            [](const PrintedFile& file) { return file.is_stale; }));
}

TEST(Descriptions, EveryPortHasAWidth) {
    const Profile profile = *shipped_profile("default");
    for (const UnitDesc* desc : unit_descriptions()) {
        EXPECT_GE(desc->latency, 1) << desc->name;
        EXPECT_GE(desc->interval, 1) << desc->name;
        for (const Port& port : desc->ports) {
            const Format format = port_format(port, profile);
            EXPECT_GE(format.width, 1) << desc->name << '.' << port.name;
            EXPECT_LE(format.width, 63) << desc->name << '.' << port.name;
        }
        for (const std::string_view key : desc->keys) {
            const Span<const ProfileEntry> entries = profile_entries();
            EXPECT_TRUE(std::any_of(entries.begin(), entries.end(),
                                    [&](const ProfileEntry& e) { return e.key == key; }))
                << desc->name << ": no profile entry " << key;
        }
    }
}

class Vectors : public testing::TestWithParam<std::string> {
protected:
    std::unique_ptr<UnitModel> model_ = make_unit_model(GetParam(), *shipped_profile("default"));
    fs::path path_ = source_folder() / "vectors" / GetParam() / "hard.vec";
};

INSTANTIATE_TEST_SUITE_P(Units, Vectors,
                         testing::Values("texcoord_test", "view_test", "normal_test", "edge_iter",
                                         "split", "displace", "height_test", "grid_transform",
                                         "view_clip", "perspective", "strip", "sweep_line", "shade",
                                         "normalise", "mid_vertex", "bump", "tessellation_tests",
                                         "texel_cache"),
                         [](const auto& unit) { return unit.param; });

TEST_P(Vectors, CommittedOnesAreTheHardCasesWithTheDatapathsOutputs) {
    const auto recorded = read_vectors(path_, *model_);
    ASSERT_TRUE(recorded.ok()) << recorded.error().message();
    std::size_t ones = 0, zeros = 0;
    std::vector<int64_t> inputs, expected_inputs;
    for (const Recorded& r : *recorded) {
        std::vector<int64_t> outputs;
        model_->evaluate(r.scenario, outputs);
        EXPECT_EQ(outputs, r.outputs) << path_ << ':' << r.first_line;
        inputs.insert(inputs.end(), r.scenario.inputs.begin(), r.scenario.inputs.end());
        for (const int64_t bit : outputs) (bit != 0 ? ones : zeros) += 1;
    }
    for (const Scenario& s : model_->hard_cases()) {
        expected_inputs.insert(expected_inputs.end(), s.inputs.begin(), s.inputs.end());
    }
    EXPECT_EQ(inputs, expected_inputs) << "run: repousse vectors generate";
    EXPECT_GT(ones, 20U);
    EXPECT_GT(zeros, 20U);
    EXPECT_LE(fs::file_size(path_), 200'000U);
}

TEST_P(Vectors, SurviveWritingAndReading) {
    const fs::path folder = fs::temp_directory_path() / ("repousse-vectors-" + GetParam());
    Random random(4);
    const auto recorded = record(*model_, {model_->random(random, 50), model_->random(random, 50)});
    const auto sizes = write_vectors(folder / "a.vec", *model_, recorded, 4);
    ASSERT_TRUE(sizes.ok()) << sizes.error().message();
    EXPECT_EQ(sizes->lines, 100U);
    const auto back = read_vectors(folder / "a.vec", *model_);
    ASSERT_TRUE(back.ok()) << back.error().message();
    std::vector<int64_t> before, after;
    for (const Recorded& r : recorded) {
        before.insert(before.end(), r.scenario.inputs.begin(), r.scenario.inputs.end());
        before.insert(before.end(), r.outputs.begin(), r.outputs.end());
    }
    for (const Recorded& r : *back) {
        after.insert(after.end(), r.scenario.inputs.begin(), r.scenario.inputs.end());
        after.insert(after.end(), r.outputs.begin(), r.outputs.end());
    }
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(before, after);
    fs::remove_all(folder);
}

TEST_P(Vectors, BadFilesAreRefusedWithTheirLine) {
    const fs::path folder = fs::temp_directory_path() / ("repousse-bad-vectors-" + GetParam());
    fs::create_directories(folder);
    if (model_->reads_table()) {
        fs::copy_file(tables_path(path_), folder / "a.tables",
                      fs::copy_options::overwrite_existing);
    }
    if (model_->last() >= 0) {
        fs::copy_file(beats_path(path_), folder / "a.beats", fs::copy_options::overwrite_existing);
    }
    std::ifstream original(path_);
    std::vector<std::string> lines;
    for (std::string line; std::getline(original, line);) lines.push_back(line);
    const auto error_with = [&](std::size_t line, const std::string& text) {
        std::vector<std::string> changed = lines;
        changed[line] = text;
        std::ofstream file(folder / "a.vec");
        for (const std::string& l : changed) file << l << '\n';
        file.close();
        const auto result = read_vectors(folder / "a.vec", *model_);
        EXPECT_FALSE(result.ok()) << text;
        return result.ok() ? std::string() : result.error().message();
    };
    EXPECT_NE(error_with(1, "// unit other").find("a.vec:2:1: "), std::string::npos);
    EXPECT_NE(error_with(2, "// schema 2").find("a.vec:3:1: "), std::string::npos);
    EXPECT_NE(error_with(4, "// parameters 0").find("a.vec:5:1: "), std::string::npos);
    EXPECT_NE(error_with(5, "// field input other u1.0").find("a.vec:6:1: "), std::string::npos);
    const std::size_t last = lines.size() - 1;
    EXPECT_NE(error_with(last, lines[last] + "0").find("hexadecimal digits"), std::string::npos);
    EXPECT_NE(error_with(last, "xyz").find("hexadecimal digits"), std::string::npos);
    EXPECT_FALSE(read_vectors(folder / "none.vec", *model_).ok());
    fs::remove_all(folder);
}

}  // namespace
}  // namespace repousse::cosim

// print_descriptions [--check] [ROOT]: prints the units' descriptions into the Verilog parameter
// files and the sheets' tables below ROOT (by default where the program was built). With --check
// nothing is written: stale files are named and the exit status is 1.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "testbench/cosim/descriptions.h"
#include "testbench/cosim/engine_builder.h"
#include "tlm/config/profile_reader.h"

namespace {

repousse::Status print(const std::filesystem::path& root, bool only_check) {
    using namespace repousse;
    const Result<Profile> profile = shipped_profile("default");
    if (!profile) return profile.error();
    const Result<std::vector<cosim::PrintedFile>> files = cosim::print_descriptions(root, *profile);
    if (!files) return files.error();
    for (const cosim::PrintedFile& file : *files) {
        if (!file.is_stale) continue;
        if (only_check) {
            return Error{ErrorKind::Mismatch,
                         file.path.string(),
                         "is stale",
                         {},
                         "run print_descriptions and commit what it writes"};
        }
        std::ofstream out(root / file.path, std::ios::binary);
        if (!(out << file.text << std::flush)) {
            return Error{ErrorKind::Environment, file.path.string(), "cannot be written", {}, {}};
        }
        fmt::print("{}\n", file.path.string());
    }
    return done();
}

}  // namespace

int main(int argc, char** argv) try {
    bool only_check = false;
    std::filesystem::path root = repousse::cosim::source_folder();
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--check") {
            only_check = true;
        } else {
            root = argv[i];
        }
    }
    const repousse::Status status = print(root, only_check);
    if (status) return 0;
    std::fprintf(stderr, "print_descriptions: %s\n", status.error().message().c_str());
    return static_cast<int>(status.error().kind);
} catch (const std::exception& error) {
    std::fprintf(stderr, "print_descriptions: %s\n", error.what());
    return static_cast<int>(repousse::ErrorKind::Environment);
}

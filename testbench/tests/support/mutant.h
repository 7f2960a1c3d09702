#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "testbench/cosim/engine_builder.h"

namespace repousse::cosim {

/// A mistake in a unit's RTL: `to` instead of `from` in a file of rtl/.
struct Mutation {
    const char* name;
    const char* unit;
    const char* file;
    const char* from;
    const char* to;
};

/// A copy of rtl/ in which one text is replaced by another.
class Mutant {
public:
    explicit Mutant(const Mutation& m) : Mutant(m.file, m.from, m.to) {}
    Mutant(const std::string& file, const std::string& from, const std::string& to) {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "repousse-mutant-XXXXXX").string();
        root_ = mkdtemp(pattern.data());
        std::filesystem::copy(source_folder() / "rtl", root_ / "rtl",
                              std::filesystem::copy_options::recursive);
        std::stringstream text;
        text << std::ifstream(root_ / "rtl" / file).rdbuf();
        std::string changed = text.str();
        const std::size_t at = changed.find(from);
        if (at == std::string::npos) throw std::runtime_error(from + " is not in " + file);
        changed.replace(at, from.size(), to);
        std::ofstream(root_ / "rtl" / file) << changed;
    }
    ~Mutant() { std::filesystem::remove_all(root_); }
    Mutant(const Mutant&) = delete;
    Mutant& operator=(const Mutant&) = delete;
    const std::filesystem::path& root() const { return root_; }

private:
    std::filesystem::path root_;
};

}  // namespace repousse::cosim

#include "testbench/cosim/engine_builder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "testbench/cosim/hash.h"
#include "testbench/cosim/parameters.h"
#include "testbench/cosim/process.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Unknown bits are zero, assertions are left out, and the model is optimised twice: by Verilator
// and by the compiler.
const Words kVerilatorFlags = {"--cc",       "--prefix", "Vunit",       "-Wall", "-O3",
                               "--x-assign", "fast",     "--x-initial", "fast",  "--noassert"};
const Words kCompilerFlags = {"-std=c++17",      "-O2",       "-fPIC",       "-fvisibility=hidden",
                              "-DVM_COVERAGE=0", "-DVM_SC=0", "-DVM_TRACE=0"};

std::string environment(const char* name, std::string otherwise) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0' ? value : std::move(otherwise);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// "Verilator 5.006" of "Verilator 5.006 2023-01-22 rev (Debian 5.006-3)".
std::string short_version(const std::string& version) {
    return version.substr(0, version.find(' ', version.find(' ') + 1));
}

Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Error unreadable(const fs::path& path) {
    return {ErrorKind::Environment,
            path.string(),
            "cannot be read",
            {},
            "set REPOUSSE_SOURCE_DIR to a checkout of repousse"};
}

Result<std::string> read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!(text << file.rdbuf())) return unreadable(path);
    return text.str();
}

/// The tools that a build needs, and what distinguishes one installation from another.
struct Tools {
    std::string compiler;
    std::string compiler_version;
    std::string verilator_version;
    fs::path verilator_include;
};

Result<Tools> find_tools() {
    Tools tools;
    // Verilated height_test runs about half as fast again from clang as from g++ (14 and 12.2).
    const bool has_clang = bool(require_program("clang++", "clang"));
    tools.compiler = environment("CXX", has_clang ? "clang++" : "c++");
    if (const Status s = require_program("verilator", "verilator"); !s) return s.error();
    if (tools.compiler.find('/') == std::string::npos) {
        if (const Status s = require_program(tools.compiler, "g++"); !s) return s.error();
    }
    Result<std::string> version = run_checked({"verilator", "--version"});
    if (!version) return version.error();
    tools.verilator_version = first_line(*version);
    Result<std::string> root = run_checked({"verilator", "--getenv", "VERILATOR_ROOT"});
    if (!root) return root.error();
    tools.verilator_include = fs::path(first_line(*root)) / "include";
    Result<std::string> compiler = run_checked({tools.compiler, "--version"});
    if (!compiler) return compiler.error();
    tools.compiler_version = first_line(*compiler);
    return tools;
}

/// A folder of our own beside the final place, removed with everything in it at the end.
class Workplace {
public:
    explicit Workplace(const fs::path& cache) {
        std::string pattern = (cache / "build-XXXXXX").string();
        if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
    }
    ~Workplace() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Verilator's run-time library as one object, shared by all engines of a version.
Result<fs::path> build_runtime(const Tools& tools, const fs::path& cache, const fs::path& work) {
    Hash hash;
    for (const std::string& part : kCompilerFlags) hash.add(part);
    hash.add(tools.compiler_version);
    hash.add(tools.verilator_version);
    const fs::path object = cache / fmt::format("verilated-{:016x}.o", hash.value());
    if (fs::exists(object)) return object;
    const std::string include = tools.verilator_include.string();
    std::ofstream(work / "runtime.cpp")
        << "#include \"verilated.cpp\"\n#include \"verilated_threads.cpp\"\n";
    const Result<std::string> compiled =
        run_checked(Words{tools.compiler} + kCompilerFlags +
                        Words{"-I" + include, "-I" + include + "/vltstd", "-c", "runtime.cpp", "-o",
                              "runtime.o"},
                    work);
    if (!compiled) return compiled.error();
    fs::rename(work / "runtime.o", object);
    return object;
}

/// Verilates and compiles into `work`/engine.so.
Status compile(const UnitDesc& desc, const Profile& profile, const fs::path& root,
               const Words& sources, const Tools& tools, const fs::path& runtime,
               const fs::path& work) {
    const std::string unit(desc.name);
    const std::string include = tools.verilator_include.string();
    Words rtl_parameters;
    Words defines = {"-DSIMULATOR=\"" + short_version(tools.verilator_version) + "\""};
    for (const Parameter& p : parameters(desc, profile)) {
        rtl_parameters.push_back(fmt::format("-G{}={}", p.name, p.value));
        defines.push_back(fmt::format("-D{}={}", p.name, p.value));
    }
    const Result<std::string> verilated =
        run_checked(Words{"verilator"} + kVerilatorFlags + rtl_parameters +
                        Words{"-I.", "--top-module", unit, "--Mdir", work.string()} + sources,
                    root);
    if (!verilated) return verilated.error();

    // One translation unit, so that the harness and the model are optimised together.
    std::ofstream all(work / "engine.cpp");
    for (const fs::directory_entry& file : fs::directory_iterator(work)) {
        const std::string name = file.path().filename().string();
        if (name.rfind("Vunit", 0) == 0 && file.path().extension() == ".cpp") {
            all << "#include \"" << name << "\"\n";
        }
    }
    all << "#include \"testbench/cosim/harness/" << unit << ".cpp\"\n";
    all.close();
    const Result<std::string> linked = run_checked(
        Words{tools.compiler} + kCompilerFlags + defines +
            Words{"-shared", "-I.", "-I" + root.string(), "-I" + source_folder().string(),
                  "-I" + include, "-I" + include + "/vltstd", "engine.cpp", runtime.string(), "-o",
                  "engine.so", "-Wl,-z,defs", "-lpthread", "-latomic"},
        work);
    if (!linked) return linked.error();
    return done();
}

}  // namespace

fs::path source_folder() { return environment("REPOUSSE_SOURCE_DIR", REPOUSSE_SOURCE_DIR); }

fs::path cache_folder() {
    const std::string home = environment("HOME", "/tmp");
    return environment("REPOUSSE_CACHE_DIR", home + "/.cache/repousse");
}

namespace {

/// The files of rtl/common and of a unit, or of a top and its units, that end in `extension`.
Result<Words> files_of(const fs::path& root, const UnitDesc& desc, const char* extension) {
    const auto of_a_unit = [&](const std::string& name) {
        return desc.parts.empty()
                   ? name.rfind(desc.name, 0) == 0
                   : std::any_of(desc.parts.begin(), desc.parts.end(),
                                 [&](std::string_view part) { return name.rfind(part, 0) == 0; });
    };
    Words files;
    for (const char* folder : {"rtl/common", "rtl/units", "rtl/tops"}) {
        if (folder == std::string("rtl/tops") && desc.parts.empty()) continue;
        std::error_code error;
        fs::directory_iterator entries(root / folder, error);
        if (error) return unreadable(root / folder);
        for (const fs::directory_entry& entry : entries) {
            const std::string name = entry.path().filename().string();
            const bool wanted =
                folder == std::string("rtl/common") ||
                (folder == std::string("rtl/units") ? of_a_unit(name)
                                                    : name.rfind(desc.name, 0) == 0);
            if (wanted && entry.path().extension() == extension) {
                files.push_back(std::string(folder) + "/" + name);
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

std::string rtl_folder(const UnitDesc& desc) {
    return desc.parts.empty() ? "rtl/units" : "rtl/tops";
}

Result<std::vector<std::string>> rtl_files(const fs::path& root, const UnitDesc& desc) {
    return files_of(root, desc, ".sv");
}

Result<fs::path> build_engine(const UnitDesc& desc, const Profile& profile, const fs::path& root) {
    const Result<Tools> tools = find_tools();
    if (!tools) return tools.error();
    const Result<Words> sources = rtl_files(root, desc);
    if (!sources) return sources.error();

    Hash hash;
    for (const std::string& flag : kVerilatorFlags + kCompilerFlags) hash.add(flag);
    hash.add(tools->compiler_version);
    hash.add(tools->verilator_version);
    for (const Parameter& p : parameters(desc, profile))
        hash.add(fmt::format("{}={}", p.name, p.value));
    const Result<Words> headers = files_of(root, desc, ".svh");
    if (!headers) return headers.error();
    for (const std::string& name : *sources + *headers) {
        const Result<std::string> text = read_text(root / name);
        if (!text) return text.error();
        hash.add(name);
        hash.add(*text);
    }
    const std::string unit_harness = fmt::format("testbench/cosim/harness/{}.cpp", desc.name);
    for (const std::string& name :
         Words{"tlm/engine.h", "testbench/cosim/random.h", "testbench/cosim/harness/harness.h",
               "testbench/cosim/harness/pacer.h", "testbench/cosim/harness/read_port.h",
               "testbench/cosim/harness/sat_port.h", "testbench/cosim/harness/sweep_line_inputs.h",
               unit_harness}) {
        const Result<std::string> text = read_text(source_folder() / name);
        if (!text) return text.error();
        hash.add(*text);
    }

    const fs::path cache = cache_folder() / "engines";
    const fs::path engine = cache / fmt::format("{}-{:016x}.so", desc.name, hash.value());
    if (fs::exists(engine)) return engine;
    std::error_code error;
    fs::create_directories(cache, error);
    const Workplace work(cache);
    if (error || work.path().empty()) {
        return Error{ErrorKind::Environment,
                     cache.string(),
                     "cannot be written",
                     {},
                     "set REPOUSSE_CACHE_DIR to a folder that can"};
    }
    const Result<fs::path> runtime = build_runtime(*tools, cache, work.path());
    if (!runtime) return runtime.error();
    const Status compiled = compile(desc, profile, root, *sources, *tools, *runtime, work.path());
    if (!compiled) return compiled.error();
    fs::rename(work.path() / "engine.so", engine);  // whole or not at all
    return engine;
}

}  // namespace repousse::cosim

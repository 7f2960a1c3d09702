// The `repousse` program: one command a file, one kind of error, one place that prints it.

#include <cstdio>
#include <exception>
#include <new>

#include "testbench/app/commands.h"

namespace {

constexpr int kEnvironment = static_cast<int>(repousse::ErrorKind::Environment);
constexpr int kUsage = static_cast<int>(repousse::ErrorKind::Input);

int program(int argc, char** argv) {
    using namespace repousse::app;
    CLI::App root{
        "repousse: displacement-mapping graphics hardware, modelled to the bit.\n"
        "Exit status: 0 done; 1 a mismatch or broken invariant; 2 bad usage or input;\n"
        "3 the environment (disk, memory, a missing tool)."};
    root.require_subcommand(1);
    root.set_version_flag("--version", "repousse 0.1.0");
    Run run;
    add_sim(root, run);
    add_info(root, run);
    add_cosim(root, run);
    add_vectors(root, run);
    add_study(root, run);
    try {
        root.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return root.exit(error) == 0 ? 0 : kUsage;
    }
    const repousse::Status status = run();
    if (status) return 0;
    std::fprintf(stderr, "repousse: %s\n", status.error().message().c_str());
    return static_cast<int>(status.error().kind);
}

}  // namespace

// The SystemC library defines main; it calls sc_main if that is used. Having our own main keeps
// the kernel out of commands that simulate nothing.
int main(int argc, char** argv) {
    try {
        return program(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "repousse: out of memory; choose a smaller scene\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "repousse: %s\n", error.what());
    }
    return kEnvironment;
}

#include "testbench/cosim/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace repousse::cosim {
namespace {

Error cannot_run(const std::string& program, const std::string& what) {
    return {ErrorKind::Environment, program, what, {}, {}};
}

/// The child's side: never returns. Only calls that are safe after fork in a threaded program.
[[noreturn]] void become(char* const* arguments, const char* folder, int output) {
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing >= 0) dup2(nothing, STDIN_FILENO);
    if (*folder == '\0' || chdir(folder) == 0) execvp(arguments[0], arguments);
    _exit(127);
}

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t n = read(descriptor, buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

std::string last_lines(const std::string& text, int lines) {
    std::size_t from = text.find_last_not_of('\n');
    if (from == std::string::npos) return "no output";
    const std::size_t end = from + 1;
    for (; from > 0; --from) {
        if (text[from] == '\n' && --lines == 0) break;
    }
    return text.substr(text[from] == '\n' ? from + 1 : from, end - from);
}

}  // namespace

Result<Finished> run_program(const std::vector<std::string>& command,
                             const std::filesystem::path& folder) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string where = folder.string();

    std::array<int, 2> pipe_ends;
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) {
        return cannot_run(command[0], std::strerror(errno));
    }
    const pid_t child = fork();
    if (child == 0) become(arguments.data(), where.c_str(), pipe_ends[1]);
    close(pipe_ends[1]);
    if (child < 0) {
        close(pipe_ends[0]);
        return cannot_run(command[0], std::strerror(errno));
    }
    Finished finished;
    finished.output = read_all(pipe_ends[0]);
    close(pipe_ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return finished;
}

Result<std::string> run_checked(const std::vector<std::string>& command,
                                const std::filesystem::path& folder) {
    Result<Finished> finished = run_program(command, folder);
    if (!finished) return finished.error();
    if (finished->status != 0) {
        return cannot_run(command[0], "failed with status " + std::to_string(finished->status) +
                                          ":\n" + last_lines(finished->output, 12));
    }
    return std::move(finished->output);
}

Status require_program(const std::string& program, const std::string& package) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((folder + "/" + program).c_str(), X_OK) == 0) return done();
    }
    return Error{ErrorKind::Environment,
                 program,
                 "not found",
                 {},
                 "install it with: apt-get install " + package};
}

}  // namespace repousse::cosim

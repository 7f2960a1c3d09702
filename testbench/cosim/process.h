#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace repousse::cosim {

/// What a finished program left.
struct Finished {
    int status = 0;      ///< exit status; 128 + signal if it was killed
    std::string output;  ///< stdout and stderr together
};

/// Runs a program found on the PATH, without a shell, in `folder` (empty: the present one), and
/// waits for it. A program that cannot be started is an Environment error.
Result<Finished> run_program(const std::vector<std::string>& command,
                             const std::filesystem::path& folder = {});

/// As above; an exit status other than 0 is an Environment error too, with the output's last lines.
Result<std::string> run_checked(const std::vector<std::string>& command,
                                const std::filesystem::path& folder = {});

/// Succeeds if a program is on the PATH; otherwise an Environment error that names the Debian
/// package.
Status require_program(const std::string& program, const std::string& package);

}  // namespace repousse::cosim

#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "datapath/error.h"

namespace repousse::app {

/// What the chosen command does; its error becomes the message and the exit status.
using Run = std::function<Status()>;

/// Each adds one command with its options to the program. When the command is chosen, parsing
/// sets `run`; nothing is done before parsing has succeeded as a whole.
void add_sim(CLI::App& root, Run& run);
void add_info(CLI::App& root, Run& run);
void add_cosim(CLI::App& root, Run& run);
void add_vectors(CLI::App& root, Run& run);
void add_study(CLI::App& root, Run& run);

}  // namespace repousse::app

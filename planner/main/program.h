// What main() of the project's programs does.
#pragma once

#include "planner/main/command_line.h"

namespace prehend {

// Runs the command that the arguments of main() ask for, one of those that `add` declares. Returns
// the exit status: 2 for a caller's mistake, of which it prints one line to stderr, and 1 for any
// other failure.
int run_program(int argc, char** argv, const AddCommands& add);

}  // namespace prehend

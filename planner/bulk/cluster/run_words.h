// Runs other programs by their words, without a shell.
#pragma once

#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace prehend {

// What came of a program.
struct Finished {
  int status = -1;  // its exit status; -1 when a signal ended it
  std::string out;
  std::string err;
};

// Runs words[0], looked for in PATH, with the other words, without input, and waits for its end. It
// begins with all signals as usual. Throws InputError, whose field is the program, when it cannot
// be started.
Finished run_words(const std::vector<std::string>& words);

// As run_words, but throws InputError that has the first line that the program said when its status
// is not 0, and returns what it printed.
std::string printed_by(const std::vector<std::string>& words);

// Starts a program in a session of its own, which outlives the caller; what it says is added to the
// file `log`. Returns its process id, which is also that of its group. Throws as run_words.
pid_t start_detached(const std::vector<std::string>& words, const std::filesystem::path& log);

}  // namespace prehend

// Words of scripts that mean any text as it is.
#pragma once

#include <string>

namespace prehend {

// One word of a POSIX shell.
std::string shell_word(const std::string& text);

// One word of a command of GNU parallel, in which it finds nothing to replace.
std::string parallel_word(const std::string& text);

// One argument in a line "#SBATCH --option=...".
std::string sbatch_word(const std::string& text);

}  // namespace prehend

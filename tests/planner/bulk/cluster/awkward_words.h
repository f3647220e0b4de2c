// Names of files that scripts are easily mistaken about.
#pragma once

#include <string>
#include <vector>

#include "planner/bulk/cluster/run_words.h"
#include "sim/base/input_error.h"

namespace prehend::test {

// Each character that a shell, GNU parallel or Slurm gives a meaning, alone and among others.
inline std::vector<std::string> awkward_words() {
  std::vector<std::string> words{
      "",        "a b",    " ",      "it's",  "say \"so\"", "$HOME",     "`id`",
      "$(id)",   "a\\b",   "\\",     "a\\ b", "a;b",        "a&b|c>d<e", "*?[a-z]",
      "~",       "#a",     "a #b",   "!!",    "{}",         "{a,b}",     "{1}{.}{/}",
      "{= 1;=}", "{{}}",   "{#}{%}", "%a%%",  "-n",         "--",        "\xC3\xA4\xE2\x82\xAC",
      "\xFF",    "'\"'\"'"};
  for (int c = 33; c < 127; ++c) words.push_back(std::string("x") + static_cast<char>(c) + "y");
  std::string all;
  for (int c = 32; c < 127; ++c) all += static_cast<char>(c);
  words.push_back(all);
  return words;
}

inline bool has_program(const std::string& program) {
  try {
    return run_words({program, "--version"}).status == 0;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace prehend::test

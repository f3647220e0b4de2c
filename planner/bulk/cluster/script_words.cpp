#include "planner/bulk/cluster/script_words.h"

namespace prehend {
namespace {

// In single quotes; `after_brace` follows each {.
std::string in_quotes(const std::string& text, const std::string& after_brace) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
    if (c == '{') word += after_brace;
  }
  return word + "'";
}

}  // namespace

std::string shell_word(const std::string& text) { return in_quotes(text, ""); }

// All that parallel replaces begins with a brace; this one is followed by quotes that say nothing.
std::string parallel_word(const std::string& text) { return in_quotes(text, "''"); }

// Slurm takes what follows a backslash as it is, with and without quotes around it.
std::string sbatch_word(const std::string& text) {
  std::string word = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\' || c == '\'') word += '\\';
    word += c;
  }
  return word + "\"";
}

}  // namespace prehend

#include "benchmarks/suite/arguments.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "benchmarks/report/names.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

constexpr const char* kKeptFolder = "benchmarks/results";
constexpr const char* kOtherFolder = "out/bench";

double number_above_zero(const std::string& option, const std::string& text) {
  std::size_t read = 0;
  double value = 0.0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  const bool fits = read == text.size() && !text.empty() && std::isfinite(value) && value > 0.0;
  require(fits, {.field = option, .problem = "must be a number above 0", .value = text});
  return value;
}

Command command_of(const std::string& word) {
  if (word == "hands") return Command::hands;
  if (word == "page") return Command::page;
  if (word == "compare") return Command::compare;
  if (word == "memory") return Command::memory;
  if (word == "help") return Command::help;
  return Command::run;
}

// Takes the word at `i`, and the next one where it is its value.
void take(const std::vector<std::string>& words, std::size_t& i, Arguments& arguments) {
  const std::string& word = words[i];
  if (word == "--quick" || word == "--smoke") {
    arguments.effort = word == "--quick" ? Effort::quick : Effort::smoke;
  } else if (word == "--help") {
    arguments.command = Command::help;
  } else if (word == "--out" || word == "--most") {
    require(i + 1 < words.size(), {.field = word, .problem = "needs a value"});
    const std::string& value = words[++i];
    if (word == "--out") arguments.folder = value;
    if (word == "--most") arguments.most = number_above_zero(word, value);
  } else if (word.starts_with("-")) {
    throw InputError({.field = word, .problem = "unknown option"});
  } else {
    arguments.words.push_back(word);
  }
}

// The words of a run are parts; each at most once, in the order of the suite.
void take_parts(Arguments& arguments) {
  for (const std::string& word : arguments.words) {
    const bool known = std::find(kParts.begin(), kParts.end(), word) != kParts.end();
    require(known, {.field = word,
                    .problem = "is no part of the suite: kernels, trials, plans, trade, scaling"});
  }
  for (const char* part : kParts) {
    const bool named =
        std::find(arguments.words.begin(), arguments.words.end(), part) != arguments.words.end();
    if (named || arguments.words.empty()) arguments.parts.emplace_back(part);
  }
  if (!arguments.folder.empty()) return;
  const bool whole = arguments.effort == Effort::full && arguments.parts.size() == kParts.size();
  arguments.folder = whole ? kKeptFolder : kOtherFolder;
}

std::string folder_of(const std::string& file) {
  return std::filesystem::absolute(file).parent_path().string();
}

void require_words(const Arguments& arguments, std::size_t count, const char* problem) {
  require(arguments.words.size() == count, {.problem = problem});
}

}  // namespace

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  if (!words.empty()) arguments.command = command_of(words.front());
  for (std::size_t i = arguments.command == Command::run ? 0 : 1; i < words.size(); ++i) {
    take(words, i, arguments);
  }
  switch (arguments.command) {
    case Command::run:
      take_parts(arguments);
      break;
    case Command::hands:
      require(!arguments.words.empty(), {.problem = "hands takes folders of meshes, or meshes"});
      if (arguments.folder.empty()) arguments.folder = kKeptFolder;
      break;
    case Command::page:
      require_words(arguments, 1, "page takes one file of results");
      if (arguments.folder.empty()) arguments.folder = folder_of(arguments.words.front());
      break;
    case Command::compare:
      require_words(arguments, 2, "compare takes two files of results");
      break;
    case Command::memory:
      require_words(arguments, 3, "memory takes a size, its value and a number of trials");
      break;
    case Command::help:
      break;
  }
  return arguments;
}

std::string usage() {
  return "bench [kernels] [trials] [plans] [trade] [scaling] [--quick | --smoke] [--out FOLDER]\n"
         "    measures these parts, or all; writes results.json, results.md and plots\n"
         "bench hands FOLDER|MESH... [--out FOLDER]\n"
         "    every hand of the library on every object; writes hands.md\n"
         "bench page RESULTS.json [--out FOLDER]\n"
         "    makes the page and the plots of stored results again\n"
         "bench compare OLD.json NEW.json [--most 1.10]\n"
         "    every entry by ratio of medians; exit status 1 if a time grew by more than that\n";
}

}  // namespace prehend::bench

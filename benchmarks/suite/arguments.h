// The words of the command line of the suite.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/suite/effort.h"

namespace prehend::bench {

enum class Command { run, hands, page, compare, memory, help };

struct Arguments {
  Command command = Command::run;
  // Of run.
  std::vector<std::string> parts;  // in the order of kParts; all where none was named
  Effort effort = Effort::full;
  // Where results, page and plots go. Only a whole run at full effort goes where they are kept;
  // of a page: beside its results.
  std::string folder;
  // Of hands meshes and folders, of page one file of results, of compare two; of memory what
  // memory.h says.
  std::vector<std::string> words;
  double most = 1.10;  // of compare: the largest ratio that is no slowdown
};

// Throws InputError that names the word.
Arguments read_arguments(const std::vector<std::string>& words);

// What --help prints.
std::string usage();

}  // namespace prehend::bench

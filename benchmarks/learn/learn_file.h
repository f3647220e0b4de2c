// Runs of searches as a text file, so that what took long has to be done once.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "benchmarks/learn/learn_cases.h"

namespace prehend::bench {

// A line "set OBJECT HAND SEED TRIALS", then a line for each trial: outcome, epsilon, features.
void write_run(const LearnRun& run, std::ostream& stream);

// The runs of a file. The last is left out where its trials are not all there. Throws InputError
// for a file that cannot be read, or of features of another number.
std::vector<LearnRun> read_runs(const std::filesystem::path& file);

}  // namespace prehend::bench

// Result files of the benchmarks: JSON, written whole or not at all (docs/how-to/benchmarks.md).
#pragma once

#include <filesystem>
#include <string>

#include "benchmarks/report/results.h"

namespace prehend::bench {

// The content of a result file.
std::string results_json(const Results& results);

// Throws InputError that names the file and the field.
Results read_results(const std::filesystem::path& file);

}  // namespace prehend::bench

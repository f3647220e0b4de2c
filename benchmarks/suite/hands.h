// Every hand of the library on many objects: which hand holds what.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/hands_page.h"

namespace prehend::bench {

// A plan with the defaults for each hand of the library and each object. `paths`: mesh files in
// metres, folders with such files, and scene files of an object; those of a folder in the order of
// their names. Throws InputError for a path that is not there and for a file that cannot be read.
std::vector<HandOnObject> plan_hands(const std::vector<std::string>& paths);

}  // namespace prehend::bench

// Files of protocols, and the library of protocols that comes with prehend.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/manipulation/test_procedure.h"

namespace prehend {

// The protocol that a JSON file describes (docs/reference/test-procedure-file.md). Throws
// InputError that names file and field, also for fields that no protocol has.
TestProcedure read_test_procedure(const std::filesystem::path& file);

// The same text as a file; `name` stands for it in messages.
TestProcedure parse_test_procedure(const std::string& text, const std::string& name);

// Names of the protocols in the data folder, sorted.
std::vector<std::string> library_test_procedure_names();

// The file of a protocol that is given as a path or as a name of the library. Throws InputError
// that lists the library's names.
std::filesystem::path find_test_procedure(const std::string& name_or_file);

}  // namespace prehend

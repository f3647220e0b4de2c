// Files of tree models (docs/how-to/learning.md).
#pragma once

#include <filesystem>
#include <string>

#include "planner/plan/learn/tree_model.h"

namespace prehend {

// "format" of such files.
inline constexpr const char* kTreeModelFormat = "prehend trees 1";

// Reads what tree_model_json writes. The name of the model is that of the file, without its folder
// and extension. Throws InputError that names the file and the field: for a field that is missing
// or not known, a value of another type, and all that check() refuses.
TreeModel read_tree_model(const std::filesystem::path& file);
// The same of a text that would be in `file`.
TreeModel parse_tree_model(const std::filesystem::path& file, const std::string& text);

// The model as text, without its name. Numbers have the digits that reading back takes to get the
// same model, bit by bit.
std::string tree_model_json(const TreeModel& model);

}  // namespace prehend

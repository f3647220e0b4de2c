// JSON text for people.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace prehend {

// The value as JSON text in lines of at most 100 characters where that is possible: what fits stays
// on one line, the rest is divided into its items, indented by two spaces. Numbers read back as the
// same. Text that is not UTF-8 gets U+FFFD in the place of what is not. Ends with a line break.
std::string wrapped_json(const nlohmann::ordered_json& value);

}  // namespace prehend

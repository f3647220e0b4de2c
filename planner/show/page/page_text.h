// The text of a page, filled in.
#pragma once

#include <string>
#include <string_view>

namespace prehend {

// The page with `json`, a JSON text, in place of its first "/*DATA*/", which stands in a script
// element. Throws std::logic_error for a page without that.
std::string page_with_data(std::string_view page, const std::string& json);

// The page with `value` wherever it says "{{name}}".
std::string page_with(std::string page, std::string_view name, std::string_view value);

}  // namespace prehend

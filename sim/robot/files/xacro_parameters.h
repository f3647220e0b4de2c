// The parameters of a macro of xacro.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prehend {

struct XacroParameter {
  std::string name;
  int stars = 0;                              // 1: an element, 2: what is in an element; 0: a value
  bool is_forwarded = false;                  // "^": the value that the name has around the call
  std::optional<std::string> otherwise = {};  // the text of its default
};

// Of the text of "params": "prefix side:=1 *origin width:=^|0.1". Throws InputError without a place
// for what is no name.
std::vector<XacroParameter> xacro_parameters(std::string_view text);

}  // namespace prehend

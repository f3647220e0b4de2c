#include "sim/base/json/json_depth.h"

#include <algorithm>

namespace prehend {

int json_depth(std::string_view text) {
  int open = 0;
  int deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;  // what is escaped does not end the string
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '[' || c == '{') deepest = std::max(deepest, ++open);
    if (c == ']' || c == '}') --open;
    // Deep enough to be refused; counting on could overflow.
    if (open > 1'000'000) break;
  }
  return deepest;
}

}  // namespace prehend

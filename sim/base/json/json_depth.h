// How deep JSON text is nested.
#pragma once

#include <string_view>

namespace prehend {

// Levels of lists and objects that readers accept. Files of prehend need fewer than ten, glTF some
// more; copying, printing and destroying a deep value recurses once a level and would overflow the
// stack.
inline constexpr int kDeepestJson = 200;

// The number of lists and objects that are open at once where the text is nested deepest; brackets
// inside strings do not count. The text need not be valid JSON.
int json_depth(std::string_view text);

}  // namespace prehend

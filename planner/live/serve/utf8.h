// Whether bytes are text.
#pragma once

#include <string_view>

namespace prehend {

// Whether the bytes are UTF-8 as RFC 3629 has it: no overlong forms, no surrogates, nothing above
// U+10FFFF. The empty text is.
bool is_utf8(std::string_view bytes);

// Whether the bytes are UTF-8 without control characters, but for tabs.
bool is_plain_text(std::string_view bytes);

}  // namespace prehend

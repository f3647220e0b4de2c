// Text inside HTML, SVG and XML.
#pragma once

#include <string>
#include <string_view>

namespace prehend {

// Text with the characters that HTML and XML reserve replaced; control characters become spaces.
std::string markup_text(std::string_view text);

}  // namespace prehend

// The report's page (page/) with its style, its scripts and three.js in it, made by the build.
#pragma once

#include <string_view>

namespace prehend {

// The page up to its data, and from there on: between the two stands JSON in a script element.
std::string_view page_before_data();
std::string_view page_after_data();

}  // namespace prehend

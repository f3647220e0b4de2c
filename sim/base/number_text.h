// Numbers as text that reads back as exactly the same number, in every reader.
#pragma once

#include <string>

namespace prehend {

// The shortest decimal that reads back as `value`: "1", "0.1", "1e-05", "inf".
std::string shortest_text(double value);

// The same, but always with a point: readers of YAML 1.1 (PyYAML, and so ROS and Isaac Sim) take
// 1e-05 for a word. Throws InputError for what is not finite.
std::string number_text(double value);

}  // namespace prehend

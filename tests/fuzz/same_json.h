// Compares what was written with what is written of it after it was read.
#pragma once

#include <string>

namespace prehend::fuzz {

// Whether two JSON texts are the same but for rounding: numbers may differ by 1e-9 of the largest
// in their list (of 1 where that is smaller), and a quaternion may be the negative of the other.
// Reading a pose turns its quaternion into a matrix, writing turns it back, each with an error in
// the last digit.
bool same_but_rounded(const std::string& a, const std::string& b);

}  // namespace prehend::fuzz

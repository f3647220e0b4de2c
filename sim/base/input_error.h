// The exception for a caller's mistake: a file, a field and a value that cannot be used.
#pragma once

#include <stdexcept>
#include <string>

namespace prehend {

// The message is one line, ready to print: "FILE: FIELD: what is wrong (VALUE)".
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace prehend

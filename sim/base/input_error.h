// The exception for a caller's mistake: a file, a field and a value that cannot be used.
#pragma once

#include <concepts>
#include <stdexcept>
#include <string>

namespace prehend {

// The parts of the message; each may be empty.
struct InputErrorParts {
  std::string file = {};
  // Path of the field from the outermost object that the thrower knows:
  // "grasps[3].contacts[0].link". In calls from C++ and not from a file, the argument or the member
  // of the options.
  std::string field = {};
  std::string problem = {};
  std::string value = {};  // as it was given
};

// what() is one line, ready to print: "FILE: FIELD: problem (VALUE)", without the parts that are
// empty. Who calls a function that knows less of the place adds what he knows:
//   catch (const InputError& error) { throw error.under("contacts[3]").in_file(path); }
class InputError : public std::invalid_argument {
 public:
  // A template so that a list in braces is never taken for a text: only InputErrorParts has lists.
  template <std::convertible_to<std::string> Text>
  explicit InputError(const Text& problem) : InputError(InputErrorParts{.problem = problem}) {}
  explicit InputError(InputErrorParts parts);

  const std::string& file() const { return parts_.file; }
  const std::string& field() const { return parts_.field; }
  const std::string& problem() const { return parts_.problem; }
  const std::string& value() const { return parts_.value; }

  // The same error in a file; an error that names one already stays as it is.
  InputError in_file(const std::string& file) const;
  // The same error with its field inside `outer`: "link" under "contacts[3]" is "contacts[3].link".
  InputError under(const std::string& outer) const;

 private:
  InputErrorParts parts_;
};

}  // namespace prehend

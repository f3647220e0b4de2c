// The exception for invalid input: a file, a field or an argument that cannot be used.
#pragma once

#include <concepts>
#include <stdexcept>
#include <string>

namespace prehend {

// The parts of the message of an InputError; each may be empty.
struct InputErrorParts {
  // The file; for what was not read from one, the name of the robot or scene.
  std::string file = {};
  // Path of the field from the outermost object known where the error is thrown, such as
  // "grasps[3].contacts[0].link". For calls from C++, the name of the argument or of the member of
  // the options.
  std::string field = {};
  std::string problem = {};
  std::string value = {};  // the rejected value as text
};

// Input that cannot be used. what() is one line for the user: "FILE: FIELD: problem (VALUE)",
// without the parts that are empty. Callers that know more of the place add it:
// catch (const InputError& error) { throw error.under("contacts[3]").in_file(path); }
class InputError : public std::invalid_argument {
 public:
  // An error that states only the problem. A template, because a parameter of type std::string
  // could be made from a list in braces: InputError({...}) must always mean InputErrorParts.
  template <std::convertible_to<std::string> Text>
  explicit InputError(const Text& problem) : InputError(InputErrorParts{.problem = problem}) {}
  explicit InputError(InputErrorParts parts);

  const std::string& file() const { return parts_.file; }
  const std::string& field() const { return parts_.field; }
  const std::string& problem() const { return parts_.problem; }
  const std::string& value() const { return parts_.value; }

  // This error with the file set. An error that already names a file is returned unchanged.
  InputError in_file(const std::string& file) const;
  // This error with its field placed inside `outer`: "link" under "contacts[3]" becomes
  // "contacts[3].link".
  InputError under(const std::string& outer) const;
  // This error as one of `field`, whose value a function refused: without the function's own name
  // for it, and with `value` where the error has none. An error that names a file becomes the
  // problem as a whole: it is a fault of what the field refers to.
  InputError about(const std::string& field, const std::string& value = {}) const;

 private:
  InputErrorParts parts_;
};

// The text with each control character (line breaks, escapes) replaced by a space. Names of files
// and fields may contain any, and a message is one line. what() of an InputError is like this; its
// parts are as they were given.
std::string on_one_line(std::string text);

// Throws InputError with these parts unless the condition holds. The parts are made in any case:
// for checks that run once a call, not once a grasp.
void require(bool condition, InputErrorParts parts);

}  // namespace prehend

#include "sim/base/input_error.h"

#include <algorithm>
#include <utility>

namespace prehend {
namespace {

// "FILE: FIELD: problem (VALUE)" without the empty parts.
std::string one_line(const InputErrorParts& parts) {
  std::string line;
  for (const std::string* part : {&parts.file, &parts.field, &parts.problem}) {
    if (part->empty()) continue;
    line += (line.empty() ? "" : ": ") + *part;
  }
  if (!parts.value.empty()) line += (line.empty() ? "(" : " (") + parts.value + ")";
  return on_one_line(line);
}

}  // namespace

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

InputError::InputError(InputErrorParts parts)
    : std::invalid_argument(one_line(parts)), parts_(std::move(parts)) {}

InputError InputError::in_file(const std::string& file) const {
  if (!parts_.file.empty()) return *this;
  InputErrorParts parts = parts_;
  parts.file = file;
  return InputError(std::move(parts));
}

InputError InputError::under(const std::string& outer) const {
  if (outer.empty()) return *this;
  InputErrorParts parts = parts_;
  // "[3]" follows its list directly, a name follows after a dot.
  const bool joined = parts.field.empty() || parts.field.front() == '[';
  parts.field = outer + (joined ? "" : ".") + parts.field;
  return InputError(std::move(parts));
}

InputError InputError::about(const std::string& field, const std::string& value) const {
  if (!parts_.file.empty()) return InputError({.field = field, .problem = what()});
  return InputError({.field = field,
                     .problem = parts_.problem,
                     .value = parts_.value.empty() ? value : parts_.value});
}

void require(bool condition, InputErrorParts parts) {
  if (!condition) throw InputError(std::move(parts));
}

}  // namespace prehend

// Expressions in xacro files, such as ${width / 2 + 0.01}: the arithmetic part of Python that
// robot descriptions use. Source: https://wiki.ros.org/xacro
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace prehend {

struct XacroValue;
using XacroList = std::shared_ptr<const std::vector<XacroValue>>;
using XacroMap = std::shared_ptr<const std::map<std::string, XacroValue>>;

// A value of Python; std::monostate is None. Maps come from YAML files.
struct XacroValue {
  std::variant<std::monostate, bool, long long, double, std::string, XacroList, XacroMap> value =
      {};
};

// What the words of a file that are not its own stand for. Its functions throw InputError without a
// place.
class XacroWords {
 public:
  virtual ~XacroWords() = default;
  virtual XacroValue property(const std::string& name) = 0;
  // What "$(words)" stands for, of find, arg and the like.
  virtual std::string command(const std::string& words) = 0;
  // Of a file that was included with a namespace; nothing where there is no such namespace.
  virtual std::optional<XacroValue> property_of(const std::string& space,
                                                const std::string& name) = 0;
  // What the YAML file of this name holds.
  virtual XacroValue load_yaml(const std::string& name) = 0;
};

// The value of an expression: numbers, texts, lists of these, True, False, None, properties, + - *
// / // %
// **, comparisons, in, and, or, not, A if C else B, indices, members and a few methods of maps and
// texts (xacro_members.h), load_yaml, and the functions of Python's math with abs, min, max, round,
// int, float, str, bool and len. Throws InputError without a place for
// what is none, for what cannot be computed, and for one that is longer than 2,000 characters or
// nested deeper than 50.
XacroValue xacro_expression(std::string_view text, XacroWords& words);

// Text with each ${EXPRESSION} and $(COMMAND) replaced; "$$" is "$". Throws InputError as above,
// and for a result of more than 100,000 characters.
std::string xacro_text(std::string_view text, XacroWords& words);

// The value that an attribute states: the same, but what is one expression keeps its type, and what
// reads as a number or as true or false is one.
XacroValue xacro_value(std::string_view text, XacroWords& words);

// What text means as the value of a property: a number, true or false where it looks like one.
XacroValue literal_of(const std::string& text);

// As Python's str().
std::string text_of(const XacroValue& value);

// Whether a condition holds: a value of "true", "false" or a number. Throws InputError for others.
bool holds(const XacroValue& value);

}  // namespace prehend

// The grammar of expressions in xacro files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/robot/files/xacro_expression.h"

namespace prehend {

// A part of an expression and what it is made of.
struct XacroNode {
  enum class Kind {
    literal,
    name,    // `word`: of a property
    call,    // `word`: of a function; parts: its arguments
    list,    // parts: its elements
    index,   // parts: a list, and which
    member,  // `word`: its name; parts: a map
    method,  // `word`: its name; parts: a map or text, then its arguments
    unary,   // `word`: - + not
    binary,  // `word`: an operator, a comparison, and, or, in, not in
    choose,  // parts: the condition, the value where it holds, the other
  };
  Kind kind = Kind::literal;
  std::string word = {};
  XacroValue value = {};
  std::vector<XacroNode> parts = {};
};

// Throws InputError without a place: what is no expression, one that is longer than 2,000
// characters or nested deeper than 50.
XacroNode parse_xacro(std::string_view text);

}  // namespace prehend

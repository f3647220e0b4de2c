// What GraspIt! writes for a joint's theta or d: a number, or how a degree of freedom drives it.
#pragma once

#include <optional>
#include <string_view>

namespace prehend {

// "d2*0.5-3": degree of freedom 2 times 0.5, less 3. The ratio may be missing, and so may the
// constant; both may have a sign ("d1*-1+-3.1"). Units are those of the file.
struct GraspitExpression {
  std::optional<int> dof = {};  // empty: only the constant
  double ratio = 1.0;
  double constant = 0.0;
};

// Nothing for text that is neither a number nor such an expression as a whole. GraspIt! itself
// knows only "*" and "+", and takes "d1-2.46" for "d1".
std::optional<GraspitExpression> graspit_expression(std::string_view text);

}  // namespace prehend

#include "sim/robot/closed_form.h"

#include "sim/robot/spherical_wrist.h"
#include "sim/robot/ur_arm.h"

namespace prehend {

ClosedForm closed_form_of(const Robot& robot, const Chain& chain) {
  if (spherical_wrist_defect(robot, chain).empty()) return ClosedForm::spherical_wrist;
  return ur_arm_defect(robot, chain).empty() ? ClosedForm::ur : ClosedForm::none;
}

}  // namespace prehend

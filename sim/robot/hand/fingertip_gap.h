// How far the only finger of a hand is from what it closes onto.
#pragma once

#include <vector>

#include "sim/robot/hand/fingers.h"
#include "sim/shape/proximity.h"

namespace prehend {

// Asks about the outer half of the first finger's last link and all links of the palm: its root may
// touch what it hangs on. Keeps a reference to the robot.
class FingertipGap {
 public:
  FingertipGap(const Robot& robot, const HandParts& parts);

  // The distance for one value per degree of freedom, 0: they touch or cross [m]. Of a jaw that
  // slides it is how far it may slide, to either side: it stands closer to the palm that it slides
  // above than to what it closes on.
  double at(const std::vector<double>& dofs) const;

 private:
  double distance(const Pose& X_BT, const std::vector<Pose>& X_BL) const;
  double way(const Vector3& along, const Pose& X_BT, const std::vector<Pose>& X_BL) const;

  const Robot& robot_;
  int slide_ = -1;  // the last joint, where it slides
  int tip_link_;
  std::vector<int> palm_links_;
  ProximityMesh tip_;
  std::vector<ProximityMesh> palm_;
};

}  // namespace prehend

// Closes a hand on a simple body that stays where it is, to see whether it holds it.
#pragma once

#include <vector>

#include "sim/robot/hand/closing_dofs.h"
#include "sim/robot/hand/self_collision.h"

namespace prehend {

// Keeps references to all of its arguments.
class TestClosing {
 public:
  TestClosing(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
              const SelfCollision& collision);

  // How far the hand that opened to `dofs` reaches from `origin` along the unit vector `approach`
  // [m].
  double reach(const Vector3& origin, const Vector3& approach,
               const std::vector<double>& dofs) const;

  // How far a hand that opened to `dofs` can come towards the body: the distance along the unit
  // vector `approach` (base frame) by which the body at X_BS may move back against it until a link
  // touches, at most `most` [m]. Negative: a link is in the way already.
  double way_in(const ProximityMesh& body, const Pose& X_BS, const Vector3& approach, double most,
                const std::vector<double>& dofs) const;

  // The pose of the body after the only finger of the hand has pushed it, at most by `most` [m],
  // until it meets the part that does not move; X_BS for other hands, and where it meets none.
  Pose pushed(const ProximityMesh& body, const Pose& X_BS, const Vector3& approach, double most,
              const std::vector<double>& dofs) const;

  // Epsilon of the grasp in which the hand ends that closes from `dofs` on the body at X_BS, with a
  // friction of 0.5 and torques over the body's radius; 0: it does not hold. Joints stop as
  // JointCourse says. 0 as well where fingers cross each other or the palm.
  double hold(const ProximityMesh& body, const Pose& X_BS, const std::vector<double>& dofs,
              std::size_t thumb) const;

 private:
  struct Reaching {  // a link that closing moves
    int link = 0;
    std::vector<int> joints;  // of those that close, between the palm and the link
    std::vector<double>
        arms;  // bounds of the link's points from their axes [m], 1 for one that slides
  };
  struct Apart {  // links that must not cross, and the fingers that they belong to
    int a = 0;
    int b = 0;
    int owner_a = 0;
    int owner_b = 0;
  };
  bool crossing(const std::vector<Pose>& X_BL, std::size_t thumb) const;
  double score(const ProximityMesh& body, const Pose& X_BS, const std::vector<Pose>& X_BL) const;

  const Robot& robot_;
  const ClosingDofs& closing_;
  const SelfCollision& collision_;
  std::vector<Reaching> reaching_;
  std::vector<Apart> apart_;
};

}  // namespace prehend

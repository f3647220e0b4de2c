// The sizes that a hand holds from an opening, measured by closing it.
#pragma once

#include <optional>
#include <string>

#include "sim/robot/hand/fingertip_gap.h"
#include "sim/robot/hand/opposition.h"
#include "sim/robot/hand/self_collision.h"

namespace prehend {

// Keeps references to all of its arguments.
class PreshapeMeasure {
 public:
  PreshapeMeasure(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                  const Hand& hand, const SelfCollision& collision)
      : robot_(robot), parts_(parts), closing_(closing), hand_(hand), collision_(collision) {
    if (parts.fingers.size() < 2) tip_gap_.emplace(robot, parts);
  }

  // The size of the largest body that the hand takes from an opening with its middle on the line
  // from the origin along the approach: twice the smaller distance of thumb and others from that
  // line, or their gap where it does not pass between them [m]. Fingers that turn push a body out
  // of the hand until their last links stand along the approach, and count from there on.
  double widest(const Opposition& opening) const { return widest(opening, 0.0); }

  // Whether a last link turns until thumb and fingers meet. Those of jaws and of parallel linkages
  // do not: half closed they are as when open.
  bool turns(const Opposition& opening) const;

  // How far the middle of the opening is from that line, along the closing axis [m].
  double off_middle(const Opposition& opening) const;

  // The preshape at which this part of the opening's gap is closed (0: open), or a little later
  // where links collide there. Nothing where they collide until half of the rest is closed, or
  // where the gap between thumb and fingers does not close by at least a tenth.
  std::optional<Preshape> at(const std::string& name, const Opposition& opening, double part) const;

 private:
  double gap(const Opposition& opening, const std::vector<double>& dofs) const;
  struct Sides {  // of the opening, along the closing axis [m]
    double thumb = 0.0;
    double others = 0.0;
  };
  Sides sides(const Opposition& opening, double start) const;
  double widest(const Opposition& opening, double start) const;
  double upright(const Opposition& opening, std::size_t finger, double start) const;
  double depth(const Opposition& opening, const std::vector<double>& dofs) const;
  bool touching(const Opposition& opening, const std::vector<double>& dofs) const;

  const Robot& robot_;
  const HandParts& parts_;
  const ClosingDofs& closing_;
  const Hand& hand_;
  const SelfCollision& collision_;
  std::optional<FingertipGap> tip_gap_;  // of the only finger
};

}  // namespace prehend

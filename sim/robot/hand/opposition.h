// Which finger is the thumb, and how the others have to stand for it to oppose them.
#pragma once

#include <vector>

#include "sim/robot/hand/closing_dofs.h"

namespace prehend {

// Tips of the fingers, one per finger, for one value per degree of freedom; base frame [m].
std::vector<Vector3> tips_at(const Robot& robot, const HandParts& parts,
                             const std::vector<double>& dofs);

// The mean of all tips but that of the thumb.
Vector3 mean_of_others(const std::vector<Vector3>& tips, std::size_t thumb);

struct Opposition {
  std::size_t thumb = 0;     // of the fingers
  std::vector<double> dofs;  // of the open hand [rad or m]
  // How much of the way between thumb and fingers both of them close, 1: half of it each, less
  // twice the part of it that is left between them when they are nearest. At most 1.
  double score = 0.0;
  double meeting = 0.0;  // when they are nearest [s]
};

// The opposition of `thumb` to the other fingers, from `dofs` of the open hand. A hand has at least
// two fingers here.
Opposition opposition_of(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                         std::size_t thumb, const std::vector<double>& dofs);

// Degrees of freedom that move fingers over more than 0.6 rad without closing them: spreads, and
// what turns a thumb.
std::vector<std::size_t> posing_dofs(const Robot& robot, const HandParts& parts,
                                     const ClosingDofs& closing);

// The best opposition among all fingers as thumb and all values of the posing degrees of freedom,
// found one of them at a time from the initial values, of which a good reason is needed to depart.
Opposition best_opposition(const Robot& robot, const HandParts& parts, const ClosingDofs& closing);

// The best one, then at most `most` - 1 others of the same thumb that oppose nearly as well with a
// posing degree of freedom about a quarter of its range away, best first.
std::vector<Opposition> good_oppositions(const Robot& robot, const HandParts& parts,
                                         const ClosingDofs& closing, std::size_t most);

}  // namespace prehend

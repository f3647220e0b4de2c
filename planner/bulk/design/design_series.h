// What a hand grasps while one of its measures changes.
#pragma once

#include <string>
#include <vector>

#include "planner/bulk/design/vary_hand.h"
#include "planner/plan/plan.h"
#include "sim/scene/scene.h"

namespace prehend {

// Of one value and one object.
struct DesignPoint {
  double value = 0.0;
  std::string object;
  double epsilon = 0.0;  // of the best grasp; 0: there is none
  int stable = 0;        // of the trials
  int trials = 0;
  double opening = 0.0;      // largest size that an opening of the hand takes [m]
  std::string problem = {};  // why a hand of this value cannot be planned with; empty: it can
};

// Plans each scene with the hand at each value, values one after the other, the scenes of a value
// in their order. The hand is that of the scenes, which have no arm. The same result on any number
// of threads. Throws InputError for scenes with arms and of different hands, and as with_measure
// where no value gives a hand; Cancelled.
std::vector<DesignPoint> design_series(const std::vector<Scene>& scenes,
                                       const HandVariation& variation, const PlanOptions& options,
                                       const RunContext& context = {});

// As a table with comma-separated values, as a table for people, and as a page with a plot.
std::string design_csv(const std::vector<DesignPoint>& points, const HandVariation& variation);
std::string design_table(const std::vector<DesignPoint>& points, const HandVariation& variation);
std::string design_page(const std::vector<DesignPoint>& points, const HandVariation& variation,
                        const std::string& hand);

}  // namespace prehend

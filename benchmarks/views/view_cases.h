// Grasps planned from what a camera sees, tried on what is there.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/shape/cloud/reconstruct.h"

namespace prehend::bench {

// From what a grasp is planned.
enum class PlannedFrom {
  one_view,
  one_view_sure,  // the same, the best of its grasps by their mean on all shapes
  three_views,    // from sides that are a third of a turn apart
  three_views_sure,
  hull,  // the convex hull of what one view saw
  truth  // the mesh itself
};

constexpr auto enum_names(PlannedFrom /*of*/) {
  return std::to_array<std::string_view>(
      {"one view", "one, sure", "three views", "three, sure", "hull", "truth"});
}

// What became of the best grasp of a plan.
struct ViewResult {
  bool found = false;  // a grasp
  bool holds = false;  // on the true mesh, on the table, where the hand comes until it touches
  bool holds_as_planned = false;  // where it goes as far as in the plan
  std::string outcome = {};
  double milliseconds = 0.0;  // that the plan took, by the clock
};

// An object on a table.
struct TableCase {
  std::string name;
  TriangleMesh mesh_W;
};

// A mesh file, placed by pose_on_table.
TableCase table_case(const std::string& file);

// The views of `count` cameras, a part of a turn apart, from `angle` [rad] on, 0.65 m away. How
// steeply they look down, 30 to 45 degrees, goes with the angle.
std::vector<DepthView> views_of(const TableCase& object, double angle, int count);

// The convex hull of the readings of the first object, closed: what is there without completion.
TriangleMesh hull_of_seen(const SeenObject& object);

// A hand at an object on a table.
class Grasping {
 public:
  Grasping(const TableCase& object, std::string hand, int threads);

  // Plans on a mesh in W, and tries the best grasp on the true one. `others`: of the best
  // grasps, the one with the largest mean epsilon on these shapes is tried.
  ViewResult plan_and_try(const TriangleMesh& mesh_W,
                          const std::vector<TriangleMesh>& others = {}) const;
  // Both, with one plan: without and with others.
  std::array<ViewResult, 2> plan_and_try_both(const SeenObject& object) const;

 private:
  std::string hand_;
  TriangleMesh true_W_;
  int threads_;
};

}  // namespace prehend::bench

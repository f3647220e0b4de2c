#include "planner/show/robot_picture.h"

#include <algorithm>

#include "planner/show/palette.h"
#include "planner/show/picture/draw.h"
#include "planner/show/picture/marks.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

std::vector<DrawnBody> bodies_at(const Robot& robot, const NamedPosture& posture) {
  std::vector<Pose> X_BL;
  link_poses(robot, posture.joints, X_BL);
  std::vector<DrawnBody> bodies;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Link& link = robot.links[l];
    const Color& color = link.material == "rubber" ? palette::kRubber
                         : robot.hand              ? palette::kHard
                                                   : palette::kArm;
    bodies.push_back({SharedMesh::borrowed(link.mesh), X_BL[l], color, link.name});
  }
  if (posture.grasped) {
    bodies.push_back({SharedMesh::borrowed(posture.grasped->mesh), posture.grasped->X_BM,
                      palette::kObject, "grasped"});
  }
  return bodies;
}

// Along the approach from the palm to where the fingers meet, and across, as wide as they open.
void add_axes(const Hand& hand, std::vector<DrawnBody>& bodies) {
  if (hand.preshapes.empty() || hand.closing.norm() == 0.0) return;
  const Preshape& open = hand.preshapes.front();
  const double radius = 0.015 * std::max(open.max_width, open.depth);
  const Vector3 middle = hand.origin + open.depth * hand.approach;
  const Vector3 across = 0.5 * open.max_width * hand.closing;
  const auto add = [&](const TriangleMesh& mesh, const Color& color, const char* name) {
    bodies.push_back({SharedMesh(mesh), Pose::Identity(), color, name});
  };
  add(arrow_mesh(hand.origin, middle, radius), palette::kApproach, "approach");
  add(arrow_mesh(middle, middle - across, radius), palette::kClosing, "closing");
  add(arrow_mesh(middle, middle + across, radius), palette::kClosing, "closing");
}

// What the first preshape takes, for the line under it.
std::string opening_of(const Robot& robot) {
  if (!robot.hand || robot.hand->preshapes.empty()) return "";
  return formatted(", up to %.0f mm", 1e3 * robot.hand->preshapes.front().max_width);
}

// Cubes of this size at some of the points, evenly picked.
TriangleMesh dots(const std::vector<Vector3>& points, double size) {
  constexpr std::size_t kMost = 300;
  const TriangleMesh cube = make_box({size, size, size});
  TriangleMesh all;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kMost);
  for (std::size_t i = 0; i < points.size(); i += step) {
    append(all, transformed(cube, translation(points[i])));
  }
  return all;
}

// To the eye: across the plane in which a hand closes, a little from its front and from the side;
// of another robot from the front, the side and above.
Vector3 telling_direction(const Robot& robot) {
  if (!robot.hand) return {1.0, -1.2, 0.6};
  const Vector3& approach = robot.hand->approach;
  const Vector3 closing =
      robot.hand->closing.norm() > 0.0 ? robot.hand->closing : any_orthogonal(approach);
  return approach.cross(closing) + 0.45 * approach + 0.35 * closing;
}

}  // namespace

Image robot_picture(const Robot& robot, const std::vector<NamedPosture>& postures,
                    const PostureSurvey& survey, const PictureSize& size,
                    const RunContext& context) {
  const auto cells = static_cast<int>(postures.size()) + 1;
  const int columns = std::min(cells, 3);
  const int rows = (cells + columns - 1) / columns;
  const DrawOptions cell{.width = size.width / columns, .height = size.height / rows};
  const Vector3 direction = telling_direction(robot);
  std::vector<Image> images;
  const auto draw_cell = [&](const std::vector<DrawnBody>& bodies, const std::string& title) {
    images.push_back(draw(bodies, camera_around(bodies, direction, cell), cell, context));
    write_title(images.back(), title);
  };
  for (const NamedPosture& posture : postures) {
    std::vector<DrawnBody> bodies = bodies_at(robot, posture);
    const bool first = &posture == &postures.front();
    if (first && robot.hand) add_axes(*robot.hand, bodies);
    draw_cell(bodies, posture.name + (first ? opening_of(robot) : ""));
  }
  std::vector<DrawnBody> reached = bodies_at(robot, postures.front());
  for (std::size_t t = 0; t < survey.tips.size(); ++t) {
    const TipWorkspace& tip = survey.tips[t];
    if (tip.points.empty() || !(tip.box.diagonal() > 0.0)) continue;  // none, or it never moves
    constexpr double kDot = 0.008;  // of the size of the workspace
    reached.push_back({SharedMesh(dots(tip.points, kDot * tip.box.diagonal())), Pose::Identity(),
                       palette::kTips[t % palette::kTips.size()], tip.name});
  }
  draw_cell(reached, "where the tips get");
  return grid(images, columns);
}

}  // namespace prehend

#include "planner/show/grasp_picture.h"

#include <cmath>
#include <numbers>

#include "planner/show/grasp_bodies.h"
#include "planner/show/palette.h"
#include "planner/show/picture/draw.h"
#include "planner/show/picture/label.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

// All bodies, from a camera so near that `framed` fill the picture.
Image view(const std::vector<DrawnBody>& all, const std::vector<DrawnBody>& framed,
           const Vector3& direction, const PictureSize& size, const RunContext& context) {
  const DrawOptions draw_options{.width = size.width, .height = size.height};
  return draw(all, camera_around(framed, direction, draw_options), draw_options, context);
}

}  // namespace

void write_title(Image& image, const std::string& title) {
  if (title.empty()) return;
  constexpr int kScale = 2;
  const TextSize size = text_size(title, kScale);
  label(image, 12, image.height - size.height - 12, title, palette::kText, kScale);
}

Image grasp_picture(const CompiledScene& scene, const PosedGrasp& grasp, const Vector3& direction,
                    const PictureSize& size, const RunContext& context) {
  const GraspBodies bodies = grasp_bodies(scene, grasp);
  Image image = view(bodies.all(), bodies.grasp(), direction, size, context);
  write_title(image, grasp.title);
  return image;
}

Image arm_picture(const CompiledScene& scene, const PosedGrasp& grasp, const PictureSize& size,
                  const RunContext& context) {
  const GraspBodies bodies = grasp_bodies(scene, grasp);
  std::vector<DrawnBody> all = bodies.grasp_and_arm();
  all.insert(all.end(), bodies.obstacles.begin(), bodies.obstacles.end());
  // From the side of the way from the arm's base to the object, a little from behind and above.
  // Where the object is straight above the base, any side will do.
  const Vector3 way = scene.scene.object.X_WO.translation() - scene.arm->X_WB.translation();
  Vector3 aside = Vector3::UnitZ().cross(way);
  if (!(aside.norm() > 1e-6)) aside = Vector3::UnitX();
  const Vector3 direction = aside.normalized() - 0.3 * way.normalized() + 0.5 * Vector3::UnitZ();
  Image image = view(all, bodies.grasp_and_arm(), direction, size, context);
  write_title(image, grasp.title);
  return image;
}

Image shared_grasp_picture(const std::array<const CompiledScene*, 2>& scenes,
                           const std::array<PosedGrasp, 2>& grasps, const Vector3& direction,
                           const PictureSize& size, const RunContext& context) {
  const GraspBodies first = grasp_bodies(*scenes[0], grasps[0]);
  const GraspBodies second = grasp_bodies(*scenes[1], grasps[1]);
  std::vector<DrawnBody> all = first.all();
  std::vector<DrawnBody> framed = first.grasp();
  for (const auto* bodies : {&second.hand, &second.contacts}) {
    all.insert(all.end(), bodies->begin(), bodies->end());
    framed.insert(framed.end(), bodies->begin(), bodies->end());
  }
  all.insert(all.end(), second.arm.begin(), second.arm.end());
  Image image = view(all, framed, direction, size, context);
  write_title(image, grasps[0].title);
  return image;
}

Image grasp_from_four_sides(const CompiledScene& scene, const PosedGrasp& grasp,
                            const PictureSize& size, const RunContext& context) {
  const GraspBodies bodies = grasp_bodies(scene, grasp);
  std::vector<Image> views;
  for (int side = 0; side < 4; ++side) {
    // Diagonally between the axes of the world, and from above by atan(0.55) = 29 degrees: along an
    // axis a box would show only one face.
    const double angle = (0.25 + 0.5 * side) * std::numbers::pi;
    views.push_back(view(bodies.all(), bodies.grasp(),
                         Vector3(std::cos(angle), std::sin(angle), 0.55),
                         {size.width / 2, size.height / 2}, context));
  }
  Image image = grid(views, 2);
  write_title(image, grasp.title);
  return image;
}

}  // namespace prehend

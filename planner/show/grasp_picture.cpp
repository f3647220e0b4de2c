#include "planner/show/grasp_picture.h"

#include <array>
#include <cmath>
#include <numbers>

#include "planner/picture/label.h"
#include "planner/picture/marks.h"
#include "planner/picture/palette.h"

namespace prehend {
namespace {

constexpr double kMarker = 0.01;  // m

// Sizes of marks as parts of the object's radius.
constexpr double kConeLength = 0.22;
constexpr double kArrowLength = 1.1;

void add_wrench(const CompiledScene& scene, const Wrench& wrench, std::vector<DrawnBody>& bodies) {
  if (wrench.isZero(0.0)) return;
  const double radius = 1.0 / scene.wrench_frame.torque_scale;
  const Pose& X_WO = scene.scene.object.X_WO;
  const Vector3& origin = scene.wrench_frame.torque_origin;
  const Vector3 force = wrench.head<3>() / wrench.norm() * kArrowLength * radius;
  const Vector3 torque = wrench.tail<3>() / wrench.norm() * kArrowLength * radius;
  bodies.push_back({arrow_mesh(origin, origin + force, 0.035 * radius), X_WO, palette::kWeakest,
                    "weakest force"});
  bodies.push_back({arrow_mesh(origin, origin + torque, 0.015 * radius), X_WO, palette::kWeakest,
                    "weakest torque"});
}

// `seen` fill the picture.
Image view(const std::vector<DrawnBody>& seen, const std::vector<DrawnBody>& around,
           const Vector3& direction, const GraspPictureOptions& options) {
  const DrawOptions draw_options{.width = options.width, .height = options.height};
  std::vector<DrawnBody> all = seen;
  all.insert(all.end(), around.begin(), around.end());
  return draw(all, camera_around(seen, direction, draw_options), draw_options);
}

// Links of the platform that are not the hand's.
std::vector<DrawnBody> arm_bodies(const CompiledScene& scene, const PosedGrasp& grasp) {
  std::vector<DrawnBody> bodies;
  if (grasp.arm_joints.empty()) return bodies;
  const CompiledArm& arm = *scene.arm;
  std::vector<Pose> X_BL;
  arm_link_poses(arm, grasp.arm_joints, X_BL);
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    if (arm.is_hand_link(link_id(l))) continue;
    const Link& link = arm.robot().links[l];
    bodies.push_back({link.mesh, arm.X_WB * X_BL[l], palette::kArm, link.name});
  }
  return bodies;
}

}  // namespace

std::vector<DrawnBody> grasp_bodies(const CompiledScene& scene, const PosedGrasp& grasp) {
  const Pose& X_WO = scene.scene.object.X_WO;
  const double radius = 1.0 / scene.wrench_frame.torque_scale;
  std::vector<DrawnBody> bodies;
  bodies.push_back({scene.scene.object.mesh, X_WO, palette::kObject, scene.scene.object.name});
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, grasp.joints, X_HL);
  for (std::size_t l = 0; l < scene.scene.hand.links.size(); ++l) {
    const Link& link = scene.scene.hand.links[l];
    const Color& color = link.material == "rubber" ? palette::kRubber : palette::kHard;
    bodies.push_back({link.mesh, X_WO * grasp.X_OH * X_HL[l], color, link.name});
  }
  for (const GraspContact& contact : grasp.contacts) {
    // A frictionless cone would not show.
    const double slope = std::max(0.05, contact.point.friction);
    const double length = kConeLength * radius / std::sqrt(1.0 + slope * slope);
    bodies.push_back({cone_mesh(contact.point.position, contact.point.normal, slope, length), X_WO,
                      palette::kContact, "contact"});
  }
  add_wrench(scene, grasp.weakest, bodies);
  return bodies;
}

std::vector<DrawnBody> surrounding_bodies(const CompiledScene& scene, const PosedGrasp& grasp) {
  std::vector<DrawnBody> bodies;
  for (const StaticBody& body : scene.scene.obstacles) {
    bodies.push_back({body.mesh, body.X_WB, palette::kObstacle, body.name});
  }
  for (const DrawnBody& link : arm_bodies(scene, grasp)) bodies.push_back(link);
  return bodies;
}

std::vector<DrawnBody> framed_bodies(const CompiledScene& scene, const PosedGrasp& grasp) {
  std::vector<DrawnBody> framed = grasp_bodies(scene, grasp);
  for (const DrawnBody& link : arm_bodies(scene, grasp)) {
    if (bounds(link.mesh).size().norm() > kMarker) framed.push_back(link);
  }
  return framed;
}

void write_title(Image& image, const std::string& title) {
  if (title.empty()) return;
  constexpr int kScale = 2;
  const TextSize size = text_size(title, kScale);
  label(image, 12, image.height - size.height - 12, title, palette::kText, kScale);
}

Image grasp_picture(const CompiledScene& scene, const PosedGrasp& grasp, const Vector3& direction,
                    const GraspPictureOptions& options) {
  Image image =
      view(grasp_bodies(scene, grasp), surrounding_bodies(scene, grasp), direction, options);
  write_title(image, grasp.title);
  return image;
}

Image arm_picture(const CompiledScene& scene, const PosedGrasp& grasp,
                  const GraspPictureOptions& options) {
  const std::vector<DrawnBody> seen = framed_bodies(scene, grasp);
  // From the side of the arm's way to the object.
  const Vector3 way = scene.scene.object.X_WO.translation() - scene.arm->X_WB.translation();
  Vector3 aside = Vector3::UnitZ().cross(way);
  if (!(aside.norm() > 1e-6)) aside = Vector3::UnitX();
  const Vector3 direction = aside.normalized() - 0.3 * way.normalized() + 0.5 * Vector3::UnitZ();
  PosedGrasp alone = grasp;
  alone.arm_joints.clear();
  Image image = view(seen, surrounding_bodies(scene, alone), direction, options);
  write_title(image, grasp.title);
  return image;
}

Image grasp_from_four_sides(const CompiledScene& scene, const PosedGrasp& grasp,
                            const GraspPictureOptions& options) {
  const std::vector<DrawnBody> bodies = grasp_bodies(scene, grasp);
  std::vector<Image> views;
  for (int side = 0; side < 4; ++side) {
    const double angle = (0.25 + 0.5 * side) * std::numbers::pi;
    views.push_back(view(bodies, surrounding_bodies(scene, grasp),
                         Vector3(std::cos(angle), std::sin(angle), 0.55),
                         {options.width / 2, options.height / 2}));
  }
  Image image = grid(views, 2);
  write_title(image, grasp.title);
  return image;
}

}  // namespace prehend

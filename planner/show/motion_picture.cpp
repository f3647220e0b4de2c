#include "planner/show/motion_picture.h"

#include <cstddef>
#include <utility>

#include "planner/picture/visible_pixels.h"
#include "planner/show/telling_side.h"

namespace prehend {
namespace {

// Of the pictures in which it is counted what is seen [pixels].
constexpr int kCountWidth = 240;
constexpr int kCountHeight = 192;

void append_points(const std::vector<DrawnBody>& bodies, std::vector<Vector3>& points) {
  for (const DrawnBody& body : bodies) {
    for (const Vector3& p_B : body.mesh.vertices) points.push_back(body.X_WB * p_B);
  }
}

// The part of the hand that is not hidden.
double hand_seen(const CompiledScene& scene, const PosedGrasp& grasp, const Camera& camera) {
  const std::vector<DrawnBody> bodies = grasp_bodies(scene, grasp);
  std::vector<DrawnBody> all(bodies.begin() + 1, bodies.end());
  const auto pixels = [&] {
    const std::vector<double> each = visible_pixels(all, camera, kCountWidth, kCountHeight);
    double sum = 0.0;
    for (std::size_t l = 0; l < scene.scene.hand.links.size(); ++l) sum += each[l];
    return sum;
  };
  const double alone = pixels();
  for (DrawnBody& body : surrounding_bodies(scene, grasp)) {
    body.color.opacity = 1.0;
    all.push_back(std::move(body));
  }
  return alone == 0.0 ? 0.0 : pixels() / alone;
}

Vector3 side_of_way(const CompiledScene& scene, const std::vector<MotionFrame>& frames,
                    const std::vector<Vector3>& points) {
  const Pose& X_WO = scene.scene.object.X_WO;
  const Vector3 way =
      X_WO.linear() * (frames.back().X_OH.translation() - frames.front().X_OH.translation());
  const std::vector<Vector3> directions = viewing_directions();
  Vector3 best = directions.front();
  double best_score = 0.0;
  for (const Vector3& direction : directions) {
    const Camera camera = camera_around(points, direction, kCountWidth, kCountHeight);
    double score = 0.0;
    for (const std::size_t f : {std::size_t{0}, frames.size() / 2, frames.size() - 1}) {
      score += hand_seen(scene, posed_at(frames[f]), camera);
    }
    if (way.norm() > 1e-9) score *= way.normalized().cross(direction).norm();
    if (score > best_score + 1e-9) {
      best = direction;
      best_score = score;
    }
  }
  return best;
}

}  // namespace

PosedGrasp posed_at(const MotionFrame& frame) {
  return {frame.X_OH, frame.joints, {}, Wrench::Zero(), "", frame.arm_joints};
}

MotionView motion_view(const CompiledScene& scene, const std::vector<MotionFrame>& frames,
                       const PosedGrasp& grasp, const GraspPictureOptions& options) {
  MotionView view;
  view.with_arm = !frames.back().arm_joints.empty();
  std::vector<Vector3> whole;
  std::vector<Vector3> close;
  for (const MotionFrame& frame : frames) {
    PosedGrasp moment = posed_at(frame);
    if (view.with_arm) append_points(framed_bodies(scene, moment), whole);
    // The hand comes into the close picture; all that it does there is in it.
    if (view.with_arm) moment.X_OH = grasp.X_OH;
    append_points(grasp_bodies(scene, moment), close);
  }
  view.close = camera_around(close, telling_side(scene, grasp), options.width, options.height);
  if (!view.with_arm) return view;
  view.whole =
      camera_around(whole, side_of_way(scene, frames, whole), options.width, options.height);
  return view;
}

Image motion_picture(const CompiledScene& scene, const PosedGrasp& moment, const MotionView& view,
                     const GraspPictureOptions& options) {
  std::vector<DrawnBody> bodies = grasp_bodies(scene, moment);
  const std::vector<DrawnBody> around = surrounding_bodies(scene, moment);
  bodies.insert(bodies.end(), around.begin(), around.end());
  const DrawOptions draw_options{.width = options.width, .height = options.height};
  std::vector<Image> pictures;
  if (view.with_arm) pictures.push_back(draw(bodies, view.whole, draw_options));
  pictures.push_back(draw(bodies, view.close, draw_options));
  Image image = grid(pictures, 2);
  write_title(image, moment.title);
  return image;
}

}  // namespace prehend

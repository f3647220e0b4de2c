#include "planner/show/motion_picture.h"

#include <cstddef>
#include <numeric>

#include "planner/show/best_viewpoint.h"
#include "planner/show/grasp_bodies.h"
#include "planner/show/picture/draw.h"
#include "planner/show/picture/visible_pixels.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

// Size of the pictures in which visible pixels are counted; they are not shown.
constexpr int kCountWidth = 240;
constexpr int kCountHeight = 192;

void append_points(const std::vector<DrawnBody>& bodies, std::vector<Vector3>& points) {
  for (const DrawnBody& body : bodies) {
    for (const Vector3& p_B : body.mesh->vertices) points.push_back(body.X_WB * p_B);
  }
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// The part of the hand (0 to 1) that obstacles and the arm leave to be seen: its visible pixels
// over those that it has with nothing around it.
double hand_seen(const GraspBodies& bodies, const Camera& camera) {
  VisiblePixels picture(camera, kCountWidth, kCountHeight);
  for (const DrawnBody& link : bodies.hand) picture.add(link);
  const double alone = sum(picture.counts());
  // Outside the picture or too small to be seen.
  if (alone == 0.0) return 0.0;
  for (DrawnBody& body : bodies.surroundings()) {
    body.color.opacity = 1.0;  // little is seen through an obstacle
    picture.add(body);
  }
  std::vector<double> pixels = picture.counts();
  pixels.resize(bodies.hand.size());
  return sum(pixels) / alone;
}

// The viewing direction for a motion: the hand is visible at the start, half way and at the end,
// and its way is seen from the side. The score is the visible part of the hand, summed over these
// moments, times the sine of the angle between way and viewing direction. Seen along its way, the
// hand would not appear to move. `points` are what the picture frames.
Vector3 side_of_way(const CompiledScene& scene, const std::vector<MotionFrame>& frames,
                    const std::vector<Vector3>& points, const RunContext& context) {
  const Pose& X_WO = scene.scene.object.X_WO;
  const Vector3 way =
      X_WO.linear() * (frames.back().X_OH.translation() - frames.front().X_OH.translation());
  std::vector<GraspBodies> moments;
  for (const std::size_t f : {std::size_t{0}, frames.size() / 2, frames.size() - 1}) {
    moments.push_back(grasp_bodies(scene, posed_at(frames[f])));
  }
  const std::vector<Vector3> directions = viewing_directions();
  Vector3 best = directions.front();
  double best_score = 0.0;
  for (const Vector3& direction : directions) {
    context.cancellation.check();
    const Camera camera = camera_around(points, direction, kCountWidth, kCountHeight);
    double score = 0.0;
    for (const GraspBodies& moment : moments) score += hand_seen(moment, camera);
    // A hand that does not move (1e-9 m is rounding) has no way to be seen from the side.
    if (way.norm() > 1e-9) score *= way.normalized().cross(direction).norm();
    // Scores that differ by rounding count as equal, and the first direction is kept.
    if (score > best_score + 1e-9) {
      best = direction;
      best_score = score;
    }
  }
  return best;
}

}  // namespace

MotionView motion_view(const CompiledScene& scene, const std::vector<MotionFrame>& frames,
                       const PosedGrasp& grasp, const PictureSize& size,
                       const RunContext& context) {
  MotionView view;
  view.with_arm = !frames.back().arm_joints.empty();
  std::vector<Vector3> whole;
  std::vector<Vector3> close;
  for (const MotionFrame& frame : frames) {
    context.cancellation.check();
    PosedGrasp moment = posed_at(frame);
    if (view.with_arm) append_points(grasp_bodies(scene, moment).grasp_and_arm(), whole);
    // With an arm the close picture frames the hand at the grasp, in all its joint positions along
    // the motion, and not on its way there. The way of an arm is long: a picture of it would show
    // the fingers too small. The other picture shows it.
    if (view.with_arm) {
      moment.X_OH = grasp.X_OH;
      moment.X_OC = grasp.X_OC;
    }
    append_points(grasp_bodies(scene, moment).grasp(), close);
  }
  view.close = camera_around(close, best_viewpoint(scene, grasp, context), size.width, size.height);
  if (!view.with_arm) return view;
  view.whole =
      camera_around(whole, side_of_way(scene, frames, whole, context), size.width, size.height);
  return view;
}

Image motion_picture(const CompiledScene& scene, const PosedGrasp& moment, const MotionView& view,
                     const PictureSize& size, const RunContext& context) {
  const std::vector<DrawnBody> bodies = grasp_bodies(scene, moment).all();
  const DrawOptions draw_options{.width = size.width, .height = size.height};
  std::vector<Image> pictures;
  if (view.with_arm) pictures.push_back(draw(bodies, view.whole, draw_options, context));
  pictures.push_back(draw(bodies, view.close, draw_options, context));
  Image image = grid(pictures, 2);
  write_title(image, moment.title);
  return image;
}

}  // namespace prehend

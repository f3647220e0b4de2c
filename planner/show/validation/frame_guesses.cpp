#include "planner/show/validation/frame_guesses.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "planner/show/validation/open_hand.h"
#include "sim/base/formatted.h"

namespace prehend {
namespace {

constexpr const char* kOtherAxes = "does their frame have other axes?";

// Applied from the right: to the hand.
FrameGuess hand_guess(std::string words, std::string question, const Pose& X_GH) {
  return {std::move(words), std::move(question),
          [X_GH](const Pose& X_OG, const CompiledScene&) { return Pose(X_OG * X_GH); }};
}

std::string moved_text(double distance) {
  return formatted("with the hand %.0f mm farther %s along its approach axis",
                   1e3 * std::abs(distance), distance < 0.0 ? "back" : "forward");
}

void add_moves(const Hand& hand, double tool, std::vector<FrameGuess>& guesses) {
  const double palm = hand.origin.dot(hand.approach);
  const std::array<std::pair<double, const char*>, 4> own = {
      {{-tool, "are the poses those of the point between the fingertips?"},
       {tool, "is the hand's base nearer to the fingertips in the robot's file?"},
       {-palm, "are the poses those of the palm?"},
       {palm, "is the hand's base at the palm in the robot's file?"}}};
  for (const auto& [distance, question] : own) {
    if (distance == 0.0) continue;
    guesses.push_back(
        hand_guess(moved_text(distance), question, translation(distance * hand.approach)));
  }
}

void add_turns(const Hand& hand, double tool, std::vector<FrameGuess>& guesses) {
  for (const double degrees : {90.0, 45.0, -45.0, 180.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Pose turned(Eigen::AngleAxisd(angle, hand.approach));
    const std::string words =
        formatted("with the hand turned by %.0f degrees about its approach axis", degrees);
    guesses.push_back(hand_guess(words, "do the fingers close along another axis there?", turned));
    guesses.push_back(hand_guess(words + formatted(" and %.0f mm farther back", 1e3 * tool),
                                 "are the poses those of a frame between the fingertips?",
                                 turned * translation(-tool * hand.approach)));
  }
}

void add_units(std::vector<FrameGuess>& guesses) {
  constexpr std::array<std::pair<double, const char*>, 4> kUnits = {
      {{1e-3, "are they in millimetres?"},
       {1e3, "were they divided by 1,000 once too often?"},
       {1e-2, "are they in centimetres?"},
       {100.0, "were they divided by 100 once too often?"}}};
  for (const auto& [factor, question] : kUnits) {
    guesses.push_back({formatted("with all positions times %g", factor), question,
                       [factor = factor](const Pose& X_OH, const CompiledScene&) {
                         return pose_from(X_OH.linear(), factor * X_OH.translation());
                       }});
  }
}

Vector3 mean_vertex(const TriangleMesh& mesh) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& vertex : mesh.vertices) sum += vertex;
  return sum / static_cast<double>(mesh.vertices.size());
}

Vector3 box_middle(const TriangleMesh& mesh) { return bounds(mesh).center(); }

Vector3 box_floor(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  return {box.center().x(), box.center().y(), box.lower.z()};
}

void add_origins(std::vector<FrameGuess>& guesses) {
  const auto add = [&](const std::string& where, const auto& place) {
    guesses.push_back({"with the poses relative to " + where,
                       "is the object's origin another one there?",
                       [place](const Pose& X_CH, const CompiledScene& scene) {
                         return Pose(translation(place(scene.scene.object)) * X_CH);
                       }});
  };
  add("the object's centre of mass", [](const GraspableBody& o) { return o.center_of_mass; });
  add("the middle of the object's box", [](const GraspableBody& o) { return box_middle(o.mesh); });
  add("the mean of the object's vertices",
      [](const GraspableBody& o) { return mean_vertex(o.mesh); });
  add("the middle of the floor of the object's box",
      [](const GraspableBody& o) { return box_floor(o.mesh); });
}

void add_inverse(const Hand& hand, double tool, std::vector<FrameGuess>& guesses) {
  guesses.push_back({"with inverse poses", "are they those of the object in the frame of the hand?",
                     [](const Pose& X_HO, const CompiledScene&) { return Pose(X_HO.inverse()); }});
  const Pose back = translation(-tool * hand.approach);
  guesses.push_back(
      {formatted("with inverse poses and the hand %.0f mm farther back", 1e3 * tool),
       "are they those of the object in a frame between the fingertips?",
       [back](const Pose& X_TO, const CompiledScene&) { return Pose(X_TO.inverse() * back); }});
}

void add_steps(const Hand& hand, std::vector<FrameGuess>& guesses) {
  for (int step = 1; step <= 25; ++step) {
    for (const double way : {-1.0, 1.0}) {
      const double distance = 0.01 * way * step;
      guesses.push_back(hand_guess(moved_text(distance),
                                   "are the poses those of another frame of the hand?",
                                   translation(distance * hand.approach)));
      guesses.back().is_step = true;
    }
  }
}

// The rotations that turn axes into axes, but for the identity.
std::vector<Matrix3> axis_rotations() {
  std::vector<Matrix3> rotations;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      if (a == b) continue;
      for (const double sign_a : {1.0, -1.0}) {
        for (const double sign_b : {1.0, -1.0}) {
          Matrix3 rotation;
          rotation.col(0) = sign_a * Vector3::Unit(a);
          rotation.col(1) = sign_b * Vector3::Unit(b);
          rotation.col(2) = rotation.col(0).cross(rotation.col(1));
          if (!rotation.isIdentity()) rotations.push_back(rotation);
        }
      }
    }
  }
  return rotations;
}

// "y, z, x": where the columns of an axis rotation point.
std::string axis_text(const Matrix3& rotation) {
  std::string words;
  for (const auto& column : rotation.colwise()) {
    Eigen::Index axis = 0;
    column.cwiseAbs().maxCoeff(&axis);
    words += words.empty() ? "" : ", ";
    words += column[axis] < 0.0 ? "-" : "";
    words += "xyz"[axis];
  }
  return words;
}

void add_axes(const Hand& hand, double tool, std::vector<FrameGuess>& guesses) {
  for (const Matrix3& R : axis_rotations()) {
    const Pose turned = pose_from(R, Vector3::Zero());
    const std::string axes = axis_text(R);
    const std::string words = "with the hand's axes x, y, z along " + axes + " of the poses";
    guesses.push_back(hand_guess(words, kOtherAxes, turned));
    guesses.push_back(hand_guess(words + formatted(" and %.0f mm farther back", 1e3 * tool),
                                 kOtherAxes, turned * translation(-tool * hand.approach)));
    guesses.push_back(
        {"with the poses' axes x, y, z along " + axes + " of the object",
         "is the object turned there?",
         [turned](const Pose& X_CH, const CompiledScene&) { return Pose(turned * X_CH); }});
  }
}

}  // namespace

std::vector<FrameGuess> frame_guesses(const Hand& hand) {
  const double tool = tool_reach(hand, widest_preshape(hand));
  std::vector<FrameGuess> guesses;
  add_moves(hand, tool, guesses);
  add_turns(hand, tool, guesses);
  add_units(guesses);
  add_origins(guesses);
  add_inverse(hand, tool, guesses);
  add_steps(hand, guesses);
  add_axes(hand, tool, guesses);
  return guesses;
}

}  // namespace prehend

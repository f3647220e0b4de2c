#include "sim/robot/hand/test_closing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/index.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/wrench.h"
#include "sim/robot/joint_course.h"
#include "sim/robot/one_finger.h"
#include "sim/shape/contact/contact_region.h"

namespace prehend {
namespace {

constexpr double kFriction = 0.5;
constexpr double kTouching =
    8e-5;  // where a closing link stops: less than what counts as contact [m]
constexpr double kGapError = 0.1;  // of the distances on the way
constexpr double kFar = 0.5;       // of a body's radius: that far its ball will do
constexpr int kMostSteps = 2000;

// A bound of the distance of the link's points from the origin of a joint before it: along the
// joints between them, whatever their values.
double arm_of(const Robot& robot, int joint, int link) {
  double arm = 0.0;
  for (const Vector3& p : robot.links[index(link)].mesh.vertices) arm = std::max(arm, p.norm());
  for (int j = robot.links[index(link)].joint; j != joint; j = robot.joints[index(j)].parent) {
    const Joint& passed = robot.joints[index(j)];
    arm += passed.X_JA.translation().norm() + passed.X_PJ.translation().norm();
    if (passed.type == JointType::prismatic) {
      arm += std::max(std::abs(passed.lower + passed.zero), std::abs(passed.upper + passed.zero));
    }
  }
  return arm + robot.joints[index(joint)].X_JA.translation().norm();
}

constexpr int kPalm = -1;
constexpr int kLever = -2;

// The finger that each link belongs to. Levers of a finger that closes by a linkage do what its
// joints do in fact, which a tree of joints cannot say once some have stopped.
std::vector<int> owners(const Robot& robot, const HandParts& parts) {
  std::vector<int> owner(robot.links.size(), kLever);
  for (const int link : parts.palm_links) owner[index(link)] = kPalm;
  for (std::size_t f = 0; f < parts.fingers.size(); ++f) {
    for (const int link : parts.fingers[f].links) owner[index(link)] = static_cast<int>(f);
  }
  return owner;
}

// How far surfaces may come closer that do not touch yet.
double step_from(const Gap& gap) { return std::max(gap.lower - 0.5 * kTouching, 0.25 * kTouching); }

// A lower bound of the distance, from the balls about them.
double balls_apart(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB) {
  return (X_AB * b.ball_center() - a.ball_center()).norm() - a.ball_radius() - b.ball_radius();
}

}  // namespace

TestClosing::TestClosing(const Robot& robot, const HandParts& parts, const ClosingDofs& closing,
                         const SelfCollision& collision)
    : robot_(robot), closing_(closing), collision_(collision) {
  for (int l = 0; l < static_cast<int>(robot.links.size()); ++l) {
    Reaching reaching{.link = l, .joints = {}, .arms = {}};
    for (const int joint : joints_to(robot, robot.links[index(l)].joint)) {
      const Joint& j = robot.joints[index(joint)];
      if (!closing.closes(index(j.dof))) continue;
      reaching.joints.push_back(joint);
      reaching.arms.push_back(j.type == JointType::prismatic ? 1.0 : arm_of(robot, joint, l));
    }
    if (!reaching.joints.empty()) reaching_.push_back(std::move(reaching));
  }
  const std::vector<int> owner = owners(robot, parts);
  for (const auto& pair : collision.pairs()) {
    const int a = owner[index(pair.first)];
    const int b = owner[index(pair.second)];
    if (a != kLever && b != kLever && a != b) apart_.push_back({pair.first, pair.second, a, b});
  }
}

double TestClosing::reach(const Vector3& origin, const Vector3& approach,
                          const std::vector<double>& dofs) const {
  std::vector<Pose> X_BL;
  link_poses(robot_, joint_values(robot_, dofs), X_BL);
  double reach = 0.0;
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    const Vector3 along = X_BL[l].linear().transpose() * approach;
    const double from = approach.dot(X_BL[l].translation() - origin);
    for (const Vector3& p : robot_.links[l].mesh.vertices) {
      reach = std::max(reach, from + along.dot(p));
    }
  }
  return reach;
}

double TestClosing::way_in(const ProximityMesh& body, const Pose& X_BS, const Vector3& approach,
                           double most, const std::vector<double>& dofs) const {
  std::vector<Pose> X_BL;
  link_poses(robot_, joint_values(robot_, dofs), X_BL);
  double way = most;
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    const ProximityMesh& link = collision_.mesh(static_cast<int>(l));
    double moved = 0.0;
    for (int step = 0; step < kMostSteps && moved < way; ++step) {
      const Pose X_BS_now = translation(-moved * approach) * X_BS;
      const Gap gap = find_gap(
          link, body, X_BL[l].inverse() * X_BS_now,
          {.cap = 2.0 * (way - moved) + kTouching, .relative_error = kGapError, .hint = {}});
      if (gap.upper <= kTouching) break;
      moved += step_from(gap);
    }
    if (moved == 0.0) return -1.0;
    way = std::min(way, moved);
  }
  return way;
}

Pose TestClosing::pushed(const ProximityMesh& body, const Pose& X_BS, const Vector3& approach,
                         double most, const std::vector<double>& dofs) const {
  const auto push =
      pushing_direction(robot_, joint_values(robot_, dofs), closing_.velocity, approach);
  if (!push) return X_BS;
  const Pose X_BS_free = translation(kSlidingRoom * approach) * X_BS;
  const double way = way_in(body, X_BS_free, -*push, most, dofs);
  return way > 0.0 && way < most ? translation(way * *push) * X_BS_free : X_BS;
}

bool TestClosing::crossing(const std::vector<Pose>& X_BL, std::size_t thumb) const {
  const int of_thumb = static_cast<int>(thumb);
  return std::any_of(apart_.begin(), apart_.end(), [&](const Apart& pair) {
    const bool palm = pair.owner_a == kPalm || pair.owner_b == kPalm;
    if (!palm && pair.owner_a != of_thumb && pair.owner_b != of_thumb) return false;
    const Pose X_AB = X_BL[index(pair.a)].inverse() * X_BL[index(pair.b)];
    return surfaces_cross(collision_.mesh(pair.a), collision_.mesh(pair.b), X_AB);
  });
}

double TestClosing::score(const ProximityMesh& body, const Pose& X_BS,
                          const std::vector<Pose>& X_BL) const {
  RegionWorkspace workspace;
  std::vector<SurfaceContact> touching;
  std::vector<Contact> contacts;
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    const ProximityMesh& link = collision_.mesh(static_cast<int>(l));
    find_contacts(body, link, X_BS.inverse() * X_BL[l], {}, workspace, touching);
    for (const SurfaceContact& c : touching) contacts.push_back({c.position, c.normal, kFriction});
  }
  if (contacts.size() < 2) return 0.0;
  const WrenchFrame frame{.torque_origin = Vector3::Zero(),
                          .torque_scale = 1.0 / body.ball_radius()};
  return epsilon_l1(contact_wrenches(contacts, frame), {.relative_tolerance = 0.01}).lower;
}

double TestClosing::hold(const ProximityMesh& body, const Pose& X_BS,
                         const std::vector<double>& dofs, std::size_t thumb) const {
  std::vector<DofCourse> courses(robot_.dofs.size());
  for (std::size_t d = 0; d < courses.size(); ++d) {
    if (closing_.closes(d)) courses[d] = {closing_.velocity[d], closed_value(robot_, closing_, d)};
  }
  JointCourse course;
  course.start(robot_, dofs, courses);
  const double end = course.end();
  std::vector<double> joints(robot_.joints.size());
  std::vector<Pose> X_BL;
  const auto place_links = [&](double time) {
    for (std::size_t j = 0; j < joints.size(); ++j) joints[j] = course.value(int(j), time);
    link_poses(robot_, joints, X_BL);
  };
  // When each link has to be looked at again: before that it cannot touch.
  std::vector<double> safe(reaching_.size(), 0.0);
  std::vector<TrianglePair> nearest(reaching_.size());
  for (int step = 0; step < kMostSteps && !safe.empty(); ++step) {
    const auto next = std::min_element(safe.begin(), safe.end());
    const double time = *next;
    if (time >= end) break;
    const Reaching& reaching = reaching_[static_cast<std::size_t>(next - safe.begin())];
    double speed = 0.0;
    for (std::size_t k = 0; k < reaching.joints.size(); ++k) {
      speed += course.speed(reaching.joints[k], time) * reaching.arms[k];
    }
    *next = end;
    if (speed <= 0.0) continue;
    place_links(time);
    const Pose X_LS = X_BL[index(reaching.link)].inverse() * X_BS;
    const ProximityMesh& link = collision_.mesh(reaching.link);
    const double apart = balls_apart(link, body, X_LS);
    if (apart > kFar * body.ball_radius()) {
      *next = time + apart / speed;
      continue;
    }
    TrianglePair& hint = nearest[static_cast<std::size_t>(next - safe.begin())];
    const Gap gap = find_gap(link, body, X_LS, {.relative_error = kGapError, .hint = hint});
    hint = gap.pair;
    if (gap.upper <= kTouching) {
      if (time == 0.0 && gap.upper <= 0.0) return 0.0;
      course.stop_before(reaching.joints, time);
    } else {
      *next = time + step_from(gap) / speed;
    }
  }
  place_links(end);
  const double epsilon = score(body, X_BS, X_BL);
  return epsilon > 0.0 && crossing(X_BL, thumb) ? 0.0 : epsilon;
}

}  // namespace prehend

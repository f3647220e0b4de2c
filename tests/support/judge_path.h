// What is promised of the path of a grasp, looked at with second_opinion.h and its own
// interpolation.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/plan_result.h"
#include "tests/support/second_opinion.h"

namespace prehend::test {

struct Judgement {
  std::vector<std::string> faults;  // in words
  int postures = 0;                 // that were looked at for collisions
  int collisions = 0;
};

class PathJudge {
 public:
  PathJudge(const Scene& scene, const Machine& machine, const Surroundings& around,
            const ScoredGrasp& grasp)
      : scene_(scene), machine_(machine), around_(around), grasp_(grasp), path_(*grasp.path) {
    for (const TrajectorySegment& segment : path_.segments) {
      if (segment.name == "close") grasped_ = static_cast<std::size_t>(segment.last);
    }
  }

  Judgement judge() {
    check_shape();
    if (!judgement_.faults.empty()) return judgement_;
    check_ends();
    check_limits();
    check_segments();
    check_approach();
    check_lift();
    if (grasped_ + 1 < path_.times.size()) take_object();
    for (std::size_t i = 0; i + 1 < path_.times.size(); ++i) walk(i);
    return judgement_;
  }

 private:
  static constexpr double kStep = 2e-3;   // most that a vertex moves between two looks [m]
  static constexpr double kSlack = 1e-6;  // of limits, relative

  void fault(const std::string& what, std::size_t sample) {
    if (judgement_.faults.size() < 5) {
      judgement_.faults.push_back(what + " at sample " + std::to_string(sample));
    }
  }

  Posture posture(const std::vector<double>& values) const {
    Posture posture;
    for (std::size_t j = 0; j < values.size(); ++j) posture[path_.joints[j]] = values[j];
    return posture;
  }

  // Hermite's cubic between sample i and the next, from its basis functions.
  std::vector<double> between(std::size_t i, double s) const {
    const double h = path_.times[i + 1] - path_.times[i];
    std::vector<double> q(path_.joints.size());
    for (std::size_t j = 0; j < q.size(); ++j) {
      const double p0 = path_.positions[i][j];
      const double p1 = path_.positions[i + 1][j];
      const double m0 = h * path_.velocities[i][j];
      const double m1 = h * path_.velocities[i + 1][j];
      q[j] =
          p0 + s * (m0 + s * (3.0 * (p1 - p0) - 2.0 * m0 - m1 + s * (2.0 * (p0 - p1) + m0 + m1)));
    }
    return q;
  }

  void check_shape() {
    const std::size_t count = path_.times.size();
    if (count < 2 || path_.positions.size() != count || path_.velocities.size() != count) {
      return fault("samples of unequal number", count);
    }
    std::size_t joints = 0;
    for (const MountedRobot& mounted : scene_.carrier->platform.robots) {
      for (const Joint& joint : mounted.robot.joints) {
        const std::string name = mounted.name + "/" + joint.name;
        if (joints >= path_.joints.size() || path_.joints[joints] != name) {
          return fault("no joint " + name, 0);
        }
        ++joints;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (path_.positions[i].size() != joints || path_.velocities[i].size() != joints) {
        return fault("a row of the wrong length", i);
      }
      if (i > 0 && !(path_.times[i] > path_.times[i - 1])) fault("time stands still", i);
    }
  }

  Matrix4 wanted_hand() const { return (scene_.object.X_WO * grasp_.trial.X_OH).matrix(); }

  void check_ends() {
    if (path_.times.front() != 0.0) fault("time does not start at 0", 0);
    const std::size_t last = path_.times.size() - 1;
    std::size_t j = 0;
    std::size_t first_dof = 0;
    for (std::size_t r = 0; r < scene_.carrier->platform.robots.size(); ++r) {
      const Robot& robot = scene_.carrier->platform.robots[r].robot;
      const bool is_hand = static_cast<int>(r) == scene_.carrier->hand;
      for (std::size_t k = 0; k < robot.joints.size(); ++k, ++j) {
        const Joint& joint = robot.joints[k];
        const std::size_t dof = first_dof + static_cast<std::size_t>(joint.dof);
        const double start = joint.ratio * scene_.carrier->start[dof] + joint.offset;
        if (std::abs(path_.positions[0][j] - start) > 1e-9) fault("not at the start", 0);
        if (path_.velocities[0][j] != 0.0) fault("moves at the start", 0);
        if (path_.velocities[last][j] != 0.0) fault("moves at the end", last);
        for (std::size_t i = grasped_; is_hand && i <= last; ++i) {
          if (std::abs(path_.positions[i][j] - grasp_.trial.joints[k]) > 1e-9) {
            fault("the hand is not closed", i);
          }
        }
      }
      first_dof += robot.dofs.size();
    }
    const Matrix4 hand = machine_.hand_base(machine_.frames(posture(path_.positions[grasped_])));
    if ((hand - wanted_hand()).cwiseAbs().maxCoeff() > 1e-6) {
      fault("the hand is elsewhere", grasped_);
    }
  }

  void check_limits() {
    std::size_t j = 0;
    for (const MountedRobot& mounted : scene_.carrier->platform.robots) {
      for (const Joint& joint : mounted.robot.joints) {
        check_joint(joint, mounted.robot.dofs[static_cast<std::size_t>(joint.dof)], j++);
      }
    }
  }

  void check_joint(const Joint& joint, const DegreeOfFreedom& dof, std::size_t j) {
    const double fastest = std::abs(joint.ratio) * dof.max_velocity * (1.0 + kSlack);
    const double hardest = std::abs(joint.ratio) * dof.max_acceleration * (1.0 + kSlack);
    for (std::size_t i = 0; i < path_.times.size(); ++i) {
      const double value = path_.positions[i][j];
      const double of_dof = (value - joint.offset) / joint.ratio;
      const bool outside = value < joint.lower - kSlack || value > joint.upper + kSlack;
      if (outside || of_dof < dof.lower - kSlack || of_dof > dof.upper + kSlack) {
        fault(joint.name + " outside its limits", i);
      }
      if (i > 0) check_cubic(joint.name, i, j, fastest, hardest);
    }
  }

  // Velocity and acceleration at many places of the cubic that ends at sample i, from the same
  // polynomial as in `between`.
  void check_cubic(const std::string& name, std::size_t i, std::size_t j, double fastest,
                   double hardest) {
    const double h = path_.times[i] - path_.times[i - 1];
    const double p0 = path_.positions[i - 1][j];
    const double p1 = path_.positions[i][j];
    const double m0 = h * path_.velocities[i - 1][j];
    const double m1 = h * path_.velocities[i][j];
    // Rounding of positions, which a short time makes much of.
    const double noise = 1e-15 * (std::abs(p0) + std::abs(p1)) / h;
    for (int k = 0; k <= 10; ++k) {
      const double s = k / 10.0;
      const double second = 3.0 * (p1 - p0) - 2.0 * m0 - m1;
      const double third = 2.0 * (p0 - p1) + m0 + m1;
      const double velocity = (m0 + s * (2.0 * second + s * 3.0 * third)) / h;
      const double acceleration = (2.0 * second + s * 6.0 * third) / (h * h);
      if (std::abs(velocity) > fastest + noise) return fault(name + " too fast", i);
      if (std::abs(acceleration) > hardest + 6.0 * noise / h) {
        return fault(name + " accelerates too hard", i);
      }
    }
  }

  void check_segments() {
    std::string names;
    int at = 0;
    for (const TrajectorySegment& segment : path_.segments) {
      if (segment.first != at || segment.last < segment.first) {
        fault("segment " + segment.name + " does not follow", static_cast<std::size_t>(at));
      }
      at = segment.last;
      names += segment.name + " ";
    }
    const std::size_t last = path_.times.size() - 1;
    if (at != static_cast<int>(last)) fault("segments end early", static_cast<std::size_t>(at));
    for (const std::string after : {"retreat ", "lift "}) {
      if (names.ends_with(after)) names.erase(names.size() - after.size());
    }
    if (names != "transfer approach close " && names != "preshape transfer approach close " &&
        names != "transfer preshape approach close ") {
      fault("segments " + names, 0);
    }
  }

  // Straight up, turned as at the grasp, also between samples.
  void check_lift() {
    const auto segment = std::find_if(path_.segments.begin(), path_.segments.end(),
                                      [](const auto& s) { return s.name == "lift"; });
    if (segment == path_.segments.end()) return;
    const Matrix4 start = wanted_hand();
    double height = -1e-9;
    for (auto i = static_cast<std::size_t>(segment->first);
         i < static_cast<std::size_t>(segment->last); ++i) {
      for (const double s : {0.0, 0.5}) {
        const Matrix4 hand = machine_.hand_base(machine_.frames(posture(between(i, s))));
        const Vector3 way = (hand - start).topRightCorner<3, 1>();
        if (way.head<2>().norm() > 1e-5) fault("the lift is not straight", i);
        if ((hand - start).topLeftCorner<3, 3>().cwiseAbs().maxCoeff() > 1e-4) {
          fault("the hand turns", i);
        }
        if (way.z() < height - 1e-9) fault("the lift goes back", i);
        height = way.z();
      }
    }
    if (height < 0.05) fault("hardly a lift", static_cast<std::size_t>(segment->last));
  }

  // From the grasp on, the object is a body in the frame of the hand.
  void take_object() {
    const Matrix4 X_HO = grasp_.trial.X_OH.matrix().inverse();
    object_.name = scene_.object.name;
    object_.triangles = soup(scene_.object.mesh, Pose(X_HO));
    object_.box = box_of(object_.triangles);
    for (const Surroundings::Thing& thing : around_.things) {
      if (thing.name != object_.name) without_object_.things.push_back(thing);
    }
  }

  // What the carried object meets, "" for nothing: obstacles, and links of robots other than the
  // hand that are not on the frame that the hand is on.
  std::string what_object_meets(const Frames& frames) const {
    const Matrix4 X = machine_.hand_base(frames);
    const Bounds box = moved(X, object_.box);
    for (const Surroundings::Thing& thing : without_object_.things) {
      std::vector<Corners> near;
      for (std::size_t t = 0; t < thing.triangles.size(); ++t) {
        if (boxes_meet(thing.boxes[t], box)) near.push_back(thing.triangles[t]);
      }
      if (near.empty()) continue;
      if (surfaces_meet(triangles_in(object_, X, box_of(near)), near)) {
        return object_.name + " meets " + thing.name;
      }
    }
    const MountedRobot& hand =
        scene_.carrier->platform.robots[static_cast<std::size_t>(scene_.carrier->hand)];
    const std::string carrier = machine_.carried_by(hand);
    for (const Body& body : machine_.bodies()) {
      if (body.name.starts_with(hand.name + "/") || body.frame == carrier) continue;
      const Matrix4& X_WB = frames.at(body.frame);
      const Bounds other = moved(X_WB, body.box);
      if (!boxes_meet(box, other)) continue;
      if (surfaces_meet(triangles_in(object_, X, other), triangles_in(body, X_WB, box))) {
        return object_.name + " meets " + body.name;
      }
    }
    return "";
  }

  // Along the scene's approach, turned as at the grasp, also between samples; nothing of the hand
  // moves.
  void check_approach() {
    const auto segment = std::find_if(path_.segments.begin(), path_.segments.end(),
                                      [](const auto& s) { return s.name == "approach"; });
    if (segment == path_.segments.end()) return fault("no approach", 0);
    const Matrix4 end = wanted_hand();
    const Vector3 along = scene_.object.X_WO.linear() * grasp_.candidate.approach_O;
    double before = grasp_.trial.travel + 1e-6;
    for (int i = segment->first; i <= segment->last; ++i) {
      for (const double s : {0.0, 0.5}) {
        if (i == segment->last && s > 0.0) continue;
        const auto sample = static_cast<std::size_t>(i);
        const auto q = s > 0.0 ? between(sample, s) : path_.positions[sample];
        const Matrix4 hand = machine_.hand_base(machine_.frames(posture(q)));
        const Vector3 behind = (end - hand).topRightCorner<3, 1>();
        const double left = behind.dot(along);
        if ((behind - left * along).norm() > 1e-5) fault("the approach is not straight", sample);
        if ((end - hand).topLeftCorner<3, 3>().cwiseAbs().maxCoeff() > 1e-4) {
          fault("the hand turns", sample);
        }
        if (left > before + 1e-9) fault("the approach goes back", sample);
        before = left;
      }
    }
    if (std::abs(before) > 1e-6) fault("the approach ends early", 0);
  }

  // Most that a corner of a body's box, and with it any vertex, moves from one to the other.
  double motion(const Frames& a, const Frames& b) const {
    double most = 0.0;
    for (const Body& body : machine_.bodies()) {
      const Matrix4& X_A = a.at(body.frame);
      const Matrix4& X_B = b.at(body.frame);
      for (int c = 0; c < 8; ++c) {
        const Vector3 p((c & 1) != 0 ? body.box.upper.x() : body.box.lower.x(),
                        (c & 2) != 0 ? body.box.upper.y() : body.box.lower.y(),
                        (c & 4) != 0 ? body.box.upper.z() : body.box.lower.z());
        most = std::max(most, (moved(X_A, p) - moved(X_B, p)).norm());
      }
    }
    return most;
  }

  // Looks from sample i to the next, in more steps until each is short enough.
  void walk(std::size_t i) {
    for (int steps = 1;; steps *= 2) {
      std::vector<Frames> along;
      double longest = 0.0;
      for (int k = 0; k <= steps; ++k) {
        along.push_back(machine_.frames(posture(between(i, static_cast<double>(k) / steps))));
        if (k > 0) longest = std::max(longest, motion(along[along.size() - 2], along.back()));
        if (longest > kStep) break;
      }
      if (longest > kStep) continue;
      const bool is_last = i + 2 == path_.times.size();
      for (std::size_t k = 0; k < along.size() - (is_last ? 0 : 1); ++k) look(along[k], i);
      return;
    }
  }

  void look(const Frames& frames, std::size_t sample) {
    ++judgement_.postures;
    const bool carries = sample >= grasped_ && !object_.triangles.empty();
    std::string met = what_meets(machine_, carries ? without_object_ : around_, frames);
    if (carries && met.empty()) met = what_object_meets(frames);
    if (met.empty()) return;
    ++judgement_.collisions;
    fault(met, sample);
  }

  const Scene& scene_;
  const Machine& machine_;
  const Surroundings& around_;
  const ScoredGrasp& grasp_;
  const Trajectory& path_;
  Judgement judgement_;
  std::size_t grasped_ = path_.times.size() - 1;  // the sample at which the hand is closed
  Body object_;                                   // in the frame of the hand; empty: not carried
  Surroundings without_object_;
};

}  // namespace prehend::test

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <yaml-cpp/yaml.h>

#include <gtest/gtest.h>

#include "planner/show/exports/csv.h"
#include "planner/show/exports/isaac.h"
#include "planner/show/exports/moveit.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "tests/planner/show/exports/export_samples.h"

namespace prehend {
namespace {

using Strings = std::vector<std::string>;
using Numbers = std::vector<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using test::kBase;
using test::kObject;
using test::Sample;
using test::sample_grasp;
using test::sample_grasps;
using test::sample_header;
using test::sample_path;

Numbers numbers(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Numbers xyz(const YAML::Node& node) {
  EXPECT_EQ(node.size(), 3U);
  return {node["x"].as<double>(), node["y"].as<double>(), node["z"].as<double>()};
}

std::set<std::string> keys(const YAML::Node& node) {
  std::set<std::string> names;
  for (const auto& entry : node) names.insert(entry.first.as<std::string>());
  return names;
}

// Rotations read back agree to rounding: the quaternion is made from a matrix.
void expect_rotation(const Eigen::Quaterniond& q, const Pose& expected) {
  EXPECT_NEAR(q.norm(), 1.0, 1e-14);
  EXPECT_GE(q.w(), 0.0);
  EXPECT_LE((q.toRotationMatrix() - expected.linear()).cwiseAbs().maxCoeff(), 1e-14);
}

// Rows of fields, as RFC 4180 has them.
std::vector<Strings> parse_csv(const std::string& text) {
  std::vector<Strings> rows;
  Strings row;
  std::string field;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      field += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == ',' || c == '\n')) {
      row.push_back(field);
      field.clear();
      if (c == '\n') {
        rows.push_back(row);
        row.clear();
      }
    } else {
      field += c;
    }
  }
  EXPECT_FALSE(quoted);
  EXPECT_TRUE(field.empty() && row.empty());
  return rows;
}

class CsvTable {
 public:
  explicit CsvTable(const std::string& text) : rows_(parse_csv(text)) {
    for (const Strings& row : rows_) EXPECT_EQ(row.size(), rows_.front().size());
  }

  std::size_t size() const { return rows_.size() - 1; }
  const Strings& names() const { return rows_.front(); }

  std::string text(std::size_t row, const std::string& name) const {
    const auto found = std::find(names().begin(), names().end(), name);
    if (found == names().end()) {
      ADD_FAILURE() << "no column " << name;
      return "0";
    }
    return rows_[row + 1][static_cast<std::size_t>(found - names().begin())];
  }

  double number(std::size_t row, const std::string& name) const {
    return std::strtod(text(row, name).c_str(), nullptr);
  }

 private:
  std::vector<Strings> rows_;
};

TEST(Csv, GraspsReadBackEqual) {
  const std::vector<ExportGrasp> grasps = sample_grasps();
  const CsvTable table(grasps_csv(sample_header(), grasps));
  ASSERT_EQ(table.size(), grasps.size());
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const ExportGrasp& grasp = grasps[i];
    EXPECT_EQ(table.text(i, "rank"), std::to_string(grasp.rank));
    EXPECT_EQ(table.text(i, "outcome"), "stable");
    EXPECT_EQ(table.text(i, "preshape"), grasp.preshape);
    EXPECT_EQ(table.text(i, "path"), i == 1 ? "path_2.csv" : "");
    EXPECT_EQ(table.number(i, "epsilon"), grasp.epsilon);
    EXPECT_EQ(table.number(i, "volume"), grasp.volume);
    EXPECT_EQ(table.number(i, "approach_distance"), grasp.approach_distance);
    EXPECT_EQ(table.number(i, "dof_spread"), grasp.dofs[0]);
    EXPECT_EQ(table.number(i, "dof_close"), grasp.dofs[1]);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::string joint = sample_header().hand_joints[j];
      EXPECT_EQ(table.number(i, "pregrasp_" + joint), grasp.pregrasp_joints[j]);
      EXPECT_EQ(table.number(i, "closed_" + joint), grasp.closed_joints[j]);
      const auto axis = static_cast<Eigen::Index>(j);
      const std::string name = Strings{"x", "y", "z"}[j];
      EXPECT_EQ(table.number(i, "object_hand_" + name), grasp.X_OH.translation()[axis]);
      EXPECT_EQ(table.number(i, "world_hand_" + name), grasp.X_WH.translation()[axis]);
      EXPECT_EQ(table.number(i, "approach_object_" + name), grasp.approach_O[axis]);
    }
    const auto rotation = [&](const std::string& frame) {
      return Eigen::Quaterniond(table.number(i, frame + "qw"), table.number(i, frame + "qx"),
                                table.number(i, frame + "qy"), table.number(i, frame + "qz"));
    };
    expect_rotation(rotation("object_hand_"), grasp.X_OH);
    expect_rotation(rotation("world_hand_"), grasp.X_WH);
  }
}

TEST(Csv, PathReadsBackEqual) {
  const Trajectory path = sample_path();
  const CsvTable table(path_csv(path));
  EXPECT_EQ(table.names(), (Strings{"time", "segment", "arm/1, 1", "hand/2", "arm/1, 1_velocity",
                                    "hand/2_velocity"}));
  ASSERT_EQ(table.size(), path.times.size());
  const Strings segments = {"transfer", "transfer", "transfer", "approach", "approach"};
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    EXPECT_EQ(table.number(i, "time"), path.times[i]);
    EXPECT_EQ(table.text(i, "segment"), segments[i]);
    for (std::size_t j = 0; j < path.joints.size(); ++j) {
      EXPECT_EQ(table.number(i, path.joints[j]), path.positions[i][j]);
      EXPECT_EQ(table.number(i, path.joints[j] + "_velocity"), path.velocities[i][j]);
    }
  }
}

TEST(Csv, TextsAreQuotedWhereTheyMustBe) {
  ExportGrasp grasp = sample_grasp(1).grasp;
  grasp.preshape = kObject;
  EXPECT_EQ(CsvTable(grasps_csv(sample_header(), {grasp})).text(0, "preshape"), kObject);
}

TEST(Isaac, GraspsReadBackEqual) {
  std::vector<ExportGrasp> grasps = sample_grasps();
  grasps.back().epsilon = 1.5;
  const YAML::Node file = YAML::Load(isaac_grasps_yaml(sample_header(), grasps));
  EXPECT_EQ(file["format"].as<std::string>(), "isaac_grasp");
  EXPECT_EQ(file["format_version"].as<double>(), 1.0);
  for (const std::string suffix : {"", "_link"}) {
    EXPECT_EQ(file["object_frame" + suffix].as<std::string>(), kObject);
    EXPECT_EQ(file["gripper_frame" + suffix].as<std::string>(), kBase);
  }
  ASSERT_EQ(file["grasps"].size(), grasps.size());
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const ExportGrasp& grasp = grasps[i];
    const YAML::Node node = file["grasps"]["grasp_" + std::to_string(i)];
    EXPECT_EQ(keys(node), (std::set<std::string>{"confidence", "position", "orientation",
                                                 "cspace_position", "pregrasp_cspace_position"}));
    EXPECT_EQ(node["confidence"].as<double>(), std::min(grasp.epsilon, 1.0));
    const Pose X_OB = grasp.X_OH * sample_header().end_effector.base.X_HF;
    EXPECT_EQ(node["position"].as<Numbers>(), numbers(X_OB.translation()));
    const Numbers q = node["orientation"]["xyz"].as<Numbers>();
    ASSERT_EQ(q.size(), 3U);
    expect_rotation({node["orientation"]["w"].as<double>(), q[0], q[1], q[2]}, X_OB);
    ASSERT_EQ(node["cspace_position"].size(), 3U);
    ASSERT_EQ(node["pregrasp_cspace_position"].size(), 3U);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::string joint = sample_header().driver_joints[j];
      EXPECT_EQ(node["cspace_position"][joint].as<double>(), grasp.closed_joints[j]);
      EXPECT_EQ(node["pregrasp_cspace_position"][joint].as<double>(), grasp.pregrasp_joints[j]);
    }
  }
}

// Where Isaac Sim puts the gripper for an object somewhere in its world (GraspSpec,
// compute_gripper_pose_from_rigid_body_pose): position = t_O + R_O p, rotation = R_O R.
TEST(Isaac, PoseIsTheHandsInTheObjectsFrame) {
  const Sample sample = sample_grasp(3);
  const YAML::Node node =
      YAML::Load(isaac_grasps_yaml(sample_header(), {sample.grasp}))["grasps"]["grasp_0"];
  const Numbers p = node["position"].as<Numbers>();
  const Numbers q = node["orientation"]["xyz"].as<Numbers>();
  const Eigen::Quaterniond rotation(node["orientation"]["w"].as<double>(), q[0], q[1], q[2]);
  const Vector3 position = sample.X_WO * Vector3(p[0], p[1], p[2]);
  const Matrix3 turn = sample.X_WO.linear() * rotation.toRotationMatrix();
  const Pose X_WB = sample.grasp.X_WH * sample_header().end_effector.base.X_HF;
  EXPECT_LE((position - X_WB.translation()).norm(), 1e-14);
  EXPECT_LE((turn - X_WB.linear()).norm(), 1e-14);
}

// Every name and sign of a text survives readers that guess types: it is quoted.
TEST(Isaac, TextsAreQuoted) {
  const std::string text = isaac_grasps_yaml(sample_header(), sample_grasps());
  for (const std::string quoted : {"\"~\"", "\"2.0\":", "\"no\":", "\"b: a\":"}) {
    EXPECT_NE(text.find(quoted), std::string::npos) << quoted;
  }
}

void expect_stamp(const YAML::Node& header, const std::string& frame, bool ros1) {
  const std::set<std::string> names =
      ros1 ? std::set<std::string>{"secs", "nsecs"} : std::set<std::string>{"sec", "nanosec"};
  EXPECT_EQ(keys(header), (std::set<std::string>{"stamp", "frame_id"}));
  EXPECT_EQ(keys(header["stamp"]), names);
  EXPECT_EQ(header["frame_id"].as<std::string>(), frame);
}

const std::set<std::string> kTrajectoryKeys = {"header", "joint_names", "points"};
const std::set<std::string> kPointKeys = {"positions", "velocities", "accelerations", "effort",
                                          "time_from_start"};

double seconds_of(const YAML::Node& time, bool ros1) {
  const auto rest = time[ros1 ? "nsecs" : "nanosec"].as<long long>();
  EXPECT_GE(rest, 0);
  EXPECT_LT(rest, 1000000000);
  return static_cast<double>(time[ros1 ? "secs" : "sec"].as<long long>()) +
         1e-9 * static_cast<double>(rest);
}

// Each segment has the joints of the robots that move in it, by the names of their driver, and a
// time of its own.
TEST(Moveit, TrajectoriesReadBackEqual) {
  Trajectory path = sample_path();
  // While it approaches the arm rests.
  for (std::size_t i = 2; i < path.times.size(); ++i) {
    path.positions[i][0] = path.positions[2][0];
    path.velocities[i][0] = 0.0;
  }
  const Strings names = {"panda_joint1", "finger"};
  for (const RosVersion ros : {RosVersion::ros1, RosVersion::ros2}) {
    const bool ros1 = ros == RosVersion::ros1;
    const YAML::Node file =
        YAML::Load(moveit_trajectories_yaml(path, names, {.ros = ros, .world_frame = "base"}));
    // Nothing moves in the last segment.
    const std::vector<std::vector<std::size_t>> moving = {{0, 1}, {1}};
    ASSERT_EQ(file.size(), moving.size());
    for (std::size_t s = 0; s < file.size(); ++s) {
      const TrajectorySegment& segment = path.segments[s];
      EXPECT_EQ(keys(file[s]), (std::set<std::string>{"segment", "trajectory"}));
      EXPECT_EQ(file[s]["segment"].as<std::string>(), segment.name);
      const YAML::Node trajectory = file[s]["trajectory"];
      EXPECT_EQ(keys(trajectory),
                (std::set<std::string>{"joint_trajectory", "multi_dof_joint_trajectory"}));
      const YAML::Node node = trajectory["joint_trajectory"];
      EXPECT_EQ(keys(node), kTrajectoryKeys);
      expect_stamp(node["header"], "base", ros1);
      Strings joints;
      for (const std::size_t j : moving[s]) joints.push_back(names[j]);
      EXPECT_EQ(node["joint_names"].as<Strings>(), joints);
      ASSERT_EQ(node["points"].size(), static_cast<std::size_t>(segment.last - segment.first + 1));
      for (std::size_t i = 0; i < node["points"].size(); ++i) {
        const YAML::Node point = node["points"][i];
        EXPECT_EQ(keys(point), kPointKeys);
        const std::size_t at = i + static_cast<std::size_t>(segment.first);
        for (std::size_t k = 0; k < moving[s].size(); ++k) {
          EXPECT_EQ(point["positions"][k].as<double>(), path.positions[at][moving[s][k]]);
          EXPECT_EQ(point["velocities"][k].as<double>(), path.velocities[at][moving[s][k]]);
        }
        EXPECT_EQ(point["positions"].size(), moving[s].size());
        EXPECT_EQ(point["accelerations"].size(), 0U);
        EXPECT_EQ(point["effort"].size(), 0U);
        EXPECT_NEAR(seconds_of(point["time_from_start"], ros1),
                    path.times[at] - path.times[static_cast<std::size_t>(segment.first)], 0.51e-9);
      }
      const YAML::Node multi = trajectory["multi_dof_joint_trajectory"];
      EXPECT_EQ(keys(multi), kTrajectoryKeys);
      expect_stamp(multi["header"], "", ros1);
      EXPECT_TRUE(multi["joint_names"].IsSequence() && multi["joint_names"].size() == 0);
      EXPECT_TRUE(multi["points"].IsSequence() && multi["points"].size() == 0);
    }
  }
}

void expect_posture(const YAML::Node& node, const Numbers& joints) {
  EXPECT_EQ(keys(node), kTrajectoryKeys);
  expect_stamp(node["header"], kBase, false);
  EXPECT_EQ(node["joint_names"].as<Strings>(), sample_header().driver_joints);
  ASSERT_EQ(node["points"].size(), 1U);
  EXPECT_EQ(keys(node["points"][0]), kPointKeys);
  EXPECT_EQ(node["points"][0]["positions"].as<Numbers>(), joints);
  EXPECT_EQ(node["points"][0]["time_from_start"]["sec"].as<int>(), 0);
  EXPECT_EQ(node["points"][0]["time_from_start"]["nanosec"].as<int>(), 500000000);
}

void expect_translation(const YAML::Node& node, const Numbers& direction, double distance) {
  EXPECT_EQ(keys(node), (std::set<std::string>{"direction", "desired_distance", "min_distance"}));
  expect_stamp(node["direction"]["header"], kObject, false);
  EXPECT_EQ(xyz(node["direction"]["vector"]), direction);
  EXPECT_EQ(node["desired_distance"].as<double>(), distance);
  EXPECT_EQ(node["min_distance"].as<double>(), 0.5 * distance);
}

TEST(Moveit, GraspsReadBackEqual) {
  const std::vector<ExportGrasp> grasps = sample_grasps();
  const YAML::Node file = YAML::Load(moveit_grasps_yaml(sample_header(), grasps));
  ASSERT_TRUE(file.IsSequence());
  ASSERT_EQ(file.size(), grasps.size());
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const ExportGrasp& grasp = grasps[i];
    const YAML::Node node = file[i];
    EXPECT_EQ(keys(node), (std::set<std::string>{
                              "id", "pre_grasp_posture", "grasp_posture", "grasp_pose",
                              "grasp_quality", "pre_grasp_approach", "post_grasp_retreat",
                              "post_place_retreat", "max_contact_force", "allowed_touch_objects"}));
    EXPECT_EQ(node["id"].as<std::string>(), "grasp_" + std::to_string(grasp.rank));
    expect_posture(node["pre_grasp_posture"], grasp.pregrasp_joints);
    expect_posture(node["grasp_posture"], grasp.closed_joints);
    expect_stamp(node["grasp_pose"]["header"], kObject, false);
    const YAML::Node pose = node["grasp_pose"]["pose"];
    const Pose X_OP = grasp.X_OH * sample_header().end_effector.parent.X_HF;
    EXPECT_EQ(xyz(pose["position"]), numbers(X_OP.translation()));
    const YAML::Node q = pose["orientation"];
    expect_rotation(
        {q["w"].as<double>(), q["x"].as<double>(), q["y"].as<double>(), q["z"].as<double>()}, X_OP);
    EXPECT_EQ(node["grasp_quality"].as<double>(), grasp.epsilon);
    const Numbers back = numbers(-grasp.approach_O);
    expect_translation(node["pre_grasp_approach"], numbers(grasp.approach_O),
                       grasp.approach_distance);
    expect_translation(node["post_grasp_retreat"], back, grasp.approach_distance);
    expect_translation(node["post_place_retreat"], back, grasp.approach_distance);
    EXPECT_EQ(node["max_contact_force"].as<double>(), 0.0);
    EXPECT_EQ(node["allowed_touch_objects"].as<Strings>(), Strings{kObject});
  }
}

TEST(Moveit, WorldFrameAndMountingLink) {
  const Sample sample = sample_grasp(4);
  const MoveitOptions options{
      .ros = RosVersion::ros1, .frame = GraspFrame::world, .world_frame = "map"};
  const YAML::Node node =
      YAML::Load(moveit_grasps_yaml(sample_header(), {sample.grasp}, options))[0];
  expect_stamp(node["grasp_pose"]["header"], "map", true);
  const Pose X_WP = sample.X_WO * sample.grasp.X_OH * sample_header().end_effector.parent.X_HF;
  const YAML::Node pose = node["grasp_pose"]["pose"];
  const Numbers p = xyz(pose["position"]);
  EXPECT_LE((Vector3(p[0], p[1], p[2]) - X_WP.translation()).norm(), 1e-14);
  const YAML::Node q = pose["orientation"];
  expect_rotation(
      {q["w"].as<double>(), q["x"].as<double>(), q["y"].as<double>(), q["z"].as<double>()}, X_WP);
  const YAML::Node approach = node["pre_grasp_approach"];
  expect_stamp(approach["direction"]["header"], "map", true);
  const Numbers d = xyz(approach["direction"]["vector"]);
  const Vector3 approach_W = sample.X_WO.linear() * sample.grasp.approach_O;
  EXPECT_LE((Vector3(d[0], d[1], d[2]) - approach_W).norm(), 1e-14);
}

// Names of frames may hold anything; the lines about them stay comments.
TEST(Moveit, FramesAreSaidInComments) {
  const std::string text = moveit_grasps_yaml(sample_header(), {sample_grasp(1).grasp});
  EXPECT_NE(text.find("# Poses are those of the frame flange"), std::string::npos) << text;
  EXPECT_NE(text.find("tool centre point, tcp:"), std::string::npos);
  EXPECT_EQ(YAML::Load(text).size(), 1U);
}

TEST(Exports, NoGraspIsAnEmptyFile) {
  EXPECT_EQ(CsvTable(grasps_csv(sample_header(), {})).size(), 0U);
  EXPECT_TRUE(YAML::Load(isaac_grasps_yaml(sample_header(), {}))["grasps"].IsMap());
  EXPECT_TRUE(YAML::Load(moveit_grasps_yaml(sample_header(), {})).IsSequence());
}

void expect_refused(const ExportGrasp& grasp) {
  EXPECT_THROW(grasps_csv(sample_header(), {grasp}), InputError);
  EXPECT_THROW(isaac_grasps_yaml(sample_header(), {grasp}), InputError);
  EXPECT_THROW(moveit_grasps_yaml(sample_header(), {grasp}), InputError);
}

TEST(Exports, RefuseWhatDoesNotFitTheirNames) {
  ExportGrasp grasp = sample_grasp(1).grasp;
  grasp.dofs.pop_back();
  expect_refused(grasp);
  grasp = sample_grasp(1).grasp;
  grasp.closed_joints.push_back(0.0);
  expect_refused(grasp);
  grasp = sample_grasp(1).grasp;
  grasp.pregrasp_joints[2] = kNaN;
  expect_refused(grasp);
  Trajectory path = sample_path();
  path.velocities[2].pop_back();
  EXPECT_THROW(path_csv(path), InputError);
  EXPECT_THROW(moveit_trajectories_yaml(path, {"a", "b"}), InputError);
  path = sample_path();
  path.positions.pop_back();
  EXPECT_THROW(path_csv(path), InputError);
  path = sample_path();
  path.times[1] = -1.0;
  EXPECT_THROW(moveit_trajectories_yaml(path, {"a", "b"}), InputError);
}

}  // namespace
}  // namespace prehend

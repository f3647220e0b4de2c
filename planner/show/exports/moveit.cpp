#include "planner/show/exports/moveit.h"

#include <cstddef>
#include <set>

#include "planner/show/exports/moveit_message.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// One of moveit_msgs/Grasp, key by key.
class GraspWriter {
 public:
  GraspWriter(YAML::Emitter& yaml, const ExportHeader& header, const MoveitOptions& options)
      : yaml_(yaml), header_(header), options_(options), message_(yaml, options.ros) {}

  void write(const ExportGrasp& grasp) {
    yaml_ << YAML::BeginMap;
    key("id");
    put_text(yaml_, "grasp_" + std::to_string(grasp.rank));
    posture("pre_grasp_posture", grasp.pregrasp_joints);
    posture("grasp_posture", grasp.closed_joints);
    key("grasp_pose");
    yaml_ << YAML::BeginMap;
    message_.header(frame());
    key("pose");
    // The message has the pose of the link that carries the hand, not of the hand's base.
    message_.pose((in_world() ? grasp.X_WH : grasp.X_OH) * header_.end_effector.parent.X_HF);
    yaml_ << YAML::EndMap;
    key("grasp_quality");
    put_number(yaml_, grasp.epsilon);
    // Directions have a header of their own; they are given in the frame of the pose. With the pose
    // in the world, the rotation from object to world is R_WH R_OH^T.
    const Vector3 direction =
        in_world()
            ? Vector3(grasp.X_WH.linear() * (grasp.X_OH.linear().transpose() * grasp.approach_O))
            : grasp.approach_O;
    translation("pre_grasp_approach", direction, grasp.approach_distance);
    // Back along the approach, for both retreats.
    translation("post_grasp_retreat", -direction, grasp.approach_distance);
    translation("post_place_retreat", -direction, grasp.approach_distance);
    key("max_contact_force");
    // 0 stands for no limit.
    put_number(yaml_, 0.0);
    key("allowed_touch_objects");
    put_texts(yaml_, {header_.object});
    yaml_ << YAML::EndMap;
  }

 private:
  void key(const std::string& name) { yaml_ << YAML::Key << name << YAML::Value; }

  bool in_world() const { return options_.frame == GraspFrame::world; }

  const std::string& frame() const { return in_world() ? options_.world_frame : header_.object; }

  // trajectory_msgs/JointTrajectory of one point.
  void posture(const std::string& name, const std::vector<double>& joints) {
    key(name);
    yaml_ << YAML::BeginMap;
    message_.header(header_.end_effector.base.name);
    key("joint_names");
    put_texts(yaml_, header_.driver_joints);
    key("points");
    yaml_ << YAML::BeginSeq;
    message_.point(options_.posture_time, joints, {});
    yaml_ << YAML::EndSeq << YAML::EndMap;
  }

  // moveit_msgs/GripperTranslation.
  void translation(const std::string& name, const Vector3& direction, double distance) {
    key(name);
    yaml_ << YAML::BeginMap;
    key("direction");
    yaml_ << YAML::BeginMap;
    message_.header(frame());
    key("vector");
    put_vector(yaml_, direction);
    yaml_ << YAML::EndMap;
    key("desired_distance");
    put_number(yaml_, distance);
    key("min_distance");
    put_number(yaml_, options_.least_part * distance);
    yaml_ << YAML::EndMap;
  }

  YAML::Emitter& yaml_;
  const ExportHeader& header_;
  const MoveitOptions& options_;
  MoveitMessage message_;
};

// The robot of a joint: what stands before the last '/' of its name, or nothing.
std::string robot_of(const std::string& joint) { return joint.substr(0, joint.rfind('/') + 1); }

// The joints of the robots that move in the segment.
std::vector<std::size_t> moving_joints(const Trajectory& path, const TrajectorySegment& segment) {
  std::set<std::string> moving;
  for (std::size_t j = 0; j < path.joints.size(); ++j) {
    const double start = path.positions[index(segment.first)][j];
    for (int i = segment.first; i <= segment.last; ++i) {
      const bool moves =
          path.positions[index(i)][j] != start || path.velocities[index(i)][j] != 0.0;
      if (moves) moving.insert(robot_of(path.joints[j]));
    }
  }
  std::vector<std::size_t> joints;
  for (std::size_t j = 0; j < path.joints.size(); ++j) {
    if (moving.contains(robot_of(path.joints[j]))) joints.push_back(j);
  }
  return joints;
}

template <typename T>
std::vector<T> chosen(const std::vector<T>& all, const std::vector<std::size_t>& which) {
  std::vector<T> result;
  for (const std::size_t i : which) result.push_back(all[i]);
  return result;
}

class TrajectoryWriter {
 public:
  TrajectoryWriter(YAML::Emitter& yaml, const Trajectory& path,
                   const std::vector<std::string>& names, const MoveitOptions& options)
      : yaml_(yaml), path_(path), names_(names), options_(options), message_(yaml, options.ros) {}

  void write(const TrajectorySegment& segment) {
    const std::vector<std::size_t> joints = moving_joints(path_, segment);
    if (joints.empty()) return;
    yaml_ << YAML::BeginMap << YAML::Key << "segment" << YAML::Value;
    put_text(yaml_, segment.name);
    yaml_ << YAML::Key << "trajectory" << YAML::Value << YAML::BeginMap;
    yaml_ << YAML::Key << "joint_trajectory" << YAML::Value << YAML::BeginMap;
    message_.header(options_.world_frame);
    yaml_ << YAML::Key << "joint_names" << YAML::Value;
    put_texts(yaml_, chosen(names_, joints));
    yaml_ << YAML::Key << "points" << YAML::Value << YAML::BeginSeq;
    const double start = path_.times[index(segment.first)];
    for (int i = segment.first; i <= segment.last; ++i) {
      message_.point(path_.times[index(i)] - start, chosen(path_.positions[index(i)], joints),
                     chosen(path_.velocities[index(i)], joints));
    }
    yaml_ << YAML::EndSeq << YAML::EndMap;
    write_no_other_joints();
    yaml_ << YAML::EndMap << YAML::EndMap;
  }

 private:
  // RobotTrajectory has joints of several degrees of freedom in any case; platforms have none.
  void write_no_other_joints() {
    yaml_ << YAML::Key << "multi_dof_joint_trajectory" << YAML::Value << YAML::BeginMap;
    message_.header("");
    yaml_ << YAML::Key << "joint_names" << YAML::Value;
    put_texts(yaml_, {});
    yaml_ << YAML::Key << "points" << YAML::Value;
    put_texts(yaml_, {});
    yaml_ << YAML::EndMap;
  }

  YAML::Emitter& yaml_;
  const Trajectory& path_;
  const std::vector<std::string>& names_;
  const MoveitOptions& options_;
  MoveitMessage message_;
};

}  // namespace

std::string moveit_trajectories_yaml(const Trajectory& path, const std::vector<std::string>& names,
                                     const MoveitOptions& options) {
  check_sizes(path);
  require(names.size() == path.joints.size(),
          {.field = "path", .problem = "names of other joints than those of the path"});
  YAML::Emitter yaml;
  TrajectoryWriter writer(yaml, path, names, options);
  yaml << YAML::BeginSeq;
  for (const TrajectorySegment& segment : path.segments) writer.write(segment);
  yaml << YAML::EndSeq;
  return yaml_text(yaml);
}

std::string moveit_grasps_yaml(const ExportHeader& header, const std::vector<ExportGrasp>& grasps,
                               const MoveitOptions& options) {
  YAML::Emitter yaml;
  put_comment(yaml, frames_text(header.end_effector, header.end_effector.parent));
  GraspWriter writer(yaml, header, options);
  yaml << YAML::BeginSeq;
  for (const ExportGrasp& grasp : grasps) {
    check_sizes(header, grasp);
    writer.write(grasp);
  }
  yaml << YAML::EndSeq;
  return yaml_text(yaml);
}

}  // namespace prehend

#include "planner/show/exports/moveit.h"

#include "planner/show/exports/moveit_message.h"

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
    // The message has the pose of the link that carries the hand (P), not of the hand's base.
    message_.pose((in_world() ? grasp.X_WH : grasp.X_OH) * options_.X_HP);
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
    message_.header(header_.hand_base);
    key("joint_names");
    put_texts(yaml_, header_.hand_joints);
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

}  // namespace

std::string moveit_trajectory_yaml(const Trajectory& path, const MoveitOptions& options) {
  check_sizes(path);
  YAML::Emitter yaml;
  MoveitMessage message(yaml, options.ros);
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "joint_trajectory" << YAML::Value << YAML::BeginMap;
  message.header(options.world_frame);
  yaml << YAML::Key << "joint_names" << YAML::Value;
  put_texts(yaml, path.joints);
  yaml << YAML::Key << "points" << YAML::Value << YAML::BeginSeq;
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    message.point(path.times[i], path.positions[i], path.velocities[i]);
  }
  yaml << YAML::EndSeq << YAML::EndMap;
  yaml << YAML::Key << "multi_dof_joint_trajectory" << YAML::Value << YAML::BeginMap;
  // RobotTrajectory has this part in any case. The platform has no joints of several degrees of
  // freedom, so it is empty.
  message.header("");
  yaml << YAML::Key << "joint_names" << YAML::Value;
  put_texts(yaml, {});
  yaml << YAML::Key << "points" << YAML::Value;
  put_texts(yaml, {});
  yaml << YAML::EndMap << YAML::EndMap;
  return yaml_text(yaml);
}

std::string moveit_grasps_yaml(const ExportHeader& header, const std::vector<ExportGrasp>& grasps,
                               const MoveitOptions& options) {
  YAML::Emitter yaml;
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

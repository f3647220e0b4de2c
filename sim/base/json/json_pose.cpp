#include "sim/base/json/json_pose.h"

#include <cmath>

#include "sim/base/pose.h"
#include "sim/base/range.h"

namespace prehend {

Pose read_pose(const JsonField& field) {
  field.allow_only({"position", "quaternion_wxyz"});
  Pose pose = Pose::Identity();
  if (field.has("position")) {
    pose.translation() = field["position"].vector3(kCoordinate);
  }
  if (field.has("quaternion_wxyz")) {
    const std::vector<double> q = field["quaternion_wxyz"].numbers(4);
    // Eigen's constructor takes w first, as the file does, although Eigen stores it last.
    Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
    if (!(std::abs(rotation.norm() - 1.0) <= 1e-3)) {
      field["quaternion_wxyz"].fail("not a rotation: its length is not 1");
    }
    pose.linear() = rotation.normalized().toRotationMatrix();
  }
  return pose;
}

nlohmann::ordered_json pose_to_json(const Pose& pose) {
  const Eigen::Quaterniond q = quaternion_of(pose);
  return {{"position", vector_to_json(pose.translation())},
          {"quaternion_wxyz", {q.w(), q.x(), q.y(), q.z()}}};
}

nlohmann::ordered_json vector_to_json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace prehend

#include "sim/robot/files/graspit_transform.h"

#include <cmath>
#include <sstream>

namespace prehend {
namespace {

// Matrices are typed with few digits: how far one may be from a rotation.
constexpr double kTypedRotation = 0.01;

Pose turn(const XmlElement& step) {
  std::istringstream words(step.content());
  std::string angle;
  std::string axis;
  std::string rest;
  words >> angle >> axis;
  if (axis.size() != 1 || words >> rest) {
    step.fail("must be an angle and an axis (x, y or z)", step.content());
  }
  const auto which = std::string("xyzXYZ").find(axis);
  if (which == std::string::npos) step.fail("the axis must be x, y or z", axis);
  const double degrees = step.number_in(angle, "the angle");
  return Pose(Eigen::AngleAxisd(degrees * kGraspitAngle,
                                Vector3::Unit(static_cast<Eigen::Index>(which % 3))));
}

Pose turn_by_matrix(const XmlElement& step) {
  const std::vector<double> v = step.content_numbers();
  if (v.size() != 9) step.fail("must be nine numbers", step.content());
  const Matrix3 given = Eigen::Map<const Matrix3>(v.data());
  const bool rotation = (given.transpose() * given - Matrix3::Identity()).norm() < kTypedRotation &&
                        given.determinant() > 0.0;
  if (!rotation) step.fail("not a rotation", step.content());
  return Pose(Eigen::Quaterniond(given).normalized());
}

// "(+0.5 -0.5 0.5 0.5)[0 0 +10]".
Pose full_transform(const XmlElement& step) {
  std::string text = step.content();
  const std::size_t middle = text.find(")[");
  if (!text.starts_with('(') || !text.ends_with(']') || middle == std::string::npos) {
    step.fail("must be written as (w x y z)[x y z]", text);
  }
  const std::vector<double> q = step.numbers_in(text.substr(1, middle - 1), "the quaternion");
  const std::vector<double> p =
      step.numbers_in(text.substr(middle + 2, text.size() - middle - 3), "the translation");
  if (q.size() != 4 || p.size() != 3) step.fail("must be written as (w x y z)[x y z]", text);
  const Eigen::Quaterniond rotation(q[0], q[1], q[2], q[3]);
  if (!(std::abs(rotation.norm() - 1.0) < kTypedRotation)) step.fail("not a unit quaternion", text);
  return translation(kGraspitLength * Vector3(p[0], p[1], p[2])) * Pose(rotation.normalized());
}

}  // namespace

Vector3 graspit_vector(const XmlElement& element, double unit) {
  const std::vector<double> v = element.content_numbers();
  if (v.size() != 3) element.fail("must be three numbers", element.content());
  return unit * Vector3(v[0], v[1], v[2]);
}

Pose read_graspit_transform(const XmlElement& transform) {
  Pose X = Pose::Identity();
  for (const XmlElement& step : transform.children()) {
    if (step.name() == "translation") {
      X = X * translation(graspit_vector(step, kGraspitLength));
    } else if (step.name() == "rotation") {
      X = X * turn(step);
    } else if (step.name() == "rotationMatrix") {
      X = X * turn_by_matrix(step);
    } else if (step.name() == "fullTransform") {
      X = X * full_transform(step);
    } else {
      step.fail("not a step of a transform");
    }
  }
  return X;
}

}  // namespace prehend

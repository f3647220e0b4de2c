#include "sim/robot/files/mjcf_defaults.h"

#include <cctype>
#include <numbers>
#include <utility>

#include "sim/base/range.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

constexpr const char* kOutermost = "main";
constexpr double kShortestVector = 1e-100;

Vector3 unit_vector(const XmlElement& element, const Vector3& v) {
  if (!(v.norm() > kShortestVector)) element.fail("a direction must not be 0");
  return v.stableNormalized();
}

std::vector<double> exactly(const XmlElement& element, const std::string& attribute,
                            std::size_t count) {
  const std::vector<double> values = element.numbers(attribute);
  if (values.size() != count) {
    element.fail("attribute " + attribute + " must have " + std::to_string(count) + " numbers",
                 element.text(attribute));
  }
  return values;
}

}  // namespace

MjcfDefaults::MjcfDefaults(const XmlElement& root) {
  angle_unit_ = std::numbers::pi / 180.0;
  for (const XmlElement& compiler : root.children("compiler")) {
    const std::string angle = compiler.text_or("angle", "");
    if (angle == "radian") angle_unit_ = 1.0;
    if (angle == "degree") angle_unit_ = std::numbers::pi / 180.0;
    if (compiler.has("autolimits")) autolimits_ = compiler.text("autolimits") != "false";
    if (compiler.has("fitaabb")) fits_bounds_ = compiler.text("fitaabb") == "true";
    mesh_folder_ = compiler.text_or("meshdir", compiler.text_or("assetdir", mesh_folder_));
    euler_order_ = compiler.text_or("eulerseq", euler_order_);
    if (euler_order_.size() != 3 || euler_order_.find_first_not_of("xyzXYZ") != std::string::npos) {
      compiler.fail("eulerseq must be three of x, y, z, X, Y, Z", euler_order_);
    }
    if (compiler.text_or("coordinate", "local") != "local") {
      compiler.fail("only local coordinates can be read", compiler.text("coordinate"));
    }
  }
  classes_[kOutermost];
  for (const XmlElement& outermost : root.children("default")) read_class(outermost, "");
}

void MjcfDefaults::read_class(const XmlElement& element, const std::string& around) {
  const std::string name =
      around.empty() ? element.text_or("class", kOutermost) : element.text("class");
  Class& own = classes_[name];
  own.around = around.empty() && name != kOutermost ? kOutermost : around;
  for (const XmlElement& child : element.children()) {
    if (child.name() != "default") own.elements.push_back(child);
  }
  for (const XmlElement& child : element.children("default")) {
    if (classes_.contains(child.text("class"))) {
      child.fail("name used twice", child.text("class"));
    }
    read_class(child, name);
  }
}

std::optional<XmlElement> MjcfDefaults::saying(const std::string& attribute,
                                               const XmlElement& element,
                                               const std::string& childclass) const {
  if (element.has(attribute)) return element;
  std::string name = element.text_or("class", childclass.empty() ? kOutermost : childclass);
  if (!classes_.contains(name)) element.fail("no default class of this name", name);
  while (!name.empty()) {
    const Class& own = classes_.at(name);
    for (const XmlElement& of_class : own.elements) {
      if (of_class.name() == element.name() && of_class.has(attribute)) return of_class;
    }
    name = own.around;
  }
  return std::nullopt;
}

// Lower-case axes turn with the body, upper-case ones stay.
Matrix3 MjcfDefaults::from_euler(const Vector3& angles) const {
  Matrix3 R = Matrix3::Identity();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto axis = static_cast<unsigned char>(euler_order_[static_cast<std::size_t>(k)]);
    const Matrix3 turn =
        Eigen::AngleAxisd(angles[k] * angle_unit_, Vector3::Unit(std::tolower(axis) - 'x'))
            .toRotationMatrix();
    R = std::islower(axis) ? Matrix3(R * turn) : Matrix3(turn * R);
  }
  return R;
}

Matrix3 MjcfDefaults::rotation(const XmlElement& element, const std::string& childclass) const {
  if (const auto at = saying("quat", element, childclass)) {
    const std::vector<double> q = exactly(*at, "quat", 4);
    Eigen::Vector4d xyzw(q[1], q[2], q[3], q[0]);
    if (!(xyzw.norm() > kShortestVector)) at->fail("a quaternion must not be 0");
    xyzw = xyzw.stableNormalized();
    return Eigen::Quaterniond(xyzw).toRotationMatrix();
  }
  if (const auto at = saying("axisangle", element, childclass)) {
    const std::vector<double> a = exactly(*at, "axisangle", 4);
    return Eigen::AngleAxisd(a[3] * angle_unit_, unit_vector(*at, {a[0], a[1], a[2]}))
        .toRotationMatrix();
  }
  if (const auto at = saying("euler", element, childclass)) return from_euler(at->vector3("euler"));
  if (const auto at = saying("xyaxes", element, childclass)) {
    const std::vector<double> a = exactly(*at, "xyaxes", 6);
    const Vector3 x = unit_vector(*at, {a[0], a[1], a[2]});
    const Vector3 along(a[3], a[4], a[5]);
    const Vector3 y = unit_vector(*at, along - along.dot(x) * x);
    Matrix3 R;
    R << x, y, x.cross(y);
    return R;
  }
  if (const auto at = saying("zaxis", element, childclass)) {
    const Vector3 z = unit_vector(*at, at->vector3("zaxis"));
    return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), z).toRotationMatrix();
  }
  return Matrix3::Identity();
}

Pose MjcfDefaults::pose(const XmlElement& element, const std::string& childclass) const {
  Vector3 p = Vector3::Zero();
  if (const auto at = saying("pos", element, childclass)) {
    p = at->vector3("pos");
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) {
      at->fail("is farther away than 1e6 m", at->text("pos"));
    }
  }
  return pose_from(rotation(element, childclass), p);
}

}  // namespace prehend

#include "sim/robot/files/sdf_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/number_text.h"
#include "sim/base/range.h"
#include "sim/base/xml/xml_maker.h"
#include "sim/base/xml/xml_text.h"
#include "sim/robot/files/sdf_parts.h"
#include "sim/robot/files/urdf_geometry.h"

namespace prehend {
namespace {

constexpr double kEndless = 1e15;           // limits beyond it mean that there are none
constexpr std::size_t kMostRelative = 200;  // frames of which each is relative to the next
constexpr const char* kModelFrame = "__model__";

class SdfModel {
 public:
  explicit SdfModel(const XmlFile& file)
      : root_(file.root()), model_(root_["model"]), maker_(file.path()) {
    // 1.10 comes after 1.9.
    const std::string version = root_.text_or("version", "1.7");
    is_early_ = version == "1.4" || version == "1.3" || version == "1.2" || version == "1.0";
    for (const char* tag : {"link", "joint", "frame"}) {
      for (const XmlElement& element : model_.children(tag)) {
        const std::string name = element.text("name");
        if (!frames_.emplace(name, element).second) element.fail("name used twice", name);
      }
    }
  }

  XmlFile urdf() {
    for (const auto& [name, element] : frames_) (void)pose_in_model(element, 0);
    maker_.open(model_, "robot");
    maker_.attribute("name", model_.text_or("name", "model"));
    // A link hangs on the frame of its first joint.
    std::vector<XmlElement> carriers;
    std::vector<XmlElement> closers;
    for (const XmlElement& joint : model_.children("joint")) {
      if (is_of_world(joint)) continue;
      const bool is_first = X_MT_.emplace(linked(joint, "child"), pose_in_model(joint, 0)).second;
      (is_first ? carriers : closers).push_back(joint);
    }
    for (const XmlElement& link : model_.children("link")) write_link(link);
    for (const XmlElement& joint : carriers) write_joint(joint);
    for (const XmlElement& joint : closers) write_loop(joint);
    maker_.close();
    return maker_.finished();
  }

 private:
  // Of a joint, "parent" or "child": a link. Frames that are attached to one stand for it.
  std::string linked(const XmlElement& joint, const char* tag) const {
    const XmlElement at = joint[tag];
    std::string name = at.content();
    for (std::size_t steps = 0; steps <= frames_.size(); ++steps) {
      const auto found = frames_.find(name);
      if (found == frames_.end()) at.fail("no link of this name", name);
      if (found->second.name() == "link") return name;
      if (found->second.name() != "frame") break;
      name = found->second.text_or("attached_to", kModelFrame);
    }
    at.fail("is no link", name);
  }

  // What holds the model in the world holds the base of the robot.
  static bool is_of_world(const XmlElement& joint) { return joint["parent"].content() == "world"; }

  static Pose pose_of(const XmlElement& element) {
    const std::optional<XmlElement> pose = element.child("pose");
    if (!pose || pose->content().empty()) return Pose::Identity();
    const std::vector<double> at = pose->content_numbers();
    const bool is_quaternion = pose->text_or("rotation_format", "euler_rpy") == "quat_xyzw";
    if (at.size() != (is_quaternion ? 7U : 6U)) pose->fail("must have 6 numbers", pose->content());
    const Vector3 p(at[0], at[1], at[2]);
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) pose->fail("is farther away than 1e6 m");
    if (is_quaternion) {
      const Eigen::Quaterniond q(at[6], at[3], at[4], at[5]);
      if (!(q.norm() > 1e-6)) pose->fail("a quaternion must not be 0", pose->content());
      return pose_from(q.normalized().toRotationMatrix(), p);
    }
    const double unit =
        pose->text_or("degrees", "false") == "true" ? std::numbers::pi / 180.0 : 1.0;
    return translation(p) * Eigen::AngleAxisd(unit * at[5], Vector3::UnitZ()) *
           Eigen::AngleAxisd(unit * at[4], Vector3::UnitY()) *
           Eigen::AngleAxisd(unit * at[3], Vector3::UnitX());
  }

  // Of a frame by name. `depth`: how many frames led to it.
  Pose frame_in_model(const XmlElement& at, const std::string& name, std::size_t depth) const {
    if (name == kModelFrame) return Pose::Identity();
    const auto found = frames_.find(name);
    if (found == frames_.end()) at.fail("no frame of this name", name);
    return pose_in_model(found->second, depth + 1);
  }

  Pose pose_in_model(const XmlElement& element, std::size_t depth) const {
    if (depth > std::min(frames_.size(), kMostRelative)) {
      element.fail(
          "frames must not be relative to each other in a circle, or more than 200 in a row");
    }
    std::string base = kModelFrame;
    if (element.name() == "joint") base = linked(element, "child");
    if (element.name() == "frame") base = element.text_or("attached_to", kModelFrame);
    const std::optional<XmlElement> pose = element.child("pose");
    if (pose) base = pose->text_or("relative_to", base);
    return frame_in_model(element, base, depth) * pose_of(element);
  }

  // In the frame of the link that URDF knows: of its joint, of the base its own.
  Pose in_link(const XmlElement& link, const XmlElement& part) const {
    Pose X_ML = pose_in_model(link, 0);
    if (const auto pose = part.child("pose"); pose && pose->has("relative_to")) {
      X_ML = frame_in_model(part, pose->text("relative_to"), 0);
    }
    return tree_frame(link.text("name")).inverse() * X_ML * pose_of(part);
  }

  Pose tree_frame(const std::string& link) const {
    const auto found = X_MT_.find(link);
    return found != X_MT_.end() ? found->second : pose_in_model(frames_.at(link), 0);
  }

  void element(const XmlElement& like, const std::string& tag, const XmlAttributes& attributes) {
    maker_.open(like, tag);
    for (const auto& [name, value] : attributes) maker_.attribute(name, value);
    maker_.close();
  }

  void origin(const XmlElement& like, const Pose& pose) {
    const Vector3 rpy = urdf_angles(pose.linear());
    element(like, "origin",
            {{"xyz", vector_text(Vector3(pose.translation()))}, {"rpy", vector_text(rpy)}});
  }

  void write_link(const XmlElement& link) {
    maker_.open(link, "link");
    maker_.attribute("name", link.text("name"));
    if (const auto inertial = link.child("inertial")) write_inertial(link, *inertial);
    for (const char* tag : {"collision", "visual"}) {
      for (const XmlElement& part : link.children(tag)) write_part(link, part);
    }
    maker_.close();
  }

  void write_inertial(const XmlElement& link, const XmlElement& inertial) {
    const std::optional<XmlElement> mass = inertial.child("mass");
    const std::optional<XmlElement> inertia = inertial.child("inertia");
    if (!mass || !inertia) return;
    maker_.open(inertial, "inertial");
    origin(inertial, in_link(link, inertial));
    element(*mass, "mass", {{"value", mass->content()}});
    XmlAttributes moments;
    for (const char* name : {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"}) {
      const std::optional<XmlElement> moment = inertia->child(name);
      const char* otherwise = name[1] == name[2] ? "1" : "0";
      moments.emplace_back(name, moment ? moment->content() : otherwise);
    }
    element(*inertia, "inertia", moments);
    maker_.close();
  }

  void write_part(const XmlElement& link, const XmlElement& part) {
    const std::vector<XmlElement> shapes = part["geometry"].children();
    if (shapes.size() != 1) part.fail("must have one shape in <geometry>");
    const XmlElement& shape = shapes.front();
    const std::string kind = shape.name();
    // Grounds and nothing.
    if (kind == "plane" || kind == "empty") return;
    maker_.open(part, part.name());
    origin(part, in_link(link, part));
    maker_.open(part["geometry"], "geometry");
    if (kind == "ellipsoid") {
      const std::vector<double> radii = shape["radii"].content_numbers();
      if (radii.size() != 3) shape.fail("radii must have three numbers");
      element(shape, kind,
              {{"a", shortest_text(radii[0])},
               {"b", shortest_text(radii[1])},
               {"c", shortest_text(radii[2])}});
    } else if (kind == "mesh") {
      if (shape.child("submesh")) shape.fail("parts of meshes cannot be read; save them alone");
      XmlAttributes attributes{{"filename", shape["uri"].content()}};
      if (const auto scale = shape.child("scale"))
        attributes.emplace_back("scale", scale->content());
      element(shape, kind, attributes);
    } else {
      XmlAttributes attributes;
      for (const char* name : {"size", "radius", "length"}) {
        if (const auto size = shape.child(name)) attributes.emplace_back(name, size->content());
      }
      element(shape, kind, attributes);
    }
    maker_.close();
    maker_.close();
  }

  void write_joint(const XmlElement& joint) {
    const std::string type = joint.text("type");
    const std::string child = linked(joint, "child");
    const std::string parent = linked(joint, "parent");
    const std::optional<XmlElement> axis = joint.child("axis");
    const std::optional<XmlElement> limit = axis ? axis->child("limit") : std::nullopt;
    const auto bound = [&](const char* name) {
      const std::optional<XmlElement> at = limit ? limit->child(name) : std::nullopt;
      return at && std::abs(at->content_number()) < kEndless ? std::optional(at->content())
                                                             : std::nullopt;
    };
    const auto lower = bound("lower");
    const auto upper = bound("upper");
    const bool endless = type == "revolute" && !lower && !upper;
    maker_.open(joint, "joint");
    maker_.attribute("name", joint.text("name"));
    maker_.attribute("type", endless ? "continuous" : type);
    element(joint, "parent", {{"link", parent}});
    element(joint, "child", {{"link", child}});
    origin(joint, tree_frame(parent).inverse() * tree_frame(child));
    if (type != "fixed" && axis) {
      element(*axis, "axis", {{"xyz", vector_text(axis_in_joint(joint, *axis))}});
      XmlAttributes limits{{"lower", lower.value_or("-inf")}, {"upper", upper.value_or("inf")}};
      for (const char* name : {"effort", "velocity"}) {
        const std::optional<XmlElement> at = limit ? limit->child(name) : std::nullopt;
        if (at) limits.emplace_back(name, at->content());
      }
      element(limit.value_or(*axis), "limit", limits);
      write_dynamics(*axis);
    }
    maker_.close();
  }

  // The link is carried by another joint already.
  void write_loop(const XmlElement& joint) {
    maker_.open(joint, "loop_joint");
    maker_.attribute("name", joint.text("name"));
    maker_.attribute("type", joint.text("type"));
    for (const auto& [tag, of] : {std::pair{"link1", "parent"}, std::pair{"link2", "child"}}) {
      const std::string link = linked(joint, of);
      const Vector3 p = tree_frame(link).inverse() * pose_in_model(joint, 0).translation();
      element(joint, tag, {{"link", link}, {"xyz", vector_text(p)}});
    }
    maker_.close();
  }

  // Before 1.5 axes are those of the model.
  Vector3 axis_in_joint(const XmlElement& joint, const XmlElement& axis) const {
    const std::optional<XmlElement> xyz = axis.child("xyz");
    if (!xyz) return Vector3::UnitZ();
    const std::vector<double> at = xyz->content_numbers();
    if (at.size() != 3) xyz->fail("must have three numbers", xyz->content());
    const std::optional<XmlElement> of_model = axis.child("use_parent_model_frame");
    const bool in_model =
        of_model ? of_model->content() == "1" || of_model->content() == "true" : is_early_;
    Matrix3 R_ME = pose_in_model(joint, 0).linear();
    if (in_model) R_ME = Matrix3::Identity();
    if (xyz->has("expressed_in")) {
      R_ME = frame_in_model(*xyz, xyz->text("expressed_in"), 0).linear();
    }
    const Vector3 v(at[0], at[1], at[2]);
    return pose_in_model(joint, 0).linear().transpose() * R_ME * v;
  }

  void write_dynamics(const XmlElement& axis) {
    if (const auto dynamics = axis.child("dynamics")) {
      XmlAttributes attributes;
      for (const char* name : {"damping", "friction"}) {
        if (const auto at = dynamics->child(name)) attributes.emplace_back(name, at->content());
      }
      element(*dynamics, "dynamics", attributes);
    }
    if (const auto mimic = axis.child("mimic")) {
      // value = multiplier * (other - reference) + offset
      const auto number = [&](const char* name, double otherwise) {
        const std::optional<XmlElement> at = mimic->child(name);
        return at ? at->content_number() : otherwise;
      };
      const double ratio = number("multiplier", 1.0);
      const double offset = number("offset", 0.0) - ratio * number("reference", 0.0);
      element(*mimic, "mimic",
              {{"joint", mimic->text("joint")},
               {"multiplier", shortest_text(ratio)},
               {"offset", shortest_text(offset)}});
    }
  }

  XmlElement root_;
  XmlElement model_;
  XmlMaker maker_;
  bool is_early_ = false;                     // before 1.5
  std::map<std::string, XmlElement> frames_;  // links, joints and frames
  std::map<std::string, Pose> X_MT_;          // of links that a joint carries
};

}  // namespace

XmlFile urdf_of_sdf(const XmlFile& file, const PackageFolders& packages) {
  const XmlFile whole = whole_sdf(file, packages);
  return SdfModel(whole).urdf();
}

}  // namespace prehend

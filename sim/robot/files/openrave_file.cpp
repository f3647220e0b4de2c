#include "sim/robot/files/openrave_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <deque>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/number_text.h"
#include "sim/base/range.h"
#include "sim/base/xml/xml_maker.h"
#include "sim/base/xml/xml_text.h"
#include "sim/robot/files/urdf_geometry.h"

namespace prehend {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr int kDeepestNamedFile = 8;         // files that name files
constexpr std::size_t kMostNamedFiles = 50;  // in all
constexpr std::size_t kMostBodies = 2000;
constexpr double kLeastNorm = 1e-9;

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_tag(const XmlElement& element, const std::string& tag) {
  return lower_case(element.name()) == tag;
}

std::vector<XmlElement> all_of(const XmlElement& element, const std::string& tag) {
  std::vector<XmlElement> found;
  for (const XmlElement& child : element.children()) {
    if (is_tag(child, tag)) found.push_back(child);
  }
  return found;
}

std::optional<XmlElement> first_of(const XmlElement& element, const std::string& tag) {
  const std::vector<XmlElement> found = all_of(element, tag);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<double> openrave_numbers(const XmlElement& element, std::size_t count) {
  std::vector<double> numbers = element.content_numbers();
  if (numbers.size() != count) {
    element.fail("must have " + std::to_string(count) + " numbers", element.content());
  }
  return numbers;
}

Vector3 openrave_vector(const XmlElement& element) {
  const std::vector<double> at = openrave_numbers(element, 3);
  const Vector3 v(at[0], at[1], at[2]);
  if (!(v.cwiseAbs().maxCoeff() <= kFarthest)) element.fail("is farther away than 1e6 m");
  return v;
}

Matrix3 openrave_rotation(const XmlElement& element) {
  if (is_tag(element, "rotationaxis")) {
    const std::vector<double> at = openrave_numbers(element, 4);
    const Vector3 axis(at[0], at[1], at[2]);
    if (!(axis.norm() > kLeastNorm)) element.fail("an axis must not be 0", element.content());
    return Eigen::AngleAxisd(at[3] * kRadPerDegree, axis.normalized()).toRotationMatrix();
  }
  if (is_tag(element, "quat")) {
    const std::vector<double> at = openrave_numbers(element, 4);
    const Eigen::Quaterniond q(at[0], at[1], at[2], at[3]);
    if (!(q.norm() > kLeastNorm && q.norm() <= kFarthest)) {
      element.fail("a quaternion must not be 0", element.content());
    }
    return q.normalized().toRotationMatrix();
  }
  const std::vector<double> at = openrave_numbers(element, 9);
  const Matrix3 R = Eigen::Map<const Matrix3>(at.data()).transpose();
  constexpr double kRotation = 1e-3;  // typed with few digits
  const double off = (R * R.transpose() - Matrix3::Identity()).norm();
  if (!(off < kRotation && R.determinant() > 0.0))
    element.fail("is no rotation", element.content());
  return Eigen::Quaterniond(R).normalized().toRotationMatrix();
}

// Translations of an element are added, and each rotation turns what those before it have turned.
Pose openrave_pose(const XmlElement& element) {
  Vector3 p = Vector3::Zero();
  Matrix3 R = Matrix3::Identity();
  for (const XmlElement& child : element.children()) {
    if (is_tag(child, "translation")) p += openrave_vector(child);
    const bool turns =
        is_tag(child, "rotationaxis") || is_tag(child, "rotationmat") || is_tag(child, "quat");
    if (turns) R = openrave_rotation(child) * R;
  }
  return pose_from(R, p);
}

bool says_yes(const std::string& text) { return lower_case(text) != "false" && text != "0"; }

struct OpenraveBody {
  std::string name;
  XmlElement element;
  std::vector<XmlElement> geometries;
  Pose X_MB = Pose::Identity();  // in the model
  std::filesystem::path meshes;  // folder of its meshes
  bool is_reached = false;       // from the first body
  Pose X_MT = Pose::Identity();  // the frame that URDF gives it
};

struct BodyJoint {
  XmlElement element;
  std::string prefix;
  std::size_t parent = 0;
  std::size_t child = 0;
  bool is_reversed = false;  // the child is named first
  bool is_used = false;      // on the way from the first body
};

class OpenraveModel {
 public:
  explicit OpenraveModel(const XmlFile& file) : maker_(file.path()) {
    const XmlElement robot = robot_of(file.root());
    name_ = robot.text_or("name", "robot");
    read(robot, "", 0);
    if (bodies_.empty()) robot.fail("has no <Body>", name_);
    root_ = robot;
  }

  XmlFile urdf() {
    reach_bodies();
    maker_.open(*root_, "robot");
    maker_.attribute("name", name_);
    for (const OpenraveBody& body : bodies_) {
      if (body.is_reached) write_body(body);
    }
    for (const BodyJoint& joint : joints_) write_joint(joint);
    for (const auto& [manipulator, prefix] : manipulators_) write_tool(manipulator, prefix);
    maker_.close();
    return maker_.finished();
  }

 private:
  static XmlElement robot_of(const XmlElement& root) {
    if (!is_tag(root, "environment")) return root;
    std::vector<XmlElement> robots = all_of(root, "robot");
    if (robots.empty()) robots = all_of(root, "kinbody");
    if (robots.empty()) root.fail("there is no <Robot> inside");
    if (robots.size() > 1) {
      robots[1].fail("there are several robots; give a file of one", robots[1].text_or("name", ""));
    }
    return robots.front();
  }

  // A robot or a body of several links, and the files that it names.
  void read(const XmlElement& element, const std::string& prefix_before, int depth) {
    const std::string prefix = prefix_before + element.text_or("prefix", "");
    if (element.has("file")) read_named_file(element, prefix, depth);
    std::filesystem::path meshes = element.file().parent_path();
    if (element.has("modelsdir")) meshes /= element.text("modelsdir");
    for (const XmlElement& child : element.children()) {
      if (is_tag(child, "kinbody") || is_tag(child, "robot")) read(child, prefix, depth);
      if (is_tag(child, "body")) read_body(child, prefix, meshes);
      if (is_tag(child, "joint")) read_joint(child, prefix);
      if (is_tag(child, "manipulator")) manipulators_.emplace_back(child, prefix);
    }
  }

  void read_named_file(const XmlElement& element, const std::string& prefix, int depth) {
    if (depth >= kDeepestNamedFile || files_.size() >= kMostNamedFiles) {
      element.fail("files name each other in a circle, or more than 8 in a row",
                   element.text("file"));
    }
    const std::filesystem::path path = element.file().parent_path() / element.text("file");
    with_field_errors(element, [&] {
      files_.emplace_back(path);
      return true;
    });
    const XmlFile& file = files_.back();
    read(robot_of(file.root()), prefix, depth + 1);
  }

  std::optional<std::size_t> find_body(const std::string& name) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (bodies_[b].name == name) return b;
    }
    return std::nullopt;
  }

  std::size_t body_named(const XmlElement& by, const std::string& prefix) const {
    const std::string name = by.content();
    if (const auto body = find_body(prefix + name)) return *body;
    if (const auto body = find_body(name)) return *body;
    by.fail("no <Body> of this name before it", name);
  }

  // A body of a name that is there already adds to it.
  void read_body(const XmlElement& element, const std::string& prefix,
                 const std::filesystem::path& meshes) {
    const std::string name = prefix + element.text("name");
    Pose X_MB = openrave_pose(element);
    if (const auto from = first_of(element, "offsetfrom")) {
      X_MB = bodies_[body_named(*from, prefix)].X_MB * X_MB;
    }
    if (const auto known = find_body(name)) {
      for (const XmlElement& part : geometries_in(element)) {
        bodies_[*known].geometries.push_back(part);
      }
      return;
    }
    if (bodies_.size() >= kMostBodies) element.fail("more than 2000 bodies", name);
    bodies_.push_back({name, element, geometries_in(element), X_MB, meshes});
  }

  static std::vector<XmlElement> geometries_in(const XmlElement& element) {
    std::vector<XmlElement> found = all_of(element, "geom");
    for (const XmlElement& other : all_of(element, "geometry")) found.push_back(other);
    return found;
  }

  void read_joint(const XmlElement& element, const std::string& prefix) {
    const std::vector<XmlElement> bodies = all_of(element, "body");
    if (bodies.size() != 2) element.fail("must name two bodies");
    joints_.push_back(
        {element, prefix, body_named(bodies[0], prefix), body_named(bodies[1], prefix)});
  }

  // From the first body on. A joint between two bodies that were reached already closes a loop.
  void reach_bodies() {
    bodies_.front().is_reached = true;
    bodies_.front().X_MT = bodies_.front().X_MB;
    std::vector<BodyJoint> ordered;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (BodyJoint& joint : joints_) {
        const bool first = bodies_[joint.parent].is_reached;
        const bool second = bodies_[joint.child].is_reached;
        if (first == second) continue;
        if (second) {
          std::swap(joint.parent, joint.child);
          joint.is_reversed = true;
        }
        OpenraveBody& child = bodies_[joint.child];
        child.is_reached = true;
        child.X_MT = child.X_MB;
        if (const auto anchor = first_of(joint.element, "anchor")) {
          child.X_MT.translation() = frame_of(joint) * openrave_vector(*anchor);
        }
        joint.is_used = true;
        ordered.push_back(joint);
        goes_on = true;
      }
    }
    for (const BodyJoint& joint : joints_) {
      if (!joint.is_used && bodies_[joint.parent].is_reached) {
        joint.element.fail(
            "closes a loop of bodies: only trees can be read, leave one joint of it out");
      }
    }
    joints_ = std::move(ordered);
  }

  // In which anchor and axis of a joint are given: of the body that it names, else of the model.
  Pose frame_of(const BodyJoint& joint) const {
    const auto from = first_of(joint.element, "offsetfrom");
    return from ? bodies_[body_named(*from, joint.prefix)].X_MB : Pose::Identity();
  }

  void element(const XmlElement& like, const std::string& tag, const XmlAttributes& attributes) {
    maker_.open(like, tag);
    for (const auto& [name, value] : attributes) maker_.attribute(name, value);
    maker_.close();
  }

  void origin(const XmlElement& like, const Pose& pose) {
    element(like, "origin",
            {{"xyz", vector_text(Vector3(pose.translation()))},
             {"rpy", vector_text(urdf_angles(pose.linear()))}});
  }

  void write_body(const OpenraveBody& body) {
    maker_.open(body.element, "link");
    maker_.attribute("name", body.name);
    const Pose X_TB = body.X_MT.inverse() * body.X_MB;
    if (const auto mass = first_of(body.element, "mass")) write_mass(*mass, X_TB);
    for (const XmlElement& geometry : body.geometries) write_geometry(body, geometry, X_TB);
    maker_.close();
  }

  // Only what the file states; what it computes from shapes is computed here as well.
  void write_mass(const XmlElement& mass, const Pose& X_TB) {
    const auto total = first_of(mass, "total");
    if (!total) return;
    const auto center = first_of(mass, "com");
    const auto inertia = first_of(mass, "inertia");
    maker_.open(mass, "inertial");
    origin(mass, X_TB * translation(center ? openrave_vector(*center) : Vector3::Zero()));
    element(*total, "mass", {{"value", total->content()}});
    const std::vector<double> m =
        inertia ? openrave_numbers(*inertia, 9) : std::vector<double>(9, 0.0);
    element(inertia.value_or(mass), "inertia",
            {{"ixx", shortest_text(m[0])},
             {"ixy", shortest_text(m[1])},
             {"ixz", shortest_text(m[2])},
             {"iyy", shortest_text(m[4])},
             {"iyz", shortest_text(m[5])},
             {"izz", shortest_text(m[8])}});
    maker_.close();
  }

  void write_geometry(const OpenraveBody& body, const XmlElement& geometry, const Pose& X_TB) {
    const std::string type = lower_case(geometry.text_or("type", "trimesh"));
    Pose X_TG = X_TB * openrave_pose(geometry);
    if (type == "cylinder") {  // theirs stand along y, those of URDF along z
      X_TG = X_TG * Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitX());
    }
    maker_.open(geometry, "collision");
    origin(geometry, X_TG);
    maker_.open(geometry, "geometry");
    if (type == "box") {
      element(geometry, "box",
              {{"size", vector_text(2.0 * openrave_vector(needed(geometry, "extents")))}});
    } else if (type == "sphere") {
      element(geometry, "sphere", {{"radius", needed(geometry, "radius").content()}});
    } else if (type == "cylinder") {
      element(geometry, "cylinder",
              {{"radius", needed(geometry, "radius").content()},
               {"length", needed(geometry, "height").content()}});
    } else if (type == "trimesh") {
      write_mesh(body, geometry);
    } else {
      geometry.fail("shapes known are box, sphere, cylinder and trimesh", type);
    }
    maker_.close();
    maker_.close();
  }

  static XmlElement needed(const XmlElement& element, const std::string& tag) {
    if (const auto found = first_of(element, tag)) return *found;
    element.fail("element <" + tag + "> is missing");
  }

  // A file name, then one factor or three; the shape for collisions before the one to be seen.
  void write_mesh(const OpenraveBody& body, const XmlElement& geometry) {
    std::optional<XmlElement> data;
    for (const char* tag : {"data", "collision", "render"}) {
      if (!data) data = first_of(geometry, tag);
    }
    if (!data) geometry.fail("names no mesh: <Data> or <Render> is missing");
    const std::string text = data->content();
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    if (end == 0) data->fail("names no file");
    const std::filesystem::path file = body.meshes / text.substr(0, end);
    std::vector<double> scale = data->numbers_in(text.substr(end), "the factors");
    if (scale.empty()) scale = {1.0};
    if (scale.size() == 1) scale = {scale[0], scale[0], scale[0]};
    if (scale.size() != 3) data->fail("must have one factor or three", text);
    element(*data, "mesh",
            {{"filename", file.string()},
             {"scale", vector_text(Vector3(scale[0], scale[1], scale[2]))}});
  }

  void write_joint(const BodyJoint& joint) {
    const XmlElement& from = joint.element;
    const std::string type = lower_case(from.text_or("type", "hinge"));
    const bool slides = type == "slider";
    if (!slides && type != "hinge") from.fail("joints known are hinge and slider", type);
    const auto [lower, upper] = limits_of(from, slides);
    const bool is_fixed = !says_yes(from.text_or("enable", "true")) && !has_mimic(from);
    const OpenraveBody& parent = bodies_[joint.parent];
    const OpenraveBody& child = bodies_[joint.child];
    maker_.open(from, "joint");
    maker_.attribute("name", joint.prefix + from.text("name"));
    const bool circular = !slides && says_yes(from.text_or("circular", "false"));
    maker_.attribute("type", is_fixed || lower == upper ? "fixed"
                             : slides                   ? "prismatic"
                             : circular                 ? "continuous"
                                                        : "revolute");
    element(from, "parent", {{"link", parent.name}});
    element(from, "child", {{"link", child.name}});
    origin(from, parent.X_MT.inverse() * child.X_MT);
    const auto axis = first_of(from, "axis");
    Vector3 along = frame_of(joint).linear() * (axis ? openrave_vector(*axis) : Vector3::UnitZ());
    if (joint.is_reversed) along = -along;
    element(from, "axis", {{"xyz", vector_text(Vector3(child.X_MT.linear().transpose() * along))}});
    write_limits(from, slides, lower, upper);
    if (has_mimic(from)) write_mimic(joint);
    maker_.close();
  }

  static bool has_mimic(const XmlElement& joint) {
    return joint.has("mimic_pos") || joint.has("mimic");
  }

  // Hinges turn half a turn to either side where nothing is said, sliders slide 10 m.
  static std::pair<double, double> limits_of(const XmlElement& joint, bool slides) {
    std::pair<double, double> limits = {-10.0, 10.0};
    if (!slides) limits = {-std::numbers::pi, std::numbers::pi};
    for (const char* tag : {"limits", "limitsrad", "limitsdeg"}) {
      const auto found = first_of(joint, tag);
      if (!found) continue;
      const std::vector<double> at = openrave_numbers(*found, 2);
      const double unit = std::string(tag) == "limitsdeg" && !slides ? kRadPerDegree : 1.0;
      limits = {unit * std::min(at[0], at[1]), unit * std::max(at[0], at[1])};
    }
    if (first_of(joint, "lostop")) {
      joint.fail("<lostop> and <histop> are obsolete: write <limitsdeg> and turn the axis round");
    }
    return limits;
  }

  void write_limits(const XmlElement& joint, bool slides, double lower, double upper) {
    XmlAttributes limits = {{"lower", shortest_text(lower)}, {"upper", shortest_text(upper)}};
    if (const auto torque = first_of(joint, "maxtorque")) {
      limits.emplace_back("effort", torque->content());
    }
    if (const auto rate = first_of(joint, "maxvel")) {
      limits.emplace_back("velocity", rate->content());
    } else if (const auto degrees = first_of(joint, "maxveldeg")) {
      const double unit = slides ? 1.0 : kRadPerDegree;
      limits.emplace_back("velocity", shortest_text(unit * degrees->content_number()));
    }
    element(joint, "limit", limits);
  }

  // "mimic" names a joint, a factor and an offset; "mimic_pos" is an expression, of which sums of
  // one joint times a number and a number are read: J, -J, 0.5*J, J*0.5+0.1.
  void write_mimic(const BodyJoint& joint) {
    const XmlElement& from = joint.element;
    std::string text = from.text(from.has("mimic_pos") ? "mimic_pos" : "mimic");
    if (!from.has("mimic_pos")) {
      const std::size_t end = std::min(text.find(' '), text.size());
      const std::vector<double> numbers = from.numbers_in(text.substr(end), "mimic");
      put_mimic(joint, text.substr(0, end), numbers.empty() ? 1.0 : numbers[0],
                numbers.size() > 1 ? numbers[1] : 0.0);
      return;
    }
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    double ratio = 1.0;
    double offset = 0.0;
    std::string leader;
    for (const std::string& term : terms_of(text)) add_term(from, term, ratio, offset, leader);
    if (leader.empty()) from.fail("mimic_pos follows no joint", text);
    put_mimic(joint, leader, ratio, offset);
  }

  // Terms with their signs: what is between + and - that stand for sums.
  static std::vector<std::string> terms_of(const std::string& text) {
    std::vector<std::string> terms(1);
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool sign = text[i] == '+' || text[i] == '-';
      const bool follows =
          i > 0 && (text[i - 1] == '*' || text[i - 1] == 'e' || text[i - 1] == 'E');
      if (sign && !terms.back().empty() && !follows) terms.emplace_back();
      if (text[i] != '+') terms.back() += text[i];
    }
    return terms;
  }

  static void add_term(const XmlElement& from, const std::string& term, double& ratio,
                       double& offset, std::string& leader) {
    std::string rest = term;
    double factor = 1.0;
    if (rest.starts_with("-")) {
      factor = -1.0;
      rest.erase(0, 1);
    }
    std::string name;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('*'), rest.size());
      const std::string part = rest.substr(0, end);
      rest.erase(0, end + 1);
      const bool is_name =
          !part.empty() &&
          (std::isalpha(static_cast<unsigned char>(part[0])) != 0 || part[0] == '_');
      if (is_name && name.empty()) {
        name = part;
      } else {
        factor *= from.number_in(part, "mimic_pos");
      }
    }
    if (name.empty()) {
      offset += factor;
    } else if (leader.empty()) {
      leader = name;
      ratio = factor;
    } else {
      from.fail("mimic_pos must follow one joint, linearly", name);
    }
  }

  void put_mimic(const BodyJoint& joint, const std::string& leader, double ratio, double offset) {
    const bool is_own = std::any_of(joints_.begin(), joints_.end(), [&](const BodyJoint& other) {
      return other.prefix + other.element.text("name") == joint.prefix + leader;
    });
    element(joint.element, "mimic",
            {{"joint", is_own ? joint.prefix + leader : leader},
             {"multiplier", shortest_text(ratio)},
             {"offset", shortest_text(offset)}});
  }

  // The frame of a manipulator, from its effector's.
  void write_tool(const XmlElement& manipulator, const std::string& prefix) {
    const auto effector = first_of(manipulator, "effector");
    if (!effector) return;
    const OpenraveBody& body = bodies_[body_named(*effector, prefix)];
    if (!body.is_reached) return;
    const std::string name = prefix + manipulator.text_or("name", "tool") + "_tcp";
    if (find_body(name)) return;
    maker_.open(manipulator, "link");
    maker_.attribute("name", name);
    maker_.close();
    maker_.open(manipulator, "joint");
    maker_.attribute("name", name + "_fixed");
    maker_.attribute("type", "fixed");
    element(manipulator, "parent", {{"link", body.name}});
    element(manipulator, "child", {{"link", name}});
    origin(manipulator, body.X_MT.inverse() * body.X_MB * openrave_pose(manipulator));
    maker_.close();
  }

  XmlMaker maker_;
  std::string name_;
  std::optional<XmlElement> root_;
  std::deque<XmlFile> files_;  // elements refer to them
  std::deque<OpenraveBody> bodies_;
  std::vector<BodyJoint> joints_;
  std::vector<std::pair<XmlElement, std::string>> manipulators_;  // with the prefix of their names
};

}  // namespace

bool is_openrave(const XmlFile& file) {
  const XmlElement root = file.root();
  if (is_tag(root, "kinbody") || is_tag(root, "environment")) return true;
  return is_tag(root, "robot") && (first_of(root, "kinbody") || root.name() == "Robot");
}

XmlFile urdf_of_openrave(const XmlFile& file) { return OpenraveModel(file).urdf(); }

}  // namespace prehend

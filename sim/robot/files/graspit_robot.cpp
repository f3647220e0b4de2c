#include "sim/robot/files/graspit_robot.h"

#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_file.h"
#include "sim/robot/closed_form.h"
#include "sim/robot/files/graspit_body.h"
#include "sim/robot/files/graspit_joint.h"
#include "sim/robot/files/graspit_notes.h"
#include "sim/robot/files/graspit_transform.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

constexpr double kShortestDirection = 1e-12;

// Reads one file into one robot: base, chains with their joints and links, degrees of freedom,
// hand.
class GraspitReader {
 public:
  explicit GraspitReader(const XmlFile& file) : root_(file.root()) {
    robot_.name = file.path().stem().string();
  }

  Robot read();

 private:
  void add_link(const XmlElement& element, std::string name, int joint);
  void read_chain(const XmlElement& element);
  void read_joints(const XmlElement& element, const Pose& X_BC, Chain& chain);
  void read_links(const XmlElement& element, const Chain& chain, const std::string& prefix);
  void read_hand();

  XmlElement root_;
  int dofs_ = 0;
  std::map<std::filesystem::path, GraspitBody> bodies_;  // links of one file share it
  Robot robot_;
};

// How many joints GraspIt! puts before a link of this type.
int joints_before(const XmlElement& link) {
  const std::string type = link.text_or("dynamicJointType", "Revolute");
  if (type == "Fixed") return 0;
  if (type == "Revolute" || type == "Prismatic") return 1;
  if (type == "Universal") return 2;
  if (type == "Ball") return 3;
  link.fail("unknown dynamicJointType, known are Revolute, Prismatic, Universal, Ball and Fixed",
            type);
}

Robot GraspitReader::read() {
  constexpr std::array<std::string_view, 8> kKnown{
      "palm",        "dof",          "chain",           "approachDirection",
      "eigenGrasps", "flockOfBirds", "virtualContacts", "gloveCalibration"};
  note_unknown(root_, kKnown, robot_.notes);
  const std::vector<XmlElement> dofs = root_.children("dof");
  if (dofs.empty()) root_.fail("a robot needs at least one <dof>");
  dofs_ = static_cast<int>(dofs.size());
  for (int d = 0; d < dofs_; ++d) robot_.dofs.push_back({.name = "d" + std::to_string(d)});
  add_link(root_["palm"], "palm", -1);
  const std::vector<XmlElement> chains = root_.children("chain");
  if (chains.empty()) root_.fail("a robot needs at least one <chain>");
  for (const XmlElement& chain : chains) read_chain(chain);
  for (int d = 0; d < dofs_; ++d) read_graspit_dof(dofs[index(d)], d, robot_);
  for (Chain& chain : robot_.chains) chain.closed_form = closed_form_of(robot_, chain);
  read_hand();
  return std::move(robot_);
}

void GraspitReader::add_link(const XmlElement& element, std::string name, int joint) {
  const std::filesystem::path file = graspit_link_file(element);
  auto known = bodies_.find(file);
  if (known == bodies_.end()) {
    GraspitBody body = with_field_errors(element, [&] { return load_graspit_body(file); });
    robot_.notes.insert(robot_.notes.end(), body.notes.begin(), body.notes.end());
    known = bodies_.emplace(file, std::move(body)).first;
  }
  const GraspitBody& body = known->second;
  robot_.links.push_back({.name = std::move(name),
                          .material = std::string(name_of(body.material)),
                          .joint = joint,
                          .mesh = body.mesh,
                          .inertial = inertial_of(body)});
}

void GraspitReader::read_chain(const XmlElement& element) {
  constexpr std::array<std::string_view, 3> kKnown{"transform", "joint", "link"};
  note_unknown(element, kKnown, robot_.notes);
  const std::string name = "chain" + std::to_string(robot_.chains.size());
  const auto transform = element.child("transform");
  Chain chain{.name = name, .first_joint = static_cast<int>(robot_.joints.size())};
  read_joints(element, transform ? read_graspit_transform(*transform) : Pose::Identity(), chain);
  robot_.chains.push_back(chain);
  read_links(element, chain, name);
}

void GraspitReader::read_joints(const XmlElement& element, const Pose& X_BC, Chain& chain) {
  const std::vector<XmlElement> joints = element.children("joint");
  if (joints.empty()) element.fail("a chain needs at least one <joint>");
  for (const XmlElement& field : joints) {
    Joint joint = read_graspit_joint(field, dofs_, robot_.notes);
    joint.name = chain.name + "_joint" + std::to_string(chain.joint_count);
    const bool first = chain.joint_count == 0;
    if (first) joint.X_PJ = X_BC;
    joint.parent = first ? -1 : static_cast<int>(robot_.joints.size()) - 1;
    joint.chain = static_cast<int>(robot_.chains.size());
    robot_.joints.push_back(std::move(joint));
    ++chain.joint_count;
  }
}

void GraspitReader::read_links(const XmlElement& element, const Chain& chain,
                               const std::string& prefix) {
  int joints = 0;
  int number = 0;
  for (const XmlElement& link : element.children("link")) {
    joints += joints_before(link);
    if (joints == 0) link.fail("a link that is fixed to the palm cannot be read");
    if (joints > chain.joint_count) {
      link.fail("the links need more joints than the " + std::to_string(chain.joint_count) +
                " of this chain");
    }
    add_link(link, prefix + "_link" + std::to_string(number++), chain.first_joint + joints - 1);
  }
  if (joints < chain.joint_count) {
    robot_.notes.push_back(note_of(element, "no link follows its last joint"));
  }
}

void GraspitReader::read_hand() {
  if (const auto approach = root_.child("approachDirection")) {
    const XmlElement direction = (*approach)["direction"];
    const Vector3 axis = graspit_vector(direction, 1.0);
    if (!(axis.norm() > kShortestDirection)) direction.fail("has no length", direction.content());
    Hand hand;
    hand.approach = axis.normalized();
    hand.closing = Vector3::Zero();
    hand.origin = graspit_vector((*approach)["referenceLocation"], kGraspitLength);
    robot_.hand = hand;
  }
  if (const auto contacts = root_.child("virtualContacts")) {
    robot_.notes.push_back(note_of(*contacts, "virtual contacts are not used"));
  }
}

}  // namespace

bool is_graspit_robot(const XmlFile& file) {
  return file.root().name() == "robot" && file.root().child("palm").has_value();
}

std::filesystem::path graspit_link_file(const XmlElement& link) {
  const std::string name = link.content();
  if (name.empty()) link.fail("names no file");
  const std::filesystem::path folder = link.file().parent_path();
  const std::filesystem::path usual = folder / "iv" / name;
  const std::filesystem::path beside = folder / name;
  return !is_file(usual) && is_file(beside) ? beside : usual;
}

Robot read_graspit_robot(const XmlFile& file) {
  if (!is_graspit_robot(file)) {
    file.root().fail("not a GraspIt! robot, which is a <robot> with a <palm>");
  }
  Robot robot = GraspitReader(file).read();
  require_sound(robot, file.path().string());
  return robot;
}

}  // namespace prehend

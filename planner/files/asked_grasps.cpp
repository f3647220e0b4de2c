#include "planner/files/asked_grasps.h"

#include <algorithm>
#include <cmath>

#include "sim/json/json_pose.h"

namespace prehend {
namespace {

Pose asked_pose(const JsonField& grasp, const CompiledScene& scene) {
  if (grasp.has("X_object_hand")) return read_pose(grasp["X_object_hand"]);
  if (grasp.has("X_world_hand")) {
    return scene.scene.object.X_WO.inverse() * read_pose(grasp["X_world_hand"]);
  }
  grasp.fail("needs X_object_hand");
}

int preshape_named(const JsonField& field, const Hand& hand) {
  const std::string name = field.text();
  std::string known;
  for (std::size_t i = 0; i < hand.preshapes.size(); ++i) {
    if (hand.preshapes[i].name == name) return static_cast<int>(i);
    known += (i > 0 ? ", " : "") + hand.preshapes[i].name;
  }
  field.fail("unknown preshape (known: " + known + ")");
}

// Degrees of freedom that reach the given joints: the farthest of their joints decides.
std::vector<double> dofs_of_joints(const std::vector<double>& joints, const Robot& hand) {
  std::vector<double> dofs;
  for (const DegreeOfFreedom& dof : hand.dofs) dofs.push_back(dof.initial);
  std::vector<bool> known(dofs.size(), false);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = hand.joints[j];
    const auto d = static_cast<std::size_t>(joint.dof);
    const double value = (joints[j] - joint.offset) / joint.ratio;
    const double v = hand.dofs[d].closing_velocity;
    if (!known[d] || (value - dofs[d]) * (v < 0.0 ? -1.0 : 1.0) > 0.0) dofs[d] = value;
    known[d] = true;
  }
  return dofs;
}

void read_posture(const JsonField& grasp, const Robot& robot, Candidate& candidate) {
  const bool named = grasp.has("preshape") && grasp["preshape"].is_text();
  if (named) {
    candidate.preshape = preshape_named(grasp["preshape"], *robot.hand);
  } else if (grasp.has("joints")) {
    candidate.joints = grasp["joints"].numbers(robot.joints.size());
    candidate.dofs = grasp.has("dofs") ? asked_dofs(grasp["dofs"], robot)
                                       : dofs_of_joints(candidate.joints, robot);
  } else if (grasp.has("dofs")) {
    candidate.dofs = asked_dofs(grasp["dofs"], robot);
  } else if (grasp.has("preshape")) {
    candidate.dofs = asked_dofs(grasp["preshape"], robot);
  } else {
    grasp.fail("needs a preshape, dofs or joints");
  }
}

std::vector<GraspContact> read_contacts(const JsonField& grasp, const CompiledScene& scene) {
  std::vector<GraspContact> contacts;
  if (!grasp.has("contacts")) return contacts;
  for (const JsonField& field : grasp["contacts"].items()) {
    GraspContact contact;
    const std::string name = field["link"].text();
    for (std::size_t l = 0; l < scene.links.size(); ++l) {
      if (scene.links[l].name == name) contact.link = link_id(l);
    }
    contact.point = {field["position"].vector3(), field["normal"].vector3(),
                     field["friction"].number()};
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace

std::vector<double> asked_dofs(const JsonField& field, const Robot& robot) {
  std::vector<double> dofs = field.numbers(robot.dofs.size());
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    const DegreeOfFreedom& dof = robot.dofs[d];
    const bool inside =
        dofs[d] >= dof.lower - kLimitTolerance && dofs[d] <= dof.upper + kLimitTolerance;
    if (!inside) field.fail(dof.name + " is outside its limits");
    dofs[d] = std::clamp(dofs[d], dof.lower, dof.upper);
  }
  return dofs;
}

AskedScene asked_scene(const JsonFile& file) {
  AskedScene asked;
  const JsonField root = file.root();
  if (root.has("scene")) {
    const JsonField scene = root["scene"];
    if (scene.is_text()) {
      asked.file = scene.text();
    } else {
      if (scene.has("file")) asked.file = scene["file"].text();
      if (scene.has("unit")) asked.unit = scene["unit"].text();
      if (scene.has("hand")) asked.hand = scene["hand"].text();
    }
  }
  if (asked.file) {
    const std::filesystem::path beside = file.path().parent_path() / *asked.file;
    if (std::filesystem::exists(beside)) asked.file = beside.string();
  }
  if (!asked.hand && root.has("hand") && root["hand"].is_text()) asked.hand = root["hand"].text();
  return asked;
}

std::vector<AskedGrasp> asked_grasps(const JsonFile& file, const CompiledScene& scene) {
  std::vector<AskedGrasp> grasps;
  for (const JsonField& field : file.root()["grasps"].items()) {
    AskedGrasp grasp;
    grasp.candidate.X_OH = asked_pose(field, scene);
    grasp.candidate.approach_O = grasp.candidate.X_OH.linear() * scene.scene.hand.hand->approach;
    read_posture(field, scene.scene.hand, grasp.candidate);
    grasp.contacts = read_contacts(field, scene);
    grasps.push_back(std::move(grasp));
  }
  return grasps;
}

}  // namespace prehend

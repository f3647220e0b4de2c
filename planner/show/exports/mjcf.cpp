#include "planner/show/exports/mjcf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "planner/show/exports/mjcf_drives.h"
#include "planner/show/exports/mjcf_geoms.h"
#include "sim/base/gravity.h"
#include "sim/base/index.h"
#include "sim/base/number_text.h"
#include "sim/base/xml/xml_text.h"
#include "sim/motion/dynamic_grasp/closing.h"
#include "sim/motion/placed_contact.h"

namespace prehend {
namespace {

// What a frame without geometry weighs, because a body that moves has to: a milligram, and a ball
// of 1 mm of that mass [kg, kg m^2].
constexpr double kFrameMass = 1e-6;
constexpr double kFrameInertia = 1e-12;

class MjcfWriter {
 public:
  MjcfWriter(const CompiledScene& scene, const MjcfShapes& shapes, const ExportGrasp& grasp,
             const MjcfOptions& options)
      : scene_(scene),
        hand_(scene.scene.hand),
        shapes_(shapes),
        grasp_(grasp),
        options_(options),
        drives_(hand_drives(hand_, options.clutches)),
        obstacles_(options.obstacles ? scene.scene.obstacles : std::vector<StaticBody>{}) {}

  std::string write();

 private:
  void name_bodies();
  std::string new_name(const std::string& wanted);
  void write_settings();
  void write_asset();
  void write_world();
  void write_object();
  void write_obstacles();
  void write_link(std::size_t link, const std::string& color);
  void write_carried(int joint);
  void write_joint(std::size_t j);
  void write_inertial(const Inertial& inertial);
  void write_contact();
  void write_equality();
  void write_keyframes();
  std::vector<double> closing_efforts() const;
  std::vector<double> bearing_efforts(const Pose& X_WH, const std::vector<double>& joints) const;
  std::vector<double> efforts_of_stage(const Closing& closing, int stage,
                                       std::vector<double> bearing) const;
  void write_key(const std::string& name, const Pose& X_WH, const std::vector<double>& joints,
                 const std::vector<double>& efforts);
  double friction(const std::string& material, Material other) const;
  double torsion(const std::string& material) const;
  double damping(std::size_t j) const;
  std::string contact_time() const { return number_text(options_.contact_time) + " 1.0"; }

  const CompiledScene& scene_;
  const Robot& hand_;
  const MjcfShapes& shapes_;
  const ExportGrasp& grasp_;
  const MjcfOptions& options_;
  HandDrives drives_;
  std::vector<StaticBody> obstacles_;
  XmlText xml_;
  std::set<std::string> names_;
  std::vector<std::string> link_names_;
  std::string object_name_;
  std::string target_name_;
  std::vector<std::string> obstacle_names_;
  std::vector<std::vector<MjcfGeom>> link_geoms_;
  std::vector<MjcfGeom> object_geoms_;
  std::vector<std::vector<MjcfGeom>> obstacle_geoms_;
  std::vector<std::size_t> joint_order_;  // as in the file
};

// `wanted`, or the first of wanted_2, wanted_3, ... that no body has.
std::string MjcfWriter::new_name(const std::string& wanted) {
  std::string name = wanted;
  for (int k = 2; !names_.insert(name).second; ++k) name = wanted + "_" + std::to_string(k);
  return name;
}

void MjcfWriter::name_bodies() {
  names_.insert("world");
  for (const Link& link : hand_.links) link_names_.push_back(new_name(link.name));
  object_name_ = new_name(scene_.scene.object.name);
  for (const StaticBody& body : obstacles_) {
    obstacle_names_.push_back(new_name(body.name));
  }
  target_name_ = new_name("hand_target");
}

// Settings with which a held object neither creeps nor sinks in (docs/reference/exports.md).
void MjcfWriter::write_settings() {
  xml_.comment("grasp " + std::to_string(grasp_.rank) + ", " + grasp_.outcome + ", epsilon " +
               number_text(grasp_.epsilon) + "; SI units");
  xml_.element("compiler", {{"angle", "radian"}, {"balanceinertia", "true"}});
  xml_.open("option", {{"timestep", number_text(options_.time_step)},
                       {"cone", "elliptic"},
                       {"impratio", "100"},
                       {"noslip_iterations", "20"}});
  xml_.element("flag", {{"multiccd", "enable"}});
  xml_.close();
  xml_.element("size", {{"nconmax", "400"}, {"njmax", "1500"}});
  xml_.open("default");
  xml_.element("geom", {{"solref", contact_time()}, {"condim", "3"}});
  xml_.element("pair", {{"solref", contact_time()}, {"condim", "3"}});
  xml_.element("equality", {{"solref", contact_time()}});
  xml_.close();
}

void MjcfWriter::write_asset() {
  xml_.open("asset");
  object_geoms_ = write_meshes(xml_, object_name_, shapes_.object);
  for (std::size_t l = 0; l < hand_.links.size(); ++l) {
    link_geoms_.push_back(write_meshes(xml_, link_names_[l], shapes_.links[l]));
  }
  for (std::size_t o = 0; o < obstacle_names_.size(); ++o) {
    obstacle_geoms_.push_back(write_meshes(xml_, obstacle_names_[o], shapes_.obstacles[o]));
  }
  xml_.close();
}

double MjcfWriter::friction(const std::string& material, Material other) const {
  return scene_.scene.friction.between(material_named(material), other);
}

// What a soft link bears as torque about the normal of a contact with the object, over the normal
// force [m].
double MjcfWriter::torsion(const std::string& material) const {
  const Material object = scene_.scene.object.material;
  return friction(material, object) *
         soft_arm(scene_.scene.compliant_depths.between(material_named(material), object));
}

void MjcfWriter::write_inertial(const Inertial& inertial) {
  if (!(inertial.mass > 0.0)) {
    xml_.element("inertial", {{"pos", "0.0 0.0 0.0"},
                              {"mass", number_text(kFrameMass)},
                              {"diaginertia", vector_text(Vector3::Constant(kFrameInertia))}});
    return;
  }
  const Matrix3& I = inertial.inertia;
  xml_.element(
      "inertial",
      {{"pos", vector_text(inertial.center_of_mass)},
       {"mass", number_text(inertial.mass)},
       {"fullinertia", numbers_text({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)})}});
}

// Of a link whose mass the robot file does not state: that of its material.
Inertial inertial_of_link(const Link& link) {
  if (link.inertial.mass > 0.0) return link.inertial;
  return inertial_of_density(link.mesh, density_of(material_named(link.material)));
}

void MjcfWriter::write_link(std::size_t link, const std::string& color) {
  write_inertial(inertial_of_link(hand_.links[link]));
  write_geoms(xml_, link_geoms_[link],
              {friction(hand_.links[link].material, scene_.scene.object.material),
               torsion(hand_.links[link].material)},
              color);
}

// The drive's speed without a load is where damping takes all its effort.
double MjcfWriter::damping(std::size_t j) const {
  const Joint& joint = hand_.joints[j];
  double speed = hand_.dofs[index(joint.dof)].max_velocity * std::abs(joint.ratio);
  if (!(speed > 0.0)) {
    speed = joint.type == JointType::prismatic ? options_.slide_speed : options_.turn_speed;
  }
  for (const HandDrive& drive : drives_.drives) {
    if (drive.joint != static_cast<int>(j)) continue;
    return std::max(joint.friction.viscous, drive.effort / speed);
  }
  return joint.friction.viscous;
}

// The body's frame is the one after the joint, at the value of the grasp (`ref`).
void MjcfWriter::write_joint(std::size_t j) {
  const Joint& joint = hand_.joints[j];
  const bool slides = joint.type == JointType::prismatic;
  const Pose X_AJ = joint.X_JA.inverse();
  XmlAttributes attributes = {
      {"name", joint.name},
      {"type", slides ? "slide" : "hinge"},
      {"pos", vector_text(Vector3(slides ? Vector3::Zero() : Vector3(X_AJ.translation())))},
      {"axis", vector_text(Vector3(X_AJ.linear() * joint.axis))},
      {"limited", "true"},
      {"range", numbers_text({joint.lower, std::max(joint.upper, joint.lower + 1e-9)})},
      {"solreflimit", contact_time()},
      {"ref", number_text(grasp_.closed_joints[j])},
      {"damping", number_text(damping(j))},
      {"frictionloss", number_text(joint.friction.coulomb)},
      {"armature", number_text(std::max(slides ? options_.slide_inertia : options_.turn_inertia,
                                        damping(j) * options_.drive_time))}};
  if (joint.spring.stiffness > 0.0) {
    attributes.emplace_back("stiffness", number_text(joint.spring.stiffness));
    attributes.emplace_back("springref", number_text(joint.spring.rest));
  }
  xml_.element("joint", attributes);
  joint_order_.push_back(j);
}

// The links that follow `joint` and the joints behind it, inside the body that is open. The first
// link of a joint is its body, others are bodies without a joint.
void MjcfWriter::write_carried(int joint) {
  const std::string color = "0.45 0.5 0.58 1.0";
  bool first = true;
  for (std::size_t l = 0; l < hand_.links.size(); ++l) {
    if (hand_.links[l].joint != joint) continue;
    if (!first) xml_.open("body", {{"name", link_names_[l]}});
    write_link(l, color);
    if (!first) xml_.close();
    first = false;
  }
  if (first) write_inertial({});
  for (std::size_t j = 0; j < hand_.joints.size(); ++j) {
    const Joint& next = hand_.joints[j];
    if (next.parent != joint) continue;
    const auto link = std::find_if(hand_.links.begin(), hand_.links.end(),
                                   [&](const Link& of) { return of.joint == static_cast<int>(j); });
    const std::string name = link == hand_.links.end()
                                 ? new_name(next.name)
                                 : link_names_[index(static_cast<int>(link - hand_.links.begin()))];
    const Pose X = next.X_PJ * across(next, grasp_.closed_joints[j]);
    xml_.open("body", {{"name", name},
                       {"pos", vector_text(Vector3(X.translation()))},
                       {"quat", quaternion_text(X)}});
    write_joint(j);
    write_carried(static_cast<int>(j));
    xml_.close();
  }
}

void MjcfWriter::write_object() {
  const GraspableBody& object = scene_.scene.object;
  xml_.open("body", {{"name", object_name_},
                     {"pos", vector_text(Vector3(object.X_WO.translation()))},
                     {"quat", quaternion_text(object.X_WO)}});
  xml_.element("freejoint", {});
  write_inertial({object.mass, object.center_of_mass, object.inertia});
  write_geoms(xml_, object_geoms_, {}, "0.85 0.72 0.5 1.0");
  xml_.close();
}

void MjcfWriter::write_obstacles() {
  for (std::size_t o = 0; o < obstacle_names_.size(); ++o) {
    const StaticBody& body = obstacles_[o];
    xml_.open("body", {{"name", obstacle_names_[o]},
                       {"pos", vector_text(Vector3(body.X_WB.translation()))},
                       {"quat", quaternion_text(body.X_WB)}});
    write_geoms(xml_, obstacle_geoms_[o],
                {scene_.scene.friction.between(body.material, scene_.scene.object.material)},
                "0.6 0.6 0.6 1.0");
    xml_.close();
  }
}

void MjcfWriter::write_world() {
  const XmlAttributes at = {{"pos", vector_text(Vector3(grasp_.X_WH.translation()))},
                            {"quat", quaternion_text(grasp_.X_WH)}};
  const auto named = [&](XmlAttributes attributes, const std::string& name) {
    attributes.insert(attributes.begin(), {"name", name});
    return attributes;
  };
  xml_.open("worldbody");
  xml_.element("light", {{"pos", "0 0 3"}, {"directional", "true"}});
  XmlAttributes target = named(at, target_name_);
  target.emplace_back("mocap", "true");
  xml_.element("body", target);
  xml_.open("body", named(at, link_names_.front()));
  xml_.element("freejoint", {});
  write_carried(-1);
  xml_.close();
  write_object();
  write_obstacles();
  xml_.close();
}

// Links that are not checked for collision with each other do not touch. Pairs without the object
// are written out where the larger of the two coefficients against the object is not theirs.
void MjcfWriter::write_contact() {
  std::set<std::pair<std::size_t, std::size_t>> checked;
  for (const LinkPair& pair : scene_.self_pairs) {
    checked.emplace(std::minmax(index(pair.a), index(pair.b)));
  }
  const Material object = scene_.scene.object.material;
  xml_.open("contact");
  for (std::size_t a = 0; a < hand_.links.size(); ++a) {
    const std::string& of = hand_.links[a].material;
    const double own = friction(of, object);
    for (std::size_t b = a + 1; b < hand_.links.size(); ++b) {
      if (!checked.contains({a, b})) {
        xml_.element("exclude", {{"body1", link_names_[a]}, {"body2", link_names_[b]}});
        continue;
      }
      const std::string& other = hand_.links[b].material;
      const double meant = friction(of, material_named(other));
      if (meant != std::max(own, friction(other, object))) {
        write_pairs(xml_, link_geoms_[a], link_geoms_[b], meant);
      }
    }
    for (std::size_t o = 0; o < obstacle_names_.size(); ++o) {
      const Material other = obstacles_[o].material;
      const double meant = friction(of, other);
      if (meant != std::max(own, scene_.scene.friction.between(other, object))) {
        write_pairs(xml_, link_geoms_[a], obstacle_geoms_[o], meant);
      }
    }
  }
  xml_.close();
}

void MjcfWriter::write_equality() {
  xml_.open("equality");
  xml_.element("weld",
               {{"name", target_name_}, {"body1", target_name_}, {"body2", link_names_.front()}});
  write_couplings(xml_, hand_, drives_);
  xml_.close();
}

// Of the joints that have a drive which closes; 0 for the others.
std::vector<double> MjcfWriter::closing_efforts() const {
  std::vector<double> efforts(hand_.joints.size(), 0.0);
  for (const HandDrive& drive : drives_.drives) efforts[index(drive.joint)] = drive.closing;
  return efforts;
}

// Of the joints that have a drive: what bears the weight of all links that move with it, so that an
// open hand stays as open as it is.
std::vector<double> MjcfWriter::bearing_efforts(const Pose& X_WH,
                                                const std::vector<double>& joints) const {
  std::vector<Pose> X_HA;
  joint_poses(hand_, joints, X_HA);
  const Vector3 down_H = -X_WH.linear().transpose() * Vector3::UnitZ();
  std::vector<double> efforts(hand_.joints.size(), 0.0);
  for (const Link& link : hand_.links) {
    const Inertial inertial = inertial_of_link(link);
    const Vector3 weight_H = kStandardGravity * inertial.mass * down_H;
    for (int j = link.joint; j >= 0; j = hand_.joints[index(j)].parent) {
      const Pose X_HJ = X_HA[index(j)] * hand_.joints[index(j)].X_JA.inverse();
      const Vector3 axis_H = X_HJ.linear() * hand_.joints[index(j)].axis;
      const bool slides = hand_.joints[index(j)].type == JointType::prismatic;
      const Vector3 arm_H = X_HA[index(link.joint)] * inertial.center_of_mass - X_HJ.translation();
      efforts[index(j)] -= axis_H.dot(slides ? weight_H : Vector3(arm_H.cross(weight_H)));
    }
  }
  const std::vector<double> own = efforts;
  const auto add = [&](const HandCoupling& coupling) {
    efforts[index(coupling.leader)] += coupling.ratio * own[index(coupling.joint)];
  };
  for (const HandCoupling& coupling : drives_.couplings) add(coupling);
  for (const HandClutch& clutch : drives_.clutches) add(clutch.follows);
  return efforts;
}

// Of a stage before everything closes with its largest effort: what waits bears its weight.
std::vector<double> MjcfWriter::efforts_of_stage(const Closing& closing, int stage,
                                                 std::vector<double> bearing) const {
  for (const HandDrive& drive : drives_.drives) {
    const double part = closing.effort_in(stage, index(hand_.joints[index(drive.joint)].dof));
    if (part > 0.0) bearing[index(drive.joint)] = part * drive.closing;
  }
  return bearing;
}

// `efforts` of the joints whose drives close; others are told where to be.
void MjcfWriter::write_key(const std::string& name, const Pose& X_WH,
                           const std::vector<double>& joints, const std::vector<double>& efforts) {
  std::vector<double> qpos;
  const auto add_pose = [&](const Pose& pose) {
    const Eigen::Quaterniond q = quaternion_of(pose).normalized();
    const Vector3 p = pose.translation();
    qpos.insert(qpos.end(), {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
  };
  add_pose(X_WH);
  for (const std::size_t j : joint_order_) qpos.push_back(joints[j]);
  add_pose(scene_.scene.object.X_WO);
  std::vector<double> ctrl;
  for (const HandDrive& drive : drives_.drives) {
    ctrl.push_back((drive.closing != 0.0 ? efforts : joints)[index(drive.joint)]);
  }
  xml_.element("key", {{"name", name},
                       {"qpos", numbers_text(qpos)},
                       {"ctrl", numbers_text(ctrl)},
                       {"mpos", vector_text(Vector3(X_WH.translation()))},
                       {"mquat", quaternion_text(X_WH)}});
}

void MjcfWriter::write_keyframes() {
  std::vector<double> open = grasp_.pregrasp_joints;
  for (const HandCoupling& coupling : drives_.couplings) {
    const double way = open[index(coupling.leader)] - grasp_.closed_joints[index(coupling.leader)];
    open[index(coupling.joint)] =
        grasp_.closed_joints[index(coupling.joint)] + coupling.ratio * way;
  }
  const Vector3 approach_W = scene_.scene.object.X_WO.linear() * grasp_.approach_O;
  const Pose X_WP = translation(-grasp_.approach_distance * approach_W) * grasp_.X_WH;
  xml_.open("keyframe");
  write_key("grasp", grasp_.X_WH, grasp_.closed_joints, closing_efforts());
  write_key("pregrasp", X_WP, open, bearing_efforts(X_WP, open));
  const Closing closing(hand_, grasp_.strategy);
  for (int stage = 0; stage < closing.stages(); ++stage) {
    write_key("closing_" + std::to_string(stage + 1), grasp_.X_WH, open,
              efforts_of_stage(closing, stage, bearing_efforts(grasp_.X_WH, open)));
  }
  xml_.close();
}

std::string MjcfWriter::write() {
  name_bodies();
  xml_.open("mujoco", {{"model", hand_.name + " holding " + object_name_}});
  write_settings();
  write_asset();
  write_world();
  write_contact();
  write_equality();
  write_clutches(xml_, hand_, drives_, contact_time());
  write_actuators(xml_, hand_, drives_);
  write_keyframes();
  xml_.close();
  return xml_.text();
}

}  // namespace

std::string mjcf_file_name(int rank) { return "grasp_" + std::to_string(rank) + ".xml"; }

std::string mjcf_text(const CompiledScene& scene, const MjcfShapes& shapes,
                      const ExportGrasp& grasp, const MjcfOptions& options) {
  return MjcfWriter(scene, shapes, grasp, options).write();
}

}  // namespace prehend

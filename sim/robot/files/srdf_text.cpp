#include "sim/robot/files/srdf_text.h"

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/number_text.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {
namespace {

// Group, joints and start of one robot.
void write_group(const Robot& robot, const std::string& group, XmlText& xml) {
  xml.open("group", {{"name", group}});
  for (const Joint& joint : robot.joints) xml.element("joint", {{"name", joint.name}});
  xml.close();
  xml.open("group_state", {{"name", "ready"}, {"group", group}});
  const std::vector<double> values = joint_values(robot, initial_dofs(robot));
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    xml.element("joint", {{"name", robot.joints[j].name}, {"value", shortest_text(values[j])}});
  }
  xml.close();
}

}  // namespace

std::string srdf_text(const SphereModel& model) {
  XmlText xml;
  xml.open("robot", {{"name", model.name}});
  for (std::size_t r = 0; r < model.robots.size(); ++r) {
    const Robot& robot = model.robots[r];
    if (robot.joints.empty()) continue;
    const std::string group = model.robots.size() > 1 ? robot.name : model.name;
    write_group(robot, group, xml);
    if (robot.hand && r > 0) {
      xml.element(
          "end_effector",
          {{"name", group + "_end"}, {"parent_link", robot.links.front().name}, {"group", group}});
    }
  }
  for (const SphereModel::Pair& pair : model.unchecked) {
    xml.element("disable_collisions", {{"link1", model.links[index(pair.a)].name},
                                       {"link2", model.links[index(pair.b)].name},
                                       {"reason", pair.adjacent ? "Adjacent" : "Never"}});
  }
  for (const SphereLink& link : model.links) {
    if (link.spheres.empty()) continue;
    xml.comment(formatted("beyond the mesh by at most %.1f mm", 1e3 * link.error));
    xml.open("link_sphere_approximation", {{"link", link.name}});
    for (const CoverSphere& sphere : link.spheres) {
      xml.element("sphere", {{"center", vector_text(sphere.center_M)},
                             {"radius", formatted("%.6g", sphere.radius)}});
    }
    xml.close();
  }
  xml.close();
  return "<?xml version=\"1.0\"?>\n" + xml.text();
}

}  // namespace prehend

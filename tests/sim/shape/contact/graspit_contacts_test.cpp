// GraspIt!'s own hand and objects at poses and joint values where GraspIt! reported contacts.
#include <algorithm>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/robot/files/graspit_body.h"
#include "sim/robot/files/graspit_robot.h"
#include "sim/shape/contact/surface_contact.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

using Json = nlohmann::json;

Vector3 numbers_of(const Json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

Pose pose_of(const Json& pose) {
  const Json& q = pose["quat_wxyz"];
  const Eigen::Quaterniond rotation(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                                    q[3].get<double>());
  return translation(0.001 * numbers_of(pose["t_mm"])) * Pose(rotation.normalized());
}

// GraspIt! calls surfaces within 0.1 mm touching, and takes corners of the overlap of triangles
// that do so, where the gap may be a little larger.
constexpr ContactOptions kAsGraspIt{.threshold = 1.2e-4};

struct TouchedLink {
  std::string link;
  Vector3 position;  // object frame [m]
};

// All contact points of the links with the object, where the file puts the hand.
std::vector<TouchedLink> contacts_at(const Json& reference, const Robot& hand,
                                     const GraspitBody& object, const ContactOptions& options) {
  const Pose X_OH =
      pose_of(reference["object_pose_world"]).inverse() * pose_of(reference["hand_pose_world"]);
  std::vector<Pose> X_HL;
  link_poses(hand, reference["hand_joints_rad_or_mm"].get<std::vector<double>>(), X_HL);
  const ProximityMesh body(object.mesh);
  ContactWorkspace workspace;
  std::vector<TouchedLink> all;
  for (std::size_t l = 0; l < hand.links.size(); ++l) {
    std::vector<SurfaceContact> contacts;
    find_contact_points(body, ProximityMesh(hand.links[l].mesh), X_OH * X_HL[l], options, workspace,
                        contacts);
    const std::string name = l == 0 ? "unnamedBase" : "unnamed_" + hand.links[l].name;
    for (const SurfaceContact& contact : contacts) all.push_back({name, contact.position});
  }
  return all;
}

std::set<std::string> links_of(const std::vector<TouchedLink>& touched) {
  std::set<std::string> links;
  for (const TouchedLink& contact : touched) links.insert(contact.link);
  return links;
}

// The distance to the nearest contact of the same link [m].
double nearest_to(const TouchedLink& contact, const std::vector<TouchedLink>& others) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const TouchedLink& other : others) {
    if (other.link != contact.link) continue;
    nearest = std::min(nearest, (other.position - contact.position).norm());
  }
  return nearest;
}

TEST(GraspitContacts, AreOnTheSameLinksAndWithinAMillimetre) {
  PREHEND_NEEDS_SHARED("reference/graspit");
  PREHEND_NEEDS_SHARED("data/robots/graspit");
  PREHEND_NEEDS_SHARED("data/graspit_objects");
  const Robot hand = read_graspit_robot(
      XmlFile(test::shared("data/robots/graspit/models/robots/Barrett/Barrett.xml")));
  std::size_t all = 0;
  std::ptrdiff_t near = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::shared("reference/graspit"))) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream stream(entry.path());
    const Json reference = Json::parse(stream);
    if (reference["hand"] != "Barrett") continue;
    SCOPED_TRACE(entry.path().filename());
    const std::string name = reference["object"];
    const GraspitBody object =
        load_graspit_body(test::shared("data/graspit_objects/graspit_" + name + ".xml"));
    std::vector<TouchedLink> its;
    for (const Json& contact : reference["contacts"]) {
      its.push_back({contact["link"], 0.001 * numbers_of(contact["position_mm"])});
    }
    EXPECT_EQ(links_of(contacts_at(reference, hand, object, {})), links_of(its));
    const std::vector<TouchedLink> own = contacts_at(reference, hand, object, kAsGraspIt);
    EXPECT_EQ(links_of(own), links_of(its));
    all += its.size();
    near += std::count_if(its.begin(), its.end(), [&](const TouchedLink& contact) {
      return nearest_to(contact, own) < 1e-3;
    });
  }
  EXPECT_EQ(all, 43u);
  EXPECT_GE(static_cast<double>(near), 0.85 * static_cast<double>(all));
}

}  // namespace
}  // namespace prehend

// Spheres, names and pairs beside the URDF of the same robot, read by other readers.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

#include "sim/base/index.h"
#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/srdf_text.h"
#include "sim/robot/files/urdf_text.h"
#include "sim/robot/files/xrdf_text.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

using test::test_folder;
using test::write_text;

// The robot with its URDF in a folder.
struct Written {
  std::filesystem::path folder;
  SphereModel model;
  std::set<std::string> links;
  std::set<std::string> joints;  // that mimic none
};

Written written(const std::string& robot) {
  const Platform platform = find_platform(robot);
  Written result{test_folder(), sphere_model(platform), {}, {}};
  for (const RobotTextFile& file : urdf_text(platform, "made.urdf")) {
    write_text(result.folder / file.name, file.content);
  }
  const XmlFile urdf(result.folder / "made.urdf");
  for (const XmlElement& link : urdf.root().children("link")) {
    result.links.insert(link.text("name"));
  }
  for (const XmlElement& joint : urdf.root().children("joint")) {
    if (joint.text("type") == "fixed" || !joint.children("mimic").empty()) continue;
    result.joints.insert(joint.text("name"));
  }
  return result;
}

TEST(Xrdf, HasTheNamesOfTheUrdfAndSpheresAroundItsMeshes) {
  for (const char* robot : {"panda", "ur5e_2f85", "barrett"}) {
    SCOPED_TRACE(robot);
    const Written made = written(robot);
    const YAML::Node file = YAML::Load(xrdf_text(made.model));
    EXPECT_EQ(file["format"].as<std::string>(), "xrdf");
    std::set<std::string> joints;
    for (const auto& name : file["cspace"]["joint_names"]) joints.insert(name.as<std::string>());
    EXPECT_EQ(joints, made.joints);
    EXPECT_EQ(file["cspace"]["acceleration_limits"].size(), joints.size());
    EXPECT_EQ(file["cspace"]["jerk_limits"].size(), joints.size());
    EXPECT_EQ(file["default_joint_positions"].size(), joints.size());
    for (const auto& [link, others] :
         file["self_collision"]["ignore"].as<std::map<std::string, std::vector<std::string>>>()) {
      EXPECT_TRUE(made.links.contains(link)) << link;
      for (const std::string& other : others) EXPECT_TRUE(made.links.contains(other)) << other;
    }
    const YAML::Node geometry = file["geometry"][file["collision"]["geometry"].as<std::string>()];
    int meshes = 0;
    for (const auto& entry : geometry["spheres"]) {
      const auto link = entry.first.as<std::string>();
      ASSERT_TRUE(made.links.contains(link)) << link;
      const TriangleMesh mesh =
          load_mesh(made.folder / "made_meshes" / (link + ".obj"), {.metres_per_unit = 1.0}).mesh;
      for (const Vector3& p : mesh.vertices) {
        ASSERT_TRUE(std::any_of(entry.second.begin(), entry.second.end(),
                                [&](const auto& sphere) {
                                  const auto c =
                                      sphere["center"].template as<std::vector<double>>();
                                  return (p - Vector3(c[0], c[1], c[2])).norm() <=
                                         sphere["radius"].template as<double>();
                                }))
            << link << " " << p.transpose();
      }
      ++meshes;
    }
    EXPECT_GE(meshes, 5);
  }
}

TEST(Srdf, IsReadBackBesideTheUrdf) {
  const Platform platform = find_platform("panda");
  const Written made = written("panda");
  write_text(made.folder / "made.srdf", srdf_text(made.model));
  const Platform again = load_platform(made.folder / "made.urdf");
  ASSERT_EQ(again.robots.size(), 2U);
  for (const MountedRobot& mounted : again.robots) {
    for (const std::string& note : mounted.robot.notes) {
      EXPECT_EQ(note.find("srdf"), std::string::npos) << note;
    }
  }
  EXPECT_EQ(again.robots[1].robot.links.size(), platform.robots[1].robot.links.size());
  const std::vector<double> start = initial_dofs(platform);
  const std::vector<double> read = initial_dofs(again);
  ASSERT_EQ(read.size(), start.size());
  for (std::size_t d = 0; d < start.size(); ++d) EXPECT_NEAR(read[d], start[d], 1e-5);
}

// Links that a robot exempts are said to never collide, not to be neighbours.
TEST(Srdf, TellsNeighboursFromLinksThatNeverCollide) {
  Platform platform = find_platform("ur5e");
  Robot& robot = platform.robots[0].robot;
  robot.exempt_pairs = {{0, 4}};
  const SphereModel model = sphere_model(platform);
  const auto pair_of = [&](int a, int b) {
    return *std::find_if(model.unchecked.begin(), model.unchecked.end(),
                         [&](const SphereModel::Pair& pair) { return pair.a == a && pair.b == b; });
  };
  EXPECT_TRUE(pair_of(0, 1).adjacent);
  EXPECT_FALSE(pair_of(0, 4).adjacent);
  EXPECT_NE(srdf_text(model).find("reason=\"Never\""), std::string::npos);
}

}  // namespace
}  // namespace prehend

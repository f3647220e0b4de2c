#include "sim/robot/files/foreign_robot.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_file.h"
#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/graspit_robot.h"
#include "sim/robot/files/graspit_world_robots.h"
#include "sim/robot/files/hand_split.h"
#include "sim/robot/files/mjcf_file.h"
#include "sim/robot/files/openrave_file.h"
#include "sim/robot/files/robot_sidecar.h"
#include "sim/robot/files/sdf_file.h"
#include "sim/robot/files/srdf_file.h"
#include "sim/robot/files/urdf_file.h"
#include "sim/robot/files/xacro_file.h"

namespace prehend {
namespace {

bool looks_like_xml(const std::string& text) {
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // a byte order mark
  while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
  return at < text.size() && text[at] == '<';
}

// Beside NAME.urdf: NAME.srdf.
std::filesystem::path srdf_of(const std::filesystem::path& file,
                              const ForeignRobotOptions& options) {
  if (!options.srdf.empty()) return options.srdf;
  std::filesystem::path beside = file;
  beside.replace_extension(".srdf");
  return is_file(beside) ? beside : std::filesystem::path();
}

int link_of_name(const JointTree& tree, const std::string& name,
                 const std::filesystem::path& sidecar) {
  for (std::size_t l = 0; l < tree.links.size(); ++l) {
    if (tree.links[l].name == name) return static_cast<int>(l);
  }
  throw InputError({sidecar.string(), "hand_root", "no link of this name", name});
}

// Where the hand begins, as the sidecar or the SRDF file say or as it is inferred, with a note.
std::optional<int> hand_of_tree(JointTree& tree, const std::optional<RobotSidecar>& sidecar,
                                const std::optional<int>& of_srdf) {
  const auto note = [&](int link, const std::string& why) {
    tree.notes.push_back("the hand begins with link " + tree.links[index(link)].name + why);
    return link;
  };
  if (const auto said = sidecar ? sidecar->hand_root() : std::nullopt) {
    if (said->empty()) return std::nullopt;
    const std::filesystem::path file = RobotSidecar::path_beside(tree.file);
    const int link = link_of_name(tree, *said, file);
    if (!can_be_parted(tree, link)) {
      throw InputError(
          {file.string(), "hand_root", "no hand can be parted from the rest here", *said});
    }
    return link;
  }
  if (of_srdf && can_be_parted(tree, *of_srdf)) {
    return note(*of_srdf, ", as the SRDF file says; what carries it is the arm");
  }
  const std::optional<int> inferred = inferred_hand(tree);
  if (!inferred) return std::nullopt;
  return note(*inferred, ", on which several joints branch; what carries it is taken as the arm");
}

// Where several chains end, their last links are taken for fingertips, which hands have of rubber.
void assume_materials(Robot& robot) {
  std::vector<bool> last(robot.joints.size(), true);
  for (const Joint& joint : robot.joints) {
    if (joint.parent >= 0) last[index(joint.parent)] = false;
  }
  if (std::count(last.begin(), last.end(), true) < 2) {
    robot.notes.push_back("materials are not in the file: all links count as plastic");
    return;
  }
  for (Link& link : robot.links) {
    if (link.joint >= 0 && last[index(link.joint)]) link.material = "rubber";
  }
  robot.notes.push_back(
      "materials are not in the file: last links count as rubber, all others as plastic");
}

Platform platform_of(JointTree tree, double scale, const std::filesystem::path& srdf,
                     const std::optional<RobotSidecar>& sidecar) {
  (void)root_of(tree);
  if (scale != 1.0) {
    scale_lengths(tree, scale);
    tree.notes.push_back(formatted("all lengths of the file are multiplied by %g", scale));
  }
  std::optional<int> of_srdf;
  if (!srdf.empty()) of_srdf = read_srdf(XmlFile(srdf), tree);
  if (sidecar) sidecar->complete(tree);
  const std::optional<int> hand = hand_of_tree(tree, sidecar, of_srdf);
  Platform platform;
  if (hand) {
    platform = parted(tree, *hand);
  } else {
    platform.name = tree.name;
    platform.robots.push_back({.name = tree.name, .robot = to_robot(tree)});
  }
  if (sidecar) {
    sidecar->complete(platform);
  } else {
    assume_materials(platform.robots.back().robot);
  }
  return platform;
}

// A GraspIt! robot, which is one whole; the sidecar may say more of it.
Platform graspit_platform(const XmlFile& xml, const std::optional<RobotSidecar>& sidecar) {
  Platform platform;
  Robot robot = read_graspit_robot(xml);
  platform.name = robot.name;
  platform.robots.push_back({.name = platform.name, .robot = std::move(robot)});
  if (sidecar) sidecar->complete(platform);
  return platform;
}

}  // namespace

bool has_foreign_robot_name(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".urdf" || extension == ".sdf" || extension == ".xacro" ||
         extension == ".world" || extension == ".mjcf" || extension == ".xml";
}

std::optional<Platform> read_foreign_robot(const std::filesystem::path& file,
                                           const ForeignRobotOptions& options) {
  const std::string text = read_file(file);
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) {
    throw InputError({.file = file.string(), .problem = "the text is UTF-16, save it as UTF-8"});
  }
  if (!looks_like_xml(text)) return std::nullopt;
  const XmlFile written(file, text);
  const std::filesystem::path beside = RobotSidecar::path_beside(file);
  std::optional<RobotSidecar> sidecar;
  if (is_file(beside)) sidecar.emplace(beside);
  const ForeignRobotOptions all = sidecar ? sidecar->options(options) : options;
  std::optional<XmlFile> expanded;
  if (has_xacro(written)) expanded = expanded_xacro(written, all);
  const XmlFile& xml = expanded ? *expanded : written;
  const std::string kind = xml.root().name();
  if (is_openrave(xml)) {
    return platform_of(read_urdf(urdf_of_openrave(xml), all), all.scale, srdf_of(file, all),
                       sidecar);
  }
  if (is_graspit_robot(xml) || kind == "world") {
    if (all.scale != 1.0) xml.root().fail("robots of GraspIt! are in mm and cannot be scaled");
    return kind == "world" ? read_graspit_platform(xml) : graspit_platform(xml, sidecar);
  }
  if (kind == "robot") {
    return platform_of(read_urdf(xml, all), all.scale, srdf_of(file, all), sidecar);
  }
  if (kind == "sdf") {
    return platform_of(read_urdf(urdf_of_sdf(xml, all.packages), all), all.scale,
                       srdf_of(file, all), sidecar);
  }
  if (kind == "mujoco") return platform_of(read_mjcf(xml), all.scale, {}, sidecar);
  xml.root().fail(
      "no robot that can be read; known are URDF (<robot>), MJCF (<mujoco>), SDF (<sdf>), OpenRAVE "
      "(<Robot>, <KinBody>), GraspIt! robots (<robot> with <palm>) and worlds (<world>)");
}

Robot robot_alone(Platform platform) {
  Robot robot = std::move(platform.robots.back().robot);
  if (platform.robots.size() > 1) {
    robot.notes.push_back("of " + platform.name + " the hand is used alone, without its arm");
  }
  return robot;
}

}  // namespace prehend

// Robots on robots: the one robot that they are together against each of them on its own.
#include "sim/robot/platform.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/inverse_kinematics.h"
#include "tests/sim/robot/files/reference_robot.h"
#include "tests/sim/robot/files/robot_files.h"

namespace prehend {
namespace {

// Rounding of a chain of a few metres and a dozen joints.
constexpr double kMountRounding = 1e-12;

MountedRobot child(const char* name, int parent, int chain, const Pose& X_MR) {
  MountedRobot mounted;
  mounted.name = name;
  mounted.robot = test::load_robot_json(test::small_robot());
  mounted.parent = parent;
  mounted.chain = chain;
  mounted.X_MR = X_MR;
  return mounted;
}

// trunk: two chains, of which "arm" carries left, and "finger" right, which carries leaf.
Platform small_tree() {
  Random random(5);
  Platform platform;
  platform.name = "tree";
  platform.robots = {child("trunk", -1, 0, Pose::Identity()), child("left", 0, 0, random.pose(0.3)),
                     child("right", 0, 1, random.pose(0.3)), child("leaf", 2, 0, random.pose(0.3))};
  platform.robots[2].mount = {.name = "plate",
                              .material = "wood",
                              .joint = -1,
                              .mesh = platform.robots[0].robot.links[0].mesh};
  return platform;
}

std::vector<double> random_dofs(const Robot& robot, Random& random) {
  std::vector<double> dofs;
  for (const DegreeOfFreedom& dof : robot.dofs) {
    // A base that can roll 100 m away is asked for no more than a room.
    dofs.push_back(random.uniform(dof.lower, std::min(dof.upper, dof.lower + 5.0)));
  }
  return dofs;
}

std::vector<double> dofs_of(const AssembledPlatform& whole, const Platform& platform,
                            std::size_t part, const std::vector<double>& dofs) {
  const auto first = dofs.begin() + whole.parts[part].first_dof;
  return {first, first + static_cast<std::ptrdiff_t>(platform.robots[part].robot.dofs.size())};
}

// The frame that carries each robot, before its own mount pose: parents' joint poses, one after the
// other.
struct ByHand {
  std::vector<Pose> X_BM;  // the frame that carries the robot
  std::vector<Pose> X_BR;  // its base
  std::vector<std::vector<Pose>> X_RL;
};

ByHand chained(const Platform& platform, const AssembledPlatform& whole,
               const std::vector<double>& dofs) {
  ByHand by_hand;
  std::vector<std::vector<Pose>> X_RJ;
  for (std::size_t r = 0; r < platform.robots.size(); ++r) {
    const MountedRobot& mounted = platform.robots[r];
    Pose X_BM = Pose::Identity();
    if (mounted.parent >= 0) {
      const std::size_t p = index(mounted.parent);
      const Chain& chain = platform.robots[p].robot.chains[index(mounted.chain)];
      const int last = chain.first_joint + chain.joint_count - 1;
      X_BM = by_hand.X_BR[p] * X_RJ[p][index(last)];
    }
    const std::vector<double> own = joint_values(mounted.robot, dofs_of(whole, platform, r, dofs));
    X_RJ.emplace_back();
    joint_poses(mounted.robot, own, X_RJ.back());
    by_hand.X_RL.emplace_back();
    link_poses(mounted.robot, own, by_hand.X_RL.back());
    by_hand.X_BM.push_back(X_BM);
    by_hand.X_BR.push_back(X_BM * mounted.X_MR);
  }
  return by_hand;
}

void expect_same_points(const TriangleMesh& a, const Pose& X_a, const TriangleMesh& b,
                        const Pose& X_b, const std::string& name) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size()) << name;
  double farthest = 0.0;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    farthest = std::max(farthest, (X_a * a.vertices[v] - X_b * b.vertices[v]).norm());
  }
  EXPECT_LT(farthest, 10.0 * kMountRounding) << name;
}

// Every vertex of every link, mounts too, is where the robots on their own have it.
void expect_chained(const Platform& platform, std::uint64_t seed) {
  const AssembledPlatform whole = assemble(platform);
  Random random(seed);
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> dofs = random_dofs(whole.robot, random);
    const std::vector<Pose> X_BL = test::poses_at(whole.robot, dofs);
    const ByHand by_hand = chained(platform, whole, dofs);
    for (std::size_t r = 0; r < platform.robots.size(); ++r) {
      const MountedRobot& mounted = platform.robots[r];
      const std::size_t first = index(whole.parts[r].first_link);
      for (std::size_t l = 0; l < mounted.robot.links.size(); ++l) {
        const Link& link = mounted.robot.links[l];
        expect_same_points(whole.robot.links[first + l].mesh, X_BL[first + l], link.mesh,
                           by_hand.X_BR[r] * by_hand.X_RL[r][l], link.name);
      }
      if (!mounted.mount) continue;
      expect_same_points(whole.robot.links[first - 1].mesh, X_BL[first - 1], mounted.mount->mesh,
                         by_hand.X_BM[r], mounted.mount->name);
    }
  }
}

TEST(Assemble, LinksAreWhereTheRobotsOnTheirOwnHaveThem) {
  expect_chained(find_platform("obelix"), 21);
  expect_chained(find_platform("puma560_barrett"), 22);
}

TEST(Assemble, ChildrenOnTwoChainsOfOneParentAndAGrandchild) { expect_chained(small_tree(), 23); }

TEST(Assemble, NamesAreThoseOfRobotAndPart) {
  const Platform platform = small_tree();
  const Robot whole = assemble(platform).robot;
  std::vector<std::string> links;
  std::vector<std::string> joints;
  std::vector<std::string> dofs;
  for (const MountedRobot& mounted : platform.robots) {
    if (mounted.mount) links.push_back(mounted.name + "/plate");
    for (const char* link : {"foot", "upper", "fore", "tip"})
      links.push_back(mounted.name + "/" + link);
    for (const char* joint : {"shoulder", "elbow", "slide"}) {
      joints.push_back(mounted.name + "/" + joint);
    }
    for (const char* dof : {"bend", "grip"}) dofs.push_back(mounted.name + "/" + dof);
  }
  const auto names = [](const auto& all) {
    std::vector<std::string> result;
    for (const auto& one : all) result.push_back(one.name);
    return result;
  };
  EXPECT_EQ(names(whole.links), links);
  EXPECT_EQ(names(whole.joints), joints);
  EXPECT_EQ(names(whole.dofs), dofs);
}

// The robot that a link belongs to, by its name.
std::string owner(const Link& link) { return link.name.substr(0, link.name.find('/')); }

// Moves one degree of freedom and expects the links of `moved` to move as one body, by more than
// rounding, and those of `still` not at all.
void expect_rigid(const Robot& robot, const std::string& dof, const std::vector<std::string>& moved,
                  const std::vector<std::string>& still) {
  Random random(31);
  std::vector<double> dofs = random_dofs(robot, random);
  const std::vector<Pose> before = test::poses_at(robot, dofs);
  const auto which = std::find_if(robot.dofs.begin(), robot.dofs.end(),
                                  [&](const auto& one) { return one.name == dof; });
  ASSERT_NE(which, robot.dofs.end()) << dof;
  const auto d = static_cast<std::size_t>(which - robot.dofs.begin());
  dofs[d] = which->lower + 0.9 * (dofs[d] - which->lower);
  const std::vector<Pose> after = test::poses_at(robot, dofs);
  const auto contains = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  std::optional<Pose> motion;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const Pose moved_by = after[l] * before[l].inverse();
    const std::string part = owner(robot.links[l]);
    if (contains(moved, part)) {
      if (!motion) motion = moved_by;
      EXPECT_TRUE(moved_by.isApprox(*motion, kMountRounding)) << dof << ' ' << robot.links[l].name;
    } else if (contains(still, part)) {
      EXPECT_TRUE(moved_by.isApprox(Pose::Identity(), kMountRounding)) << robot.links[l].name;
    }
  }
  ASSERT_TRUE(motion.has_value());
  EXPECT_FALSE(motion->isApprox(Pose::Identity(), 1e-4)) << dof;
}

TEST(Assemble, WhatAnAncestorCarriesMovesWithItAsOneBody) {
  const Robot tree = assemble(small_tree()).robot;
  expect_rigid(tree, "trunk/bend", {"left"}, {"right", "leaf"});
  expect_rigid(tree, "trunk/grip", {"right", "leaf"}, {"left"});
  expect_rigid(tree, "right/bend", {"leaf"}, {"trunk", "left"});
  const Robot obelix = assemble(find_platform("obelix")).robot;
  for (const char* dof : {"base/x", "base/y", "base/yaw"}) {
    expect_rigid(obelix, dof, {"arm"}, {});
  }
}

// Carried links in the frame of the robot that carries them.
std::vector<Pose> seen_from(const Pose& X_BR, const std::vector<Pose>& X_BL, std::size_t first) {
  std::vector<Pose> seen;
  for (std::size_t l = first; l < X_BL.size(); ++l) seen.push_back(X_BR.inverse() * X_BL[l]);
  return seen;
}

TEST(Assemble, AnInnerRobotIsPlacedByTheJointsBeforeItAlone) {
  const AssembledPlatform obelix = assemble(find_platform("obelix"));
  const Robot& robot = obelix.robot;
  const PlatformPart& arm = obelix.parts[1];
  Random random(41);
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> start = random_dofs(robot, random);
    const std::vector<double> asked = random_dofs(robot, random);
    const auto arm_base = [&](const std::vector<double>& dofs) {
      std::vector<Pose> X_BJ;
      joint_poses(robot, joint_values(robot, dofs), X_BJ);
      return Pose(X_BJ[index(arm.joint)] * arm.X_JR);
    };
    const auto all = solve_all(robot, {{arm.joint, arm.X_JR, arm_base(asked)}}, start);
    ASSERT_FALSE(all.empty()) << i;
    const DofValues& found = all.front();
    test::expect_same_pose(arm_base(found), arm_base(asked), 1e-8);
    for (std::size_t d = index(arm.first_dof); d < start.size(); ++d) {
      EXPECT_EQ(found[d], start[d]) << robot.dofs[d].name;
    }
    const auto first = index(arm.first_link);
    const auto before = seen_from(arm_base(start), test::poses_at(robot, start), first);
    const auto after = seen_from(arm_base(found), test::poses_at(robot, found), first);
    for (std::size_t l = 1; l < before.size();
         ++l) {  // the base link's mesh is in its joint's frame
      EXPECT_TRUE(after[l].isApprox(before[l], 1e-9)) << robot.links[first + l].name;
    }
  }
}

// The small tree's first three robots as a file beside small.json.
nlohmann::json tree_file() {
  return nlohmann::json::parse(R"({
    "name": "tree",
    "units": {"length": "mm", "angle": "deg"},
    "robots": [
      {"name": "trunk", "robot": "platform_small.json"},
      {"name": "left", "robot": "platform_small.json",
       "on": {"robot": "trunk", "chain": "arm", "pose": [{"translate": [0, 0, 10]}]}},
      {"name": "right", "robot": "platform_small.json",
       "on": {"robot": "trunk", "chain": "finger"},
       "mount": {"name": "plate", "material": "wood",
                 "geometry": [{"shape": "box", "size": [5, 5, 5]}]}}]
  })");
}

std::filesystem::path write_tree(const nlohmann::json& tree) {
  const std::filesystem::path file = test::write_robot_text(tree.dump(1));
  std::ofstream(file.parent_path() / "platform_small.json") << test::small_robot().dump(1);
  return file;
}

TEST(PlatformFile, ReadsRobotsBesideItInItsOwnUnits) {
  const Platform platform = load_platform(write_tree(tree_file()));
  ASSERT_EQ(platform.robots.size(), 3U);
  EXPECT_EQ(platform.robots[1].parent, 0);
  EXPECT_EQ(platform.robots[1].chain, 0);
  EXPECT_EQ(platform.robots[2].chain, 1);
  EXPECT_NEAR(platform.robots[1].X_MR.translation().z(), 0.01, 1e-15);
  ASSERT_TRUE(platform.robots[2].mount.has_value());
  EXPECT_NEAR(bounds(platform.robots[2].mount->mesh).upper.x(), 0.0025, 1e-15);
  EXPECT_THROW(hand_of(platform), InputError);  // all three are hands
}

// The file with one field changed (removed when `value` is "REMOVE").
struct BadTree {
  const char* label;
  const char* pointer;
  const char* value;
  const char* complaint;
};

void PrintTo(const BadTree& bad, std::ostream* stream) { *stream << bad.label; }

class BadPlatformFile : public testing::TestWithParam<BadTree> {};

TEST_P(BadPlatformFile, IsRefusedInOneLineThatNamesFileFieldAndValue) {
  nlohmann::json tree = tree_file();
  const nlohmann::json::json_pointer pointer(GetParam().pointer);
  if (GetParam().value == std::string("REMOVE")) {
    tree.at(pointer.parent_pointer()).erase(pointer.back());
  } else {
    tree[pointer] = nlohmann::json::parse(GetParam().value);
  }
  const std::filesystem::path file = write_tree(tree);
  try {
    (void)load_platform(file);
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.rfind(file.string() + ": " + GetParam().complaint, 0), 0U) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, BadPlatformFile,
    testing::Values(
        BadTree{"UnknownRobot", "/robots/1/robot", R"("tentacle")",
                "robots[1].robot: neither a file nor one of allegro, "},
        BadTree{
            "OnALaterOne", "/robots/1/on/robot", R"("right")",
            R"(robots[1].on.robot: must be the name of a robot that stands before it ("right"))"},
        BadTree{
            "OnItself", "/robots/1/on/robot", R"("left")",
            R"(robots[1].on.robot: must be the name of a robot that stands before it ("left"))"},
        BadTree{"UnknownChain", "/robots/2/on/chain", R"("leg")",
                R"(robots[2].on.chain: no chain of this name in small ("leg"))"},
        BadTree{"NameTwice", "/robots/2/name", R"("left")",
                R"(robots[2].name: name used twice ("left"))"},
        BadTree{"SecondStandsOnNothing", "/robots/1/on", "REMOVE",
                R"(robots[1]: every robot but the first needs "on")"},
        BadTree{"UnknownField", "/robots/1/colour", R"("red")",
                "robots[1].colour: unknown field, known here are name, robot, on, mount"},
        BadTree{"UnknownFieldOfOn", "/robots/1/on/joint", "3", "robots[1].on.joint: unknown field"},
        BadTree{"UnknownTopField", "/chain", "3", "chain: unknown field"},
        BadTree{"NoName", "/name", "REMOVE", "name: must be given"},
        BadTree{"NoRobot", "/robots/0/robot", "REMOVE", "robots[0].robot: must be given"},
        BadTree{"NoChain", "/robots/1/on/chain", "REMOVE", "robots[1].on.chain: must be given"},
        BadTree{"NoRobots", "/robots", "[]", "robots: a platform needs at least one robot ([])"},
        BadTree{"RobotsIsNoList", "/robots", "3", "robots: must be a list (3)"},
        BadTree{"UnknownUnit", "/units/length", R"("furlong")", "units.length: "},
        BadTree{"EmptyMount", "/robots/2/mount/geometry", "[]", "robots[2].mount.geometry: "},
        BadTree{"MountOfNothing", "/robots/2/mount/material", "REMOVE",
                "robots[2].mount.material: must be given"}),
    [](const auto& bad) { return std::string(bad.param.label); });

}  // namespace
}  // namespace prehend

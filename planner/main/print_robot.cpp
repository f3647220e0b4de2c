#include "planner/main/print_robot.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "planner/main/print_notes.h"
#include "planner/main/printed_units.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/robot/hand/fingers.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// What the file says of the joint's drive, friction and spring; no line where it says nothing.
void print_drive(const Joint& joint) {
  const bool turns = joint.type == JointType::revolute;
  const JointFriction& friction = joint.friction;
  const bool springs = joint.spring.stiffness > 0.0;
  if (joint.max_effort == 0.0 && friction.coulomb == 0.0 && friction.viscous == 0.0 && !springs) {
    return;
  }
  const char* separator = "";
  std::printf("%29s", "");
  if (joint.max_effort > 0.0) {
    std::printf("effort up to %.4g %s", joint.max_effort, turns ? "N m" : "N");
    separator = ", ";
  }
  if (friction.coulomb > 0.0) {
    std::printf("%sCoulomb friction %.4g %s", separator, friction.coulomb, turns ? "N m" : "N");
    separator = ", ";
  }
  if (friction.viscous > 0.0) {
    std::printf("%sviscous friction %.4g %s", separator, friction.viscous,
                turns ? "N m s/rad" : "N s/m");
    separator = ", ";
  }
  if (springs) {
    std::printf("%sspring %.4g %s about %.4g", separator, joint.spring.stiffness,
                turns ? "N m/rad" : "N/m", joint.spring.rest);
  }
  std::printf("\n");
}

// The gains that the file states; no line where it states none.
void print_gains(const Robot& robot, std::size_t dof) {
  const DegreeOfFreedom& motion = robot.dofs[dof];
  if (!motion.stiffness && !motion.damping) return;
  const bool turns = std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) {
    return joint.dof == static_cast<int>(dof) && joint.type == JointType::revolute;
  });
  std::printf("%29sgains:", "");
  if (motion.stiffness) {
    std::printf(" stiffness %.4g %s%s", *motion.stiffness, turns ? "N m/rad" : "N/m",
                motion.damping ? "," : "");
  }
  if (motion.damping) {
    std::printf(" damping %.4g %s", *motion.damping, turns ? "N m s/rad" : "N s/m");
  }
  std::printf("\n");
}

void print_parts(const Robot& robot) {
  std::printf("robot %s: %zu links, %zu joints, %zu degrees of freedom\n", robot.name.c_str(),
              robot.links.size(), robot.joints.size(), robot.dofs.size());
  for (const Joint& joint : robot.joints) {
    std::printf("  joint %-20s %-9s limits %9.4f to %9.4f, driven by %s x %.4g\n",
                joint.name.c_str(), joint.type == JointType::revolute ? "revolute" : "prismatic",
                joint.lower, joint.upper,
                robot.dofs[static_cast<std::size_t>(joint.dof)].name.c_str(), joint.ratio);
    print_drive(joint);
  }
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const DegreeOfFreedom& dof = robot.dofs[d];
    std::printf("  dof   %-20s from %9.4f to %9.4f, closes at %g\n", dof.name.c_str(), dof.lower,
                dof.upper, dof.closing_velocity);
    print_gains(robot, d);
  }
  for (const Link& link : robot.links) {
    const Vector3 size = kMillimetres * bounds(link.mesh).size();
    const Vector3 center = kMillimetres * link.inertial.center_of_mass;
    std::printf(
        "  link  %-20s %-8s %3zu triangles, %.1f x %.1f x %.1f mm, %.4g kg about (%.1f, %.1f, "
        "%.1f) "
        "mm%s\n",
        link.name.c_str(), link.material.c_str(), link.mesh.triangles.size(), size.x(), size.y(),
        size.z(), link.inertial.mass, center.x(), center.y(), center.z(),
        check_mesh(link.mesh).solid() ? "" : ", not a closed solid");
  }
}

void print_hand(const InspectedRobot& inspected) {
  if (!inspected.no_hand.empty()) std::printf("  no hand: %s\n", inspected.no_hand.c_str());
  if (!inspected.robot.hand) return;
  const Hand& hand = *inspected.robot.hand;
  const Vector3 origin = kMillimetres * hand.origin;
  std::printf(
      "  hand  approaches along (%.3f, %.3f, %.3f), closes along (%.3f, %.3f, %.3f), "
      "aims with (%.1f, %.1f, %.1f) mm\n",
      hand.approach.x(), hand.approach.y(), hand.approach.z(), hand.closing.x(), hand.closing.y(),
      hand.closing.z(), origin.x(), origin.y(), origin.z());
  double aperture = 0.0;
  for (const Preshape& preshape : hand.preshapes) {
    std::printf("  preshape %-17s holds %.0f to %.0f mm, fingers meet at %.0f mm%s\n",
                preshape.name.c_str(), kMillimetres * preshape.min_width,
                kMillimetres * preshape.max_width, kMillimetres * preshape.depth,
                inspected.derived ? " (derived)" : "");
    aperture = std::max(aperture, preshape.max_width);
  }
  for (const ClosingStrategy& strategy : hand.strategies) {
    std::printf("  strategy %s\n", strategy.name.c_str());
  }
  std::printf("  aperture %.0f mm\n", kMillimetres * aperture);
}

// Of the pairs that collide, the most frequent ones.
void print_collisions(const Robot& robot, const PostureSurvey& survey) {
  constexpr std::size_t kMostPairs = 5;
  const auto percent = [&](int postures) { return 100.0 * postures / survey.postures; };
  std::printf("  self-collision in %.1f %% of %d random postures\n", percent(survey.colliding),
              survey.postures);
  for (std::size_t k = 0; k < std::min(kMostPairs, survey.pairs.size()); ++k) {
    const CollidingLinks& pair = survey.pairs[k];
    std::printf("    %s and %s: %.1f %%\n", robot.links[index(pair.first)].name.c_str(),
                robot.links[index(pair.second)].name.c_str(), percent(pair.postures));
  }
  if (survey.pairs.size() > kMostPairs) {
    std::printf("    and %zu other pairs\n", survey.pairs.size() - kMostPairs);
  }
}

void print_workspace(const PostureSurvey& survey) {
  for (const TipWorkspace& tip : survey.tips) {
    if (tip.points.empty()) continue;
    const Vector3 lower = kMillimetres * tip.box.lower;
    const Vector3 upper = kMillimetres * tip.box.upper;
    std::printf(
        "  reach of %s: x %.0f to %.0f, y %.0f to %.0f, z %.0f to %.0f mm, at most %.0f mm "
        "from the base\n",
        tip.name.c_str(), lower.x(), upper.x(), lower.y(), upper.y(), lower.z(), upper.z(),
        kMillimetres * tip.farthest);
  }
}

}  // namespace

InspectedRobot inspected(const Robot& robot) {
  InspectedRobot result{robot, false, "", {}};
  const bool has_fingers = !find_hand_parts(robot).fingers.empty();
  const bool states_all = robot.hand && !robot.hand->preshapes.empty();
  if (!states_all && (robot.hand || has_fingers)) {
    try {
      result.robot = with_hand(robot);
      result.derived = true;
    } catch (const InputError& error) {
      result.no_hand = error.what();
    }
  }
  result.survey = survey_postures(result.robot);
  return result;
}

void print_robot(const InspectedRobot& inspected) {
  print_parts(inspected.robot);
  print_hand(inspected);
  print_collisions(inspected.robot, inspected.survey);
  print_workspace(inspected.survey);
}

void print_platform(const Platform& platform, const std::vector<InspectedRobot>& robots) {
  if (platform.robots.size() > 1) {
    std::printf("platform %s: %zu robots\n", platform.name.c_str(), platform.robots.size());
  }
  for (std::size_t r = 0; r < platform.robots.size(); ++r) {
    const MountedRobot& mounted = platform.robots[r];
    if (mounted.parent >= 0) {
      const MountedRobot& parent = platform.robots[static_cast<std::size_t>(mounted.parent)];
      const Vector3 p = kMillimetres * mounted.X_MR.translation();
      std::printf("%s on %s, chain %s, at (%.1f, %.1f, %.1f) mm: ", mounted.name.c_str(),
                  parent.name.c_str(),
                  parent.robot.chains[static_cast<std::size_t>(mounted.chain)].name.c_str(), p.x(),
                  p.y(), p.z());
    }
    print_robot(robots[r]);
    print_notes(mounted.robot);
  }
}

}  // namespace prehend

// Invalid grasps and the messages with which they are refused: the last table of
// tests/sim/quality/oracle/extremes.md.
#pragma once

#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "sim/base/input_error.h"
#include "sim/quality/epsilon.h"
#include "tests/support/extreme_grasps.h"

namespace prehend::test {

struct RefusedGrasp {
  std::string name;
  std::string message;  // of the exception
  Contacts contacts;
  WrenchFrame frame;
  int edges = 8;
  EpsilonOptions options = {};
};

// As in messages.
inline std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

// Grasps of four contacts whose second one is invalid, which contact_wrenches refuses.
inline std::vector<RefusedGrasp> refused_contacts() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<RefusedGrasp> refused;
  const auto add = [&](const std::string& name, const Contact& contact,
                       const std::string& message) {
    RefusedGrasp grasp{name, "contacts[1]." + message, tetrahedron(), {}};
    grasp.contacts[1] = contact;
    refused.push_back(grasp);
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const ContactModel soft_finger = ContactModel::soft_finger;
  add("position NaN", {{nan, 0.0, 0.0}, x, 0.5}, "position: not finite (nan, 0, 0)");
  add("position infinite", {{0.0, infinity, 0.0}, x, 0.5}, "position: not finite (0, inf, 0)");
  add("position 1.01e6 m away", {{0.0, -1.01e6, 0.0}, x, 0.5},
      "position: must be within 1e+06 m of 0 (0, -1.01e+06, 0)");
  add("normal NaN", {zero, {0.0, 0.0, nan}, 0.5}, "normal: not finite (0, 0, nan)");
  add("normal infinite", {zero, {-infinity, 0.0, 0.0}, 0.5}, "normal: not finite (-inf, 0, 0)");
  add("normal of length 0", {zero, zero, 0.5}, "normal: not unit (0, 0, 0)");
  add("normal of length 0.9989", {zero, 0.9989 * x, 0.5}, "normal: not unit (0.9989, 0, 0)");
  add("normal of length 1.0011", {zero, 1.0011 * x, 0.5}, "normal: not unit (1.0011, 0, 0)");
  add("normal of length 1e200", {zero, 1e200 * x, 0.5}, "normal: not unit (1e+200, 0, 0)");
  const std::string range = ": must be from 0 to 1e+06 ";
  for (const auto& [text, value] : {std::pair("NaN", nan), std::pair("infinite", infinity),
                                    std::pair("-1e-9", -1e-9), std::pair("1.01e6", 1.01e6)}) {
    const std::string shown = range + "(" + number(value) + ")";
    add(std::string("friction ") + text, {zero, x, value}, "friction" + shown);
    add(std::string("torsion ") + text, {zero, x, 0.5, soft_finger, value}, "torsion" + shown);
  }
  return refused;
}

// All invalid input: contacts, frames and options.
inline std::vector<RefusedGrasp> refused_grasps() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Contacts four = tetrahedron();
  const std::string scale = "torque_scale: must be from 1e-09 to 1e+09 ";
  const std::string edges = "edges: of a friction pyramid: must be from 3 to 1024 ";
  std::vector<RefusedGrasp> refused = refused_contacts();
  const std::vector<RefusedGrasp> others = {
      {"torque origin NaN", "torque_origin: not finite (0, nan, 0)", four, {{0.0, nan, 0.0}, 1.0}},
      {"torque origin infinite",
       "torque_origin: not finite (inf, 0, 0)",
       four,
       {{infinity, 0.0, 0.0}, 1.0}},
      {"torque scale 0", scale + "(0)", four, {.torque_scale = 0.0}},
      {"torque scale -1", scale + "(-1)", four, {.torque_scale = -1.0}},
      {"torque scale NaN", scale + "(nan)", four, {.torque_scale = nan}},
      {"torque scale infinite", scale + "(inf)", four, {.torque_scale = infinity}},
      {"pyramids of 2 edges", edges + "(2)", four, {}, 2},
      {"pyramids of -1 edges", edges + "(-1)", four, {}, -1},
      {"pyramids of 1,025 edges", edges + "(1025)", four, {}, 1025},
      {"torque scale 1e-10", scale + "(1e-10)", four, {.torque_scale = 1e-10}},
      {"torque scale 1e10", scale + "(1e+10)", four, {.torque_scale = 1e10}},
      {"torque origin 1e200 m away",
       "torque_origin: must be within 1e+06 m of 0 (1e+200, 0, 0)",
       four,
       {{1e200, 0.0, 0.0}, 1.0}},
      {"tolerance -1", "relative_tolerance: must be at least 0 (-1)", four, {}, 8, {-1.0}},
      {"tolerance NaN", "relative_tolerance: must be at least 0 (nan)", four, {}, 8, {nan}},
  };
  refused.insert(refused.end(), others.begin(), others.end());
  return refused;
}

// The message of the exception when epsilon of the grasp is computed, "" without one.
inline std::string refusal(const RefusedGrasp& grasp) {
  try {
    epsilon_l1(contact_wrenches(grasp.contacts, grasp.frame, grasp.edges), grasp.options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace prehend::test

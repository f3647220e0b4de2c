// The simulators that are asked whether a grasp survives a protocol: a column each in the table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/shake/mujoco_shake.h"
#include "benchmarks/shake/shake_cases.h"
#include "sim/manipulation/test_procedure.h"

namespace prehend::bench {

// What can be changed in our simulator.
struct OwnRun {
  double step = 1.0;     // times that of the protocol
  bool locks = true;     // gears behind clutches keep fingers from being pushed back
  bool clutches = true;  // else the joints of fingers that break away move as one from the grasp on
  double opened = 0.0;   // the hand starts a part of the way from the grasp to its preshape
};

// What can be changed in MuJoCo's.
struct MujocoRun {
  double step = 1.0;  // times that of exported models, and so the time in which contacts push
  // Fingers that break away have their clutches and gears; else, as in exported models, their
  // joints move as one from the grasp on.
  bool clutches = false;
  StartOptions start = {};
};

// Throws InputError for a world that cannot be stepped.
ShakeResult in_prehend(const ShakeCase& shaken, const ShakenGrasp& grasp,
                       const TestProcedure& procedure, const OwnRun& run = {});
ShakeResult in_mujoco(const ShakeCase& shaken, const ShakenGrasp& grasp,
                      const TestProcedure& procedure, const MujocoRun& run = {});

// What in_mujoco steps.
struct MujocoCase {
  std::string mjcf;
  ShakeSubject subject;
};

MujocoCase mujoco_case(const ShakeCase& shaken, const ShakenGrasp& grasp,
                       const TestProcedure& procedure, const MujocoRun& run = {});

struct Opinion {
  std::string name;
  std::function<ShakeResult(const ShakeCase&, const ShakenGrasp&, const TestProcedure&)> shake;
};

std::vector<Opinion> opinions();

}  // namespace prehend::bench

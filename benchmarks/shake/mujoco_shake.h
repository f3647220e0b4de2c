// Protocols carried out in MuJoCo.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/shake/mujoco_world.h"
#include "benchmarks/shake/shake_result.h"
#include "sim/scene/compiled_scene.h"

namespace prehend::bench {

// What protocols ask of a hand and an object.
struct ShakeSubject {
  Matrix3 R_HG = Matrix3::Identity();  // the axes of ProcedureFrame::hand in the hand's base frame
  double volume = 0.0;                 // of the object [m^3]
  double longest_edge = 0.0;           // of the object's bounds [m]
  std::vector<JointLock> locks = {};   // of the hand
  Robot hand = {};
  ClosingStrategy strategy = {};
};

ShakeSubject subject_of(const CompiledScene& scene);

// Carries out the protocol on a model of mjcf_text, with the time step of the model, which its
// contacts are made for. On a support the model must have the scene's obstacles, else none. Throws
// InputError for a model that MuJoCo refuses.
ShakeResult shake_in_mujoco(const std::string& mjcf, const TestProcedure& procedure,
                            const ShakeSubject& subject, const StartOptions& start = {});

}  // namespace prehend::bench

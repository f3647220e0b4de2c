#include "sim/trial/approach_line.h"

#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"
#include "sim/trial/trial.h"

namespace prehend {

// The hand moved back by the travel: from there the approach leads straight to X_OH. For a hand
// that centring has moved sideways the whole line is moved with it.
HandLine approach_line(const CompiledScene& scene, const Candidate& candidate, const Trial& trial) {
  const Pose X_OH = hand_in_scene(trial);
  HandLine line{translation(-trial.travel * candidate.approach_O) * X_OH, X_OH, {}};
  start_joints(scene.scene.hand, candidate, line.hand_joints);
  return line;
}

}  // namespace prehend

// Grasps of hands with suction cups, and what is lifted of them.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/suction/suction_picks.h"
#include "benchmarks/suction/suction_world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend::bench {

struct SuctionCase {
  std::string object;
  std::string hand;
  CompiledScene scene;
  std::vector<TriangleMesh> pieces;  // of the object, convex
  std::vector<Trial> grasps;
};

// Grasps of a plan on the object of a mesh file, at most so many: from the one whose approach
// passes nearest to the centre of mass to the one that passes farthest from it. `pieces` are those
// of the object, made here where there are none yet. Throws InputError.
SuctionCase suction_case(const std::string& mesh, const std::string& hand, int trials,
                         std::size_t most, std::vector<TriangleMesh>& pieces);

// A grasp with a weight on it.
struct SuctionPick {
  std::string object;
  std::string hand;
  HungAttitude attitude = HungAttitude::as_it_lies;
  // How many times the weight the cups hold, as payload_margin says (LoadCase::strength).
  double margin = 0.0;
  // The same for lips that are elastic however far they are bent.
  double elastic_margin = 0.0;
  double strain = 0.0;  // of the lip, the largest
  HangingObject hanging;
};

// The mass is such that the margin is about the wanted one.
SuctionPick suction_pick(const SuctionCase& of, const Trial& grasp, HungAttitude attitude,
                         double wanted_margin);

}  // namespace prehend::bench

// A grasp to be carried out, as a file for simulators that are not linked here.
#pragma once

#include <string>

#include "benchmarks/shake/opinions.h"

namespace prehend::bench {

struct CarryName {
  std::string hand;
  std::string object;
  std::string of;  // the list of grasps
  int rank = 1;
  bool predicted = false;  // whether closing on a free object keeps it
  bool survived = false;   // in the MuJoCo that is linked
};

// Writes FOLDER/HAND-OBJECT-OF-RANK.json: the name, the model, what closes the hand (Closing), and
// for each phase of the procedure's only test where the base is, as an offset in the world from
// where it began, after each step of the model [m]. Phases must not turn the base. Throws
// InputError where the file can't be written.
void write_carry_file(const std::string& folder, const CarryName& name, const MujocoCase& model,
                      const TestProcedure& procedure);

}  // namespace prehend::bench

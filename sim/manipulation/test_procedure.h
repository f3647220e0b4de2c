// A protocol: what is done to a grasp to see whether it holds, as data.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"
#include "sim/base/pose.h"
#include "sim/motion/step_options.h"

namespace prehend {

// What happens during a phase. Motions are of the hand's base; axes are given in ProcedureFrame.
enum class PhaseKind {
  settle,    // nothing moves but the object, until it rests or the time is over
  approach,  // the hand moves straight along its approach by `distance`, from rest to rest
  close,     // the hand closes until its drives are at their effort limits
  hold,      // the hand stands still; `acceleration` is that of gravity or of a pull
  lift,      // the hand rises by `height`, from rest to rest
  circle,  // the hand moves on a horizontal circle of `amplitude` [m], `frequency` rounds a second
  swing,   // the hand moves along `axis` by +-`amplitude` [m], sinusoidal
  turn,    // the hand turns about `axis` through its origin by +-`amplitude` [rad], sinusoidal
  open,    // the hand opens to its preshape
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(PhaseKind /*of*/) {
  return std::to_array<std::string_view>(
      {"settle", "approach", "close", "hold", "lift", "circle", "swing", "turn", "open"});
}

// The axes in which a direction is given: of the world; of the object as the grasp has it at the
// start; or of the hand, with z its approach and x the direction in which it closes.
enum class ProcedureFrame { world, object, hand };

constexpr auto enum_names(ProcedureFrame /*of*/) {
  return std::to_array<std::string_view>({"world", "object", "hand"});
}

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// When a phase counts as failed. Motions of the object are measured in the hand's base frame, from
// the beginning of the phase; what is not said is no reason to fail.
struct PhaseLimits {
  double moved = kNoLimit;    // of the centre of mass, farther than this [m]
  double turned = kNoLimit;   // by more than this [rad]
  double dropped = kNoLimit;  // the object sinks in the world by more than this [m]
  double least_rise =
      0.0;  // the object rises in the world by less than this; 0: does not matter [m]
  bool loses_contact = false;  // no link touches the object at the end
  // The object is still within this way below the hand at the end: it should have fallen; 0: does
  // not matter [m].
  double least_fall = 0.0;
};

struct ProcedurePhase {
  PhaseKind kind = PhaseKind::hold;
  double duration = 0.0;  // > 0 [s]
  // Acceleration that acts on the object alone, as a force at its centre of mass [m/s^2].
  Vector3 pull = Vector3::Zero();
  bool pull_grows = false;  // from nothing to `pull` at the end of the phase, instead of at once
  // Gravity during the phase instead of the protocol's [m/s^2].
  std::optional<Vector3> gravity = {};
  ProcedureFrame frame = ProcedureFrame::world;  // of pull, gravity and axis
  Vector3 axis = Vector3::UnitZ();               // unit
  double amplitude = 0.0;                        // m or rad
  double frequency = 0.0;                        // Hz
  double height = 0.0;                           // of a lift [m]
  double distance = 0.0;                         // of an approach [m]
  double height_in_edges = 0.0;  // at least so many of the object's longest edges, if that is more
  PhaseLimits fails = {};
};

// A test: phases one after the other, from the grasp as it is after the protocol's preparation.
struct ProcedureTest {
  std::string name;
  std::vector<ProcedurePhase> phases;
};

// What a protocol says of the object instead of the scene.
struct ProcedureObject {
  std::optional<double> mass;     // > 0 [kg]
  std::optional<double> density;  // > 0; of the volume its surface bounds [kg/m^3]
};

struct TestProcedure {
  std::string name;
  std::string source;                // where its numbers come from
  double step = StepOptions{}.step;  // of the simulation [s]
  ProcedureObject object = {};
  std::optional<double> friction = {};  // coefficient between hand and object; else the scene's
  // Torque about the normal over the normal force, which any contact bears [m]; else the scene's.
  std::optional<double> torsion = {};
  Vector3 gravity = Vector3::Zero();  // world [m/s^2]
  bool on_support = false;  // the obstacles of the scene are there; else the object floats at first
  std::vector<ProcedurePhase> prepare = {};  // before each test, once
  std::vector<ProcedureTest> tests = {};     // at least one; a grasp survives when no phase fails
};

}  // namespace prehend

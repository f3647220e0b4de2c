#include "benchmarks/shake/disagreements.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "benchmarks/shake/opinions.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/shape/mass_properties.h"

namespace prehend::bench {
namespace {

TriangleMesh union_of(const std::vector<TriangleMesh>& pieces) {
  TriangleMesh all;
  for (const TriangleMesh& piece : pieces) append(all, piece);
  return all;
}

// The same scene with bodies that are MuJoCo's convex pieces; none where links of the hand would
// overlap.
std::optional<ShakeCase> with_pieces(const ShakeCase& shaken) {
  Scene scene = shaken.scene.scene;
  scene.object.mesh = union_of(shaken.shapes.object);
  for (std::size_t l = 0; l < scene.hand.links.size(); ++l) {
    scene.hand.links[l].mesh = union_of(shaken.shapes.links[l]);
  }
  for (std::size_t o = 0; o < scene.obstacles.size(); ++o) {
    scene.obstacles[o].mesh = union_of(shaken.shapes.obstacles[o]);
  }
  try {
    return ShakeCase{shaken.name, compile(std::move(scene)), shaken.shapes, {}};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// The protocol with the mass that it means for the object itself, whatever stands for it.
TestProcedure with_mass_of(const CompiledScene& scene, TestProcedure procedure) {
  if (procedure.object.density) {
    procedure.object.mass =
        *procedure.object.density * mass_properties(scene.scene.object.mesh).volume;
    procedure.object.density.reset();
  }
  return procedure;
}

// Ours with a change. From the opening on the hand is opened on until nothing crosses, as pieces
// may by a little.
std::optional<bool> survives_in_ours(const ShakeCase& shaken, const ShakenGrasp& grasp,
                                     const TestProcedure& procedure, OwnRun run) {
  constexpr double kStep = 1.0 / 400.0;
  constexpr int kTries = 20;
  for (int i = 0; i <= kTries; ++i, run.opened += kStep) {
    try {
      return in_prehend(shaken, grasp, procedure, run).survived();
    } catch (const InputError&) {  // surfaces cross
      continue;
    }
  }
  return std::nullopt;
}

// The friction of all pairs of materials, or that of the protocol, times a factor.
std::pair<ShakeCase, TestProcedure> with_friction(const ShakeCase& shaken,
                                                  const TestProcedure& procedure, double factor) {
  std::pair<ShakeCase, TestProcedure> changed{shaken, procedure};
  if (procedure.friction) {
    changed.second.friction = factor * *procedure.friction;
    return changed;
  }
  FrictionTable& table = changed.first.scene.scene.friction;
  for (const Material a : kAll<Material>) {
    for (const Material b : kAll<Material>) {
      if (a <= b) table.set(a, b, factor * shaken.scene.scene.friction.between(a, b));
    }
  }
  return changed;
}

// What is changed in one of the simulators about a grasp.
class Changes {
 public:
  Changes(const ShakeCase& shaken, const ShakenGrasp& grasp, const TestProcedure& procedure)
      : shaken_(shaken), grasp_(grasp), procedure_(procedure) {}

  Counterfactual ours(const std::string& cause, const OwnRun& run) const {
    return {cause, true, [&shaken = shaken_, &grasp = grasp_, &procedure = procedure_, run] {
              return survives_in_ours(shaken, grasp, procedure, run);
            }};
  }

  Counterfactual ours_on_pieces(const std::string& cause, const OwnRun& run) const {
    const auto survives = [&shaken = shaken_, &grasp = grasp_, &procedure = procedure_,
                           run]() -> std::optional<bool> {
      const std::optional<ShakeCase> changed = with_pieces(shaken);
      if (!changed) return std::nullopt;
      return survives_in_ours(*changed, grasp, with_mass_of(shaken.scene, procedure), run);
    };
    return {cause, true, survives};
  }

  Counterfactual theirs(const std::string& cause, const MujocoRun& run) const {
    const auto survives = [&shaken = shaken_, &grasp = grasp_, &procedure = procedure_,
                           run]() -> std::optional<bool> {
      return in_mujoco(shaken, grasp, procedure, run).survived();
    };
    return {cause, false, survives};
  }

  // Less friction where the grasp holds, more where it does not.
  Counterfactual friction(double part, bool in_ours, bool holds) const {
    const double factor = holds ? 1.0 - part : 1.0 + part;
    const auto survives = [&shaken = shaken_, &grasp = grasp_, &procedure = procedure_, factor,
                           in_ours]() -> std::optional<bool> {
      const auto [changed, as_changed] = with_friction(shaken, procedure, factor);
      if (in_ours) return survives_in_ours(changed, grasp, as_changed, {});
      return in_mujoco(changed, grasp, as_changed).survived();
    };
    return {"friction " + std::to_string(std::lround(100.0 * part)) + " %", in_ours, survives};
  }

 private:
  const ShakeCase& shaken_;
  const ShakenGrasp& grasp_;
  const TestProcedure& procedure_;
};

bool breaks_away(const Robot& hand) {
  return std::any_of(hand.dofs.begin(), hand.dofs.end(), [](const DegreeOfFreedom& dof) {
    return dof.coupling == Coupling::breakaway;
  });
}

}  // namespace

std::optional<std::string> first_cause(const std::vector<Counterfactual>& changes, bool ours,
                                       bool theirs) {
  for (const Counterfactual& change : changes) {
    const std::optional<bool> survives = change.survives();
    if (survives && *survives == (change.in_ours ? theirs : ours)) return change.cause;
  }
  return std::nullopt;
}

std::vector<Counterfactual> counterfactuals(const ShakeCase& shaken, const ShakenGrasp& grasp,
                                            const TestProcedure& procedure, const ShakeResult& ours,
                                            const ShakeResult& theirs) {
  const Changes change(shaken, grasp, procedure);
  const bool has_clutches = breaks_away(shaken.scene.scene.hand);
  std::vector<Counterfactual> changes;
  if (has_clutches) changes.push_back(change.ours("clutches", {.clutches = false}));
  const OwnRun start{.opened = theirs.opened};
  if (theirs.opened > 0.0) changes.push_back(change.ours("start", start));
  changes.push_back(change.ours_on_pieces("pieces", start));
  changes.push_back(change.theirs("their step", {.step = 0.25}));
  changes.push_back(change.ours("our step", {.step = 0.25}));
  for (const double part : {0.1, 0.25}) {
    changes.push_back(change.friction(part, true, ours.survived()));
    changes.push_back(change.friction(part, false, theirs.survived()));
  }
  if (has_clutches) {
    changes.push_back(change.theirs("clutches", {.clutches = true}));
    changes.push_back(
        change.ours_on_pieces("clutches and pieces", {.clutches = false, .opened = theirs.opened}));
  }
  return changes;
}

std::string verdict_text(const ShakeResult& result) {
  std::string text;
  PhaseFailure last = PhaseFailure::none;
  for (const ShakeTestResult& test : failed_tests(result)) {
    const PhaseFailure failure = test.phases.back().failure;
    if (failure != last) {
      add_part(text, std::string(prehend::name_of(failure)) + " in ");
    } else {
      text += ", ";
    }
    text += test.name;
    last = failure;
  }
  return text.empty() ? "survived" : text;
}

}  // namespace prehend::bench

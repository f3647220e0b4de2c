#include "benchmarks/shake/carry_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "planner/show/exports/mjcf.h"
#include "sim/base/output_file.h"
#include "sim/manipulation/base_motion.h"

namespace prehend::bench {
namespace {

using nlohmann::json;

json phases_json(const TestProcedure& procedure) {
  json phases = json::array();
  Vector3 p = Vector3::Zero();
  const double h = MjcfOptions{}.time_step;
  for (const ProcedurePhase& phase : procedure.tests.front().phases) {
    const BaseStart start{.X_WH = translation(p), .axis_W = phase.axis, .height = phase.height};
    const int steps = static_cast<int>(std::ceil(phase.duration / h - 1e-9));
    json offsets = json::array();
    for (int k = 1; k <= steps; ++k) {
      p = base_pose(phase, start, k * h).translation();
      offsets.push_back({p.x(), p.y(), p.z()});
    }
    phases.push_back({{"closes", phase.kind == PhaseKind::close},
                      {"offsets", std::move(offsets)},
                      {"least_rise", phase.fails.least_rise},
                      {"most_dropped", std::min(phase.fails.dropped, 1e9)}});
  }
  return phases;
}

json hand_json(const Robot& hand) {
  json dofs = json::array();
  for (const DegreeOfFreedom& dof : hand.dofs) {
    dofs.push_back({{"velocity", dof.closing_velocity}, {"joints", json::array()}});
  }
  for (const Joint& joint : hand.joints) {
    dofs[static_cast<std::size_t>(joint.dof)]["joints"].push_back(
        {{"name", joint.name}, {"ratio", joint.ratio}});
  }
  json links = json::object();
  for (const Link& link : hand.links) {
    json& moved_by = links[link.name] = json::array();
    for (const int joint : joints_to(hand, link.joint)) {
      moved_by.push_back(hand.joints[static_cast<std::size_t>(joint)].dof);
    }
  }
  return {{"dofs", std::move(dofs)}, {"links", std::move(links)}};
}

}  // namespace

void write_carry_file(const std::string& folder, const CarryName& name, const MujocoCase& model,
                      const TestProcedure& procedure) {
  json locks = json::array();
  for (const JointLock& lock : model.subject.locks) {
    locks.push_back({{"joint", lock.joint}, {"closing", lock.closing}});
  }
  const ClosingStrategy& strategy = model.subject.strategy;
  const json file = {
      {"hand", name.hand},
      {"object", name.object},
      {"of", name.of},
      {"rank", name.rank},
      {"predicted", name.predicted},
      {"survived", name.survived},
      {"moves", hand_json(model.subject.hand)},
      {"locks", std::move(locks)},
      {"strategy",
       {{"first", strategy.first}, {"waits", strategy.waits}, {"effort", strategy.effort}}},
      {"phases", phases_json(procedure)},
      {"mjcf", model.mjcf}};
  make_folder(folder);
  const std::string stem =
      name.hand + "-" + name.object + "-" + name.of + "-" + std::to_string(name.rank);
  write_file(std::filesystem::path(folder) / (stem + ".json"), file.dump());
}

}  // namespace prehend::bench

#include "planner/show/report/simulation_report.h"

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/manipulation/simulate.h"
#include "sim/trial/close_and_score.h"

namespace prehend {
namespace {

using Force = WorldFrame::Force;

// The world as it was in a frame: poses only.
World world_at(const Simulation& simulation, const WorldFrame& frame) {
  World world = simulation.start;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) world.bodies[i].motion = frame.bodies[i];
  for (std::size_t r = 0; r < frame.robots.size(); ++r) {
    world.robots[r].X_WB = frame.robots[r].X_WB;
    world.robots[r].x = frame.robots[r].x;
  }
  return world;
}

std::vector<double> list_of(const Eigen::VectorXd& values) {
  return {values.data(), values.data() + values.size()};
}

std::vector<MotionForce> forces_on_object(const WorldFrame& frame, const Pose& X_OW) {
  std::vector<MotionForce> forces;
  for (const Force& force : frame.forces) {
    const bool on_a = force.a == kObjectSolid;
    if (!on_a && force.b != kObjectSolid) continue;
    const double sign = on_a ? 1.0 : -1.0;
    forces.push_back({X_OW * force.p_W, X_OW.linear() * (sign * force.force_W)});
  }
  return forces;
}

// The number of the last frame that is not after `time`.
int frame_at(const std::vector<WorldFrame>& frames, double time) {
  int last = 0;
  while (index(last) + 1 < frames.size() && frames[index(last) + 1].time <= time) ++last;
  return last;
}

std::string words_of(const ObjectEvent& event) {
  std::string words = formatted("%.3f s: ", event.time);
  switch (event.kind) {
    case ObjectEventKind::touched:
      return words + event.link + " touches the object";
    case ObjectEventKind::gripped:
      return words + "the hand grips it from opposite sides";
    case ObjectEventKind::lifted:
      return words + "the hand has lifted it";
    case ObjectEventKind::tilted:
      return words + "it tips over";
    case ObjectEventKind::left:
      return words + "it leaves the hand (" + event.link + " was the last to touch it)";
    case ObjectEventKind::fell:
      return words + "it falls";
  }
  return words;
}

// The grasp at the end, as a trial has it.
Trial final_grasp(const CompiledScene& scene, const Simulation& simulation,
                  const TrialOptions& options) {
  const World world = world_at(simulation, simulation.frames.back());
  const Pose& X_WO = world.bodies[index(kObjectBody)].motion.X_WB;
  Trial trial;
  trial.X_OH = X_WO.inverse() * hand_pose(world, simulation.hand);
  trial.dofs = hand_dofs(world, simulation.hand);
  trial.joints = hand_joints(world, simulation.hand);
  ScoringWorkspace workspace;
  score_contacts(scene, options, workspace, trial);
  return trial;
}

}  // namespace

GraspMotion motion_of(const CompiledScene& scene, const Simulation& simulation) {
  const Pose X_OW = scene.scene.object.X_WO.inverse();
  GraspMotion motion;
  motion.is_simulated = true;
  for (const WorldFrame& frame : simulation.frames) {
    const World world = world_at(simulation, frame);
    MotionFrame& moment = motion.frames.emplace_back();
    moment.time = frame.time;
    moment.X_OH = X_OW * hand_pose(world, simulation.hand);
    moment.joints = hand_joints(world, simulation.hand);
    if (!simulation.hand.is_free()) {
      moment.arm_joints = list_of(joints_of(world.robots[index(simulation.hand.robot)]));
    }
    moment.X_OC = X_OW * world.bodies[index(kObjectBody)].motion.X_WB;
    moment.forces = forces_on_object(frame, X_OW);
  }
  for (const SimulatedPhase& phase : simulation.phases) {
    const int first = motion.segments.empty() ? 0 : motion.segments.back().last;
    motion.segments.push_back({phase.name, first, frame_at(simulation.frames, phase.to)});
  }
  if (motion.segments.empty()) motion.segments = {{"start", 0, 0}};
  motion.segments.back().last = static_cast<int>(motion.frames.size()) - 1;
  return motion;
}

std::vector<std::string> event_lines(const Simulation& simulation) {
  std::vector<std::string> lines;
  for (const ObjectEvent& event : simulation.events) lines.push_back(words_of(event));
  for (const ShakeTestReport& test : simulation.tests) {
    if (test.outcome == ShakeOutcome::survived) continue;
    lines.push_back(formatted("%s ends after %.3f s: %s", test.name.c_str(), test.failed_at,
                              std::string(name_of(test.outcome)).c_str()));
  }
  lines.push_back(formatted("%.3f s: ", simulation.frames.back().time) +
                  std::string(object_end_meaning(simulation.end)));
  return lines;
}

Report simulation_report(const CompiledScene& scene, const Simulation& simulation,
                         const TrialOptions& options) {
  Report report;
  const std::string& robot = scene.arm ? scene.arm->robot().name : scene.scene.hand.name;
  report.title =
      scene.scene.object.name + ", " + robot + ": " + std::string(name_of(simulation.end));
  report.facts = {{"scene", scene.scene.name},
                  {"protocol", simulation.procedure},
                  {"steps", std::to_string(simulation.effort.steps)},
                  {"shortened", std::to_string(simulation.effort.shortened)},
                  {"not converged", std::to_string(simulation.effort.not_converged)}};
  report.scene = &scene;
  report.frame = scene.wrench_frame;
  report.grasps_in_all = 1;
  ReportGrasp& grasp = report.grasps.emplace_back();
  const Trial trial = final_grasp(scene, simulation, options);
  grasp.outcome = name_of(simulation.end);
  grasp.force_closure = trial.outcome == Outcome::stable;
  grasp.epsilon = trial.epsilon;
  for (const GraspContact& contact : trial.contacts) {
    grasp.contacts.push_back({contact.point, scene.links[index(contact.link)].name, contact.gap});
  }
  grasp.motion = motion_of(scene, simulation);
  grasp.events = event_lines(simulation);
  return report;
}

}  // namespace prehend

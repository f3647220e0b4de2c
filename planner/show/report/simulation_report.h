// The report on a simulation: its motion with the forces on the object, what happened, and the
// grasp at its end.
#pragma once

#include "planner/plan/path/grasp_motion.h"
#include "planner/show/report/report.h"
#include "sim/trial/trial_options.h"

namespace prehend {

struct CompiledScene;
struct Simulation;

// Hand, object and forces as they were recorded, in the frame O in which the object stands in the
// scene.
GraspMotion motion_of(const CompiledScene& scene, const Simulation& simulation);

// What happened, one line for each event and each test.
std::vector<std::string> event_lines(const Simulation& simulation);

// Both must outlive the report. Contacts and quality are those at the end, by `options`, where the
// hand touches the object then.
Report simulation_report(const CompiledScene& scene, const Simulation& simulation,
                         const TrialOptions& options = {});

}  // namespace prehend

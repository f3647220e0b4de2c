// Uses the installed library as a program of somebody else would: each part alone, and all
// together. Arguments: a folder to write to.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <prehend/contacts.h>
#include <prehend/prehend.h>
#include <prehend/simulation.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using prehend::Pose;
using prehend::Vector3;

void check(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("not so: " + what);
}

// What `prehend plan mug --no-report` does; the test compares its grasps.json.
void plan_library_scene(const std::filesystem::path& folder) {
  const prehend::CompiledScene ready = prehend::compile(prehend::load_scene("mug"));
  const prehend::PlanOptions options;
  const prehend::PlanResult result = prehend::plan(ready, options);
  prehend::RunRecord record;
  record.scene = "mug";
  record.options = options;
  prehend::write_file(folder / "grasps.json", prehend::grasps_json(ready, result, record));
  check(result.grasps.size() == 10, "ten grasps are returned");
}

// Told to stop while it tries candidates, a plan returns those that were tried.
void cancel_from_progress() {
  const prehend::CompiledScene ready = prehend::compile(
      prehend::make_scene(prehend::make_graspable("box", prehend::make_box({0.04, 0.05, 0.06}),
                                                  prehend::Material::wood),
                          "parallel_jaw"));
  prehend::RunContext context;
  context.threads = 1;
  int seen = 0;
  context.progress = [&](const prehend::Progress& progress) {
    if (progress.stage != prehend::Stage::trials) return;
    seen = progress.done;
    if (progress.done == 3) context.cancellation.request();
  };
  const prehend::PlanResult result = prehend::plan(ready, {}, context);
  check(result.status == prehend::PlanStatus::cancelled, "the plan says that it was cancelled");
  check(result.tried.size() == 3 && seen == 3, "what was tried until then is there");
  check(result.untested > 0, "and the rest is counted");
}

prehend::TriangleMesh slab(const Vector3& size, const Vector3& center) {
  return prehend::transformed(prehend::make_box(size), prehend::translation(center));
}

// A mug on a table in front of an arm, without any file.
prehend::Scene scene_with_arm() {
  prehend::Scene scene =
      prehend::make_scene(prehend::make_graspable("mug", prehend::generate_object("mug", 1000),
                                                  prehend::Material::plastic),
                          "franka_hand");
  scene.object.X_WO = prehend::translation({0.58, 0.05, 0.7201});
  prehend::add_obstacle(scene, "table", slab({0.7, 1.2, 0.03}, {0.67, 0.0, 0.705}));
  prehend::mount(scene, "puma560_barrett", prehend::translation({0.0, 0.0, 0.6868}));
  check(scene.hand.name == scene.carrier->platform.robots.back().robot.name,
        "the hand is the one that was mounted");
  return scene;
}

void plan_with_arm(const std::filesystem::path& folder) {
  const prehend::CompiledScene ready = prehend::compile(scene_with_arm());
  prehend::PlanOptions options;
  options.search.trials = 200;
  options.rank.top = 1;
  options.paths.emplace();
  const prehend::PlanResult result = prehend::plan(ready, options);
  check(!result.grasps.empty(), "the arm takes the mug");
  const prehend::ScoredGrasp& best = result.grasps.front();
  check(prehend::check_path(ready, best.path.value()).ok(), "its path is free");

  const auto again = prehend::plan_grasp_path(ready, best.candidate, best.trial, *options.paths);
  check(again.has_value(), "a path alone is found");
  const prehend::Trial trial = prehend::run_trial(ready, best.candidate, options.trial);
  check(trial.epsilon.lower == best.trial.epsilon.lower, "a trial alone says the same");
  const prehend::PlanResult evaluated = prehend::evaluate(ready, {best.candidate});
  check(evaluated.grasps.front().trial.epsilon.lower == best.trial.epsilon.lower,
        "so does an evaluation");

  for (const char* format : {"csv", "isaac", "moveit", "gltf", "mjcf"}) {
    for (const prehend::ExportFile& file : prehend::export_files(ready, result, format)) {
      prehend::write_file(folder / file.name, file.content);
    }
  }
  prehend::RunRecord record;
  record.scene = "made in code";
  record.options = options;
  const prehend::Report report = prehend::plan_report(ready, result, record);
  prehend::write_file(folder / "report.html", prehend::report_html(report));
  const prehend::PosedGrasp posed = prehend::posed_grasp(ready, best, "the best grasp");
  const prehend::Image picture =
      prehend::grasp_picture(ready, posed, prehend::best_viewpoint(ready, posed));
  check(prehend::png_bytes(picture).substr(1, 3) == "PNG", "a picture is PNG");
}

void decompose_alone() {
  const prehend::Decomposition parts = prehend::decompose(prehend::make_box({0.1, 0.2, 0.3}));
  check(parts.primitives.size() == 1, "a box is one primitive");
  check(prehend::shape_name(parts.primitives.front().shape) == "box", "which is a box");
}

void solve_kinematics_alone() {
  const prehend::Robot arm = prehend::find_robot("puma560");
  const std::vector<double> start = prehend::initial_dofs(arm);
  std::vector<double> turned = start;
  for (double& value : turned) value += 0.2;
  std::vector<Pose> frames;
  prehend::joint_poses(arm, prehend::joint_values(arm, turned), frames);
  const int last = static_cast<int>(arm.joints.size()) - 1;
  const prehend::IkTarget target{.joint = last, .X_BT = frames.back()};
  const auto solutions = prehend::solve_all(arm, {target}, start);
  check(!solutions.empty(), "the arm reaches where it has been");
  for (const prehend::DofValues& solution : solutions) {
    std::vector<Pose> reached;
    prehend::joint_poses(arm, prehend::joint_values(arm, solution), reached);
    check(reached.back().isApprox(target.X_BT, 1e-6), "every solution is one");
  }
}

void judge_contacts_alone() {
  std::vector<prehend::Contact> contacts;
  for (const double side : {-1.0, 1.0}) {
    contacts.push_back({.position = {side * 0.05, 0.0, 0.0},
                        .normal = {-side, 0.0, 0.0},
                        .friction = 0.5,
                        .model = prehend::ContactModel::soft_finger,
                        .torsion = 0.01});
  }
  const prehend::WrenchFrame frame{.torque_scale = 20.0};
  const prehend::WrenchSpaceOptions space;
  const auto epsilon =
      prehend::grasp_epsilon(contacts, frame, space, prehend::epsilon_options(space));
  check(epsilon.lower > 0.0, "two soft fingers hold");
}

void let_it_fall() {
  const prehend::Scene scene =
      prehend::make_scene(prehend::make_graspable("box", prehend::make_box({0.04, 0.05, 0.06}),
                                                  prehend::Material::wood),
                          "parallel_jaw");
  prehend::World world;
  prehend::add_bodies(scene, world);
  const prehend::StepResult step = prehend::step_world(world);
  check(step.outcome == prehend::StepOutcome::moved, "a world moves on");
  const double speed = world.bodies.front().motion.linear.z();
  check(std::abs(speed + 9.81 * step.time) < 1e-9, "nothing holds the box");
}

void refuse_mistakes() {
  const auto refuses = [](const auto& mistake, const std::string& word) {
    try {
      mistake();
    } catch (const prehend::InputError& error) {
      return std::string(error.what()).find(word) != std::string::npos;
    }
    return false;
  };
  check(refuses([] { prehend::find_robot("nobody"); }, "barrett"), "an unknown hand is refused");
  check(refuses(
            [] {
              prehend::make_mesh({Vector3::Zero()}, {{0, 1, 2}});
            },
            "triangles[0]"),
        "an index out of range is refused");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    check(argc == 2, "one argument");
    check(std::string(prehend::version()) != "", "the library has a version");
    decompose_alone();
    solve_kinematics_alone();
    judge_contacts_alone();
    let_it_fall();
    refuse_mistakes();
    cancel_from_progress();
    plan_with_arm(argv[1]);
    plan_library_scene(argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}

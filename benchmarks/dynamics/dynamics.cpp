// How long steps of moving bodies take:
//
//   dynamics [--boxes N] [--plot FILE.svg]
//
// A hand that holds an object above a table, step by step, and boxes that fall into a heap, up to N
// of them (1000), with the exponent of their time and a plot.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/report/line_plot.h"
#include "benchmarks/report/power_law.h"
#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/plan/plan.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"
#include "sim/base/random.h"
#include "sim/manipulation/grasp_world.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/rigid_motion.h"
#include "sim/motion/step_world.h"
#include "sim/motion/world.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/shape/basic_shapes.h"

namespace prehend::bench {
namespace {

// Of a processor, so that what else runs on the machine counts little.
struct StepTimes {
  std::vector<double> milliseconds;
  std::vector<double> contacts;
};

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

StepTimes run_steps(World& world, int steps) {
  StepTimes times;
  for (int i = 0; i < steps; ++i) {
    const double start = benchmark::processor_seconds();
    const StepResult result = step_world(world);
    times.milliseconds.push_back(1e3 * (benchmark::processor_seconds() - start));
    times.contacts.push_back(static_cast<double>(world.contacts.size()));
    if (result.outcome == StepOutcome::blocked) break;
  }
  return times;
}

void print_times(const std::string& name, const StepTimes& times) {
  std::printf("%-28s %6zu %8.0f %9.3f %9.3f %9.3f\n", name.c_str(), times.milliseconds.size(),
              benchmark::percentile(times.contacts, 0.5),
              benchmark::percentile(times.milliseconds, 0.5),
              benchmark::percentile(times.milliseconds, 0.95),
              *std::max_element(times.milliseconds.begin(), times.milliseconds.end()));
  std::fflush(stdout);
}

// The best grasp of a scene: the fingers close on the object on its support, lift it and put it
// down again, so that hand, object and table touch.
void time_grasp(const std::string& name) {
  const CompiledScene scene = compile(load_scene(name, {}));
  const PlanResult plan = prehend::plan(scene, {});
  if (plan.grasps.empty()) return;
  TestProcedure procedure = read_test_procedure(find_test_procedure("simready"));
  GraspWorld grasped =
      make_grasp_world(scene, hand_model(scene), posture_of(plan.grasps.front().trial), procedure);
  World& world = grasped.world;
  world.gravity = {0.0, 0.0, -9.81};
  WorldRobot& hand = world.robots.front();
  hand.drives = closing_drives(*hand.model, grasped.hand);
  print_times(name + ", closing", run_steps(world, 300));
  print_times(name + ", held", run_steps(world, 700));
}

// Boxes over each other in columns that lean on each other as they fall: a heap of N of them.
World heap(int boxes) {
  World world;
  WorldBody ground{"ground",
                   make_collision_body("ground", make_box(Vector3(10.0, 10.0, 0.1)), true)};
  ground.is_fixed = true;
  ground.motion.X_WB = translation({0.0, 0.0, -0.05});
  world.bodies.push_back(std::move(ground));
  Random random(1);
  const int side = std::max(1, static_cast<int>(std::lround(std::cbrt(boxes))));
  for (int i = 0; i < boxes; ++i) {
    const TriangleMesh mesh = make_box(Vector3(0.05, 0.04, 0.03));
    WorldBody box{"box" + std::to_string(i), make_collision_body("box", mesh, true)};
    box.inertial = inertial_of_mass(mesh, 0.05);
    const int layer = i / (side * side);
    const int row = (i / side) % side;
    const Vector3 place(0.06 * (i % side), 0.06 * row, 0.05 + 0.06 * layer);
    const Vector3 off = random.in_box({-4e-3, -4e-3, 0.0}, {4e-3, 4e-3, 0.0});
    box.motion.X_WB = translation(place + off);
    world.bodies.push_back(std::move(box));
  }
  return world;
}

void write_plot(const Line& line, const std::filesystem::path& file) {
  LinePlot plot;
  plot.title = "Boxes that fall into a heap";
  plot.x_label = "boxes";
  plot.y_label = "processor time of a step [ms]";
  plot.x_scale = Scale::logarithmic;
  plot.y_scale = Scale::logarithmic;
  plot.lines = {line};
  write_file(file, line_plot_svg(plot));
}

// The time of a step of heaps, the mean over all steps from the first fall to rest, with their
// median as the lower end of the spread and the 95 % as the upper. The plot is written anew after
// each heap, since the largest take minutes.
void time_heaps(int most, const std::filesystem::path& plot) {
  Line line{"heap of boxes, mean of 320 steps", {}, {}};
  std::vector<DataPoint> points;
  for (const int boxes : {8, 27, 64, 125, 216, 512, 1000}) {
    if (boxes > most) break;
    World world = heap(boxes);
    const StepTimes times = run_steps(world, 320);
    print_times("heap of " + std::to_string(boxes), times);
    const double average = mean(times.milliseconds);
    line.points.push_back({static_cast<double>(boxes), average,
                           std::min(average, benchmark::percentile(times.milliseconds, 0.5)),
                           std::max(average, benchmark::percentile(times.milliseconds, 0.95))});
    points.push_back({static_cast<double>(boxes), average});
    line.fit = fit_power_law(points);
    if (!plot.empty()) write_plot(line, plot);
  }
  if (line.fit) {
    std::printf("mean time of a step of a heap: boxes to the power of %.2f (r^2 %.3f)\n",
                line.fit->exponent, line.fit->r_squared);
  }
}

struct Arguments {
  int boxes = 1000;
  std::filesystem::path plot;  // empty: none
};

Arguments read_arguments(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_option = words[i] == "--boxes" || words[i] == "--plot";
    if (!is_option || i + 1 == words.size()) {
      throw InputError({.field = words[i], .problem = "is no option, or needs a value"});
    }
    if (words[i] == "--boxes") {
      arguments.boxes = std::stoi(words[++i]);
    } else {
      arguments.plot = words[++i];
    }
  }
  return arguments;
}

int run(const std::vector<std::string>& words) {
  const Arguments arguments = read_arguments(words);
  std::printf("%-28s %6s %8s %9s %9s %9s\n", "world", "steps", "contacts", "median ms", "95 %",
              "most");
  time_grasp("mug_on_table");
  time_heaps(arguments.boxes, arguments.plot);
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "dynamics: %s\n", error.what());
    return 1;
  }
}

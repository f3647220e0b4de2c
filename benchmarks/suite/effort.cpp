#include "benchmarks/suite/effort.h"

#include "sim/shape/object_generator.h"

namespace prehend::bench {
namespace {

Sizes full_sizes() {
  Sizes sizes;
  sizes.objects = generated_object_names();
  sizes.hands = {"barrett", "franka_hand", "parallel_jaw", "parallel_jaw_wide"};
  sizes.arm_scenes = {"mug_on_table", "cluttered_table", "shelf", "living_room"};
  sizes.trade_objects = {"mug", "wine_glass", "phone"};
  sizes.plan_trials = {50, 100, 200, 400, 800, 1600};
  sizes.triangles = {1000, 4000, 16000, 64000, 250000, 1000000};
  sizes.candidates = {100, 300, 1000, 3000, 10000, 30000, 100000};
  sizes.contacts = {3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
  sizes.obstacles = {0, 1, 3, 10, 30, 100, 300, 1000};
  return sizes;
}

Sizes quick_sizes() {
  Sizes sizes = full_sizes();
  sizes.effort = Effort::quick;
  sizes.repetitions = 5;
  sizes.kernel_seconds = 0.03;
  sizes.objects = {"mug", "wine_glass", "phone"};
  sizes.hands = {"barrett", "franka_hand"};
  sizes.trials = 60;
  sizes.arm_scenes = {"mug_on_table", "living_room"};
  sizes.paths = 6;
  sizes.plan_runs = 2;
  sizes.trade_objects = {"mug", "phone"};
  sizes.trade_candidates = 60;
  sizes.plan_trials = {50, 100, 200, 400};
  sizes.seeds = 3;
  sizes.triangles = {1000, 4000, 16000, 64000};
  sizes.candidates = {100, 300, 1000, 3000};
  sizes.contacts = {3, 4, 8, 16, 32};
  sizes.obstacles = {0, 1, 10, 100};
  sizes.scaling_trials = 8;
  sizes.grasps = 6;
  sizes.thread_runs = 2;
  sizes.longest_point = 5.0;
  return sizes;
}

Sizes smoke_sizes() {
  Sizes sizes = quick_sizes();
  sizes.effort = Effort::smoke;
  sizes.repetitions = 1;
  sizes.kernel_seconds = 1e-4;
  sizes.objects = {"box"};
  sizes.hands = {"parallel_jaw"};
  sizes.trials = 4;
  sizes.arm_scenes = {"mug_on_table"};
  sizes.path_trials = 40;
  sizes.paths = 1;
  sizes.plans = 1;
  sizes.plan_runs = 1;
  sizes.trade_objects = {"mug"};
  sizes.trade_candidates = 4;
  sizes.plan_trials = {8, 12, 16};
  sizes.seeds = 1;
  sizes.triangles = {200, 400};
  sizes.candidates = {10, 20};
  sizes.contacts = {3, 4};
  sizes.obstacles = {0, 1, 2};
  sizes.scaling_trials = 2;
  sizes.grasps = 2;
  sizes.thread_runs = 1;
  return sizes;
}

}  // namespace

std::string_view effort_name(Effort effort) {
  if (effort == Effort::full) return "full";
  return effort == Effort::quick ? "quick" : "smoke";
}

Sizes sizes_of(Effort effort) {
  if (effort == Effort::full) return full_sizes();
  return effort == Effort::quick ? quick_sizes() : smoke_sizes();
}

}  // namespace prehend::bench

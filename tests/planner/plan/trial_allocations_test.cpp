// Trials in a workspace: they do not allocate, and give the same as trials without one.
//
// Every allocation of this test program is counted: malloc, which operator new and Eigen call, is
// replaced here, or, where a sanitizer has replaced it already, watched through its hooks. Left out
// are trials with an arm, whose inverse kinematics and collision checks do allocate. Where rounding
// stalls epsilon, qhull allocates; that is rare, and these trials have no such case.
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/propose/candidates.h"
#include "primitives/decompose.h"
#include "sim/robot/files/robot_file.h"
#include "sim/trial/run_trial.h"
#include "sim/trial/trial_options.h"
#include "tests/support/library_scenes.h"
#include "tests/support/trial_bytes.h"

namespace {

std::atomic<long> allocations = 0;

}  // namespace

#if !defined(__has_feature)
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)

// As in sanitizer/allocator_interface.h, which gcc does not install.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*,
                                                                           std::size_t),
                                                         void (*on_free)(const volatile void*));

namespace {

const bool kCounting =
    __sanitizer_install_malloc_and_free_hooks(
        [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {}) > 0;

}  // namespace

#else

extern "C" {
// glibc's own functions, under the names that stay theirs.
void* libc_malloc(std::size_t size) __asm__("__libc_malloc");
void* libc_calloc(std::size_t nmemb, std::size_t size) __asm__("__libc_calloc");
void* libc_realloc(void* ptr, std::size_t size) __asm__("__libc_realloc");
void* libc_memalign(std::size_t alignment, std::size_t size) __asm__("__libc_memalign");

void* malloc(std::size_t size) {
  ++allocations;
  return libc_malloc(size);
}
void* calloc(std::size_t nmemb, std::size_t size) {
  ++allocations;
  return libc_calloc(nmemb, size);
}
void* realloc(void* ptr, std::size_t size) {
  ++allocations;
  return libc_realloc(ptr, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return libc_memalign(alignment, size);
}
}

namespace {

const bool kCounting = true;

}  // namespace

#endif

namespace prehend {
namespace {

constexpr std::size_t kTried = 30;  // candidates of each scene

struct TriedScene {
  std::string name;
  CompiledScene scene;
  std::vector<Candidate> candidates;  // the first that a plan tries
};

TriedScene tried_scene(const std::string& object, const std::string& hand, std::size_t count) {
  Scene scene = load_scene(test::library_scene(object));
  scene.hand = find_robot(hand);
  scene.carrier.reset();
  TriedScene tried{object + " with " + hand, compile(std::move(scene)), {}};
  const auto primitives = decompose(tried.scene.scene.object.mesh).primitives;
  for (ProposedGrasp& grasp : propose_grasps(tried.scene, primitives, count).grasps) {
    tried.candidates.push_back(std::move(grasp.candidate));
  }
  return tried;
}

// Hands of which the first has breakaway joints, the second self-centering soft fingers between
// which objects settle.
const std::vector<TriedScene>& tried_scenes() {
  static const std::vector<TriedScene> tried = {tried_scene("mug", "barrett", kTried),
                                                tried_scene("mug", "franka_hand", kTried),
                                                tried_scene("mug_on_table", "barrett", kTried)};
  return tried;
}

// What happened in the trials of all scenes: every stage of a trial is among what is counted.
struct Happened {
  std::map<Outcome, int> outcomes;
  int backed_off = 0;
  int settled = 0;
  int soft_contacts = 0;

  void add(const Trial& trial) {
    ++outcomes[trial.outcome];
    if (trial.back_offs > 0) ++backed_off;
    if (trial.turned > 0.0) ++settled;
    for (const GraspContact& contact : trial.contacts) {
      if (contact.point.model == ContactModel::soft_finger) ++soft_contacts;
    }
  }
};

TEST(TrialAllocations, AreCounted) {
  ASSERT_TRUE(kCounting);
  const long before = allocations;
  const std::vector<double> list(10);
  const Eigen::MatrixXd matrix(list.size(), list.size());
  // A compiler may leave out memory that nothing points to.
  [[maybe_unused]] const void* volatile kept = list.data();
  kept = matrix.data();
  EXPECT_EQ(allocations - before, 2);
}

TEST(TrialAllocations, AreNoneOnceTheWorkspaceHasGrown) {
  TrialOptions options;
  options.back_off_tries = 3;
  const RunContext context;
  Happened happened;
  for (const TriedScene& tried : tried_scenes()) {
    TrialWorkspace workspace;
    Trial trial;
    for (const Candidate& candidate : tried.candidates) {
      run_trial(tried.scene, candidate, options, workspace, trial, context);
      happened.add(trial);
    }
    for (std::size_t i = 0; i < tried.candidates.size(); ++i) {
      const long before = allocations;
      run_trial(tried.scene, tried.candidates[i], options, workspace, trial, context);
      EXPECT_EQ(allocations - before, 0) << tried.name << ", candidate " << i;
    }
  }
  EXPECT_GT(happened.outcomes[Outcome::stable], 0);
  EXPECT_GT(happened.outcomes[Outcome::not_force_closure], 0);
  EXPECT_GT(happened.outcomes[Outcome::hand_blocked], 0);
  EXPECT_GT(happened.backed_off, 0);
  EXPECT_GT(happened.settled, 0);
  EXPECT_GT(happened.soft_contacts, 0);
}

TEST(TrialAllocations, AWorkspaceChangesNoResult) {
  const TrialOptions options;
  const RunContext context;
  TrialWorkspace workspace;
  Trial trial;
  // From scene to scene: what one hand and its object leave in the workspace is not that of the
  // next.
  for (std::size_t i = 0; i < kTried; i += 2) {
    for (const TriedScene& one : tried_scenes()) {
      run_trial(one.scene, one.candidates[i], options, workspace, trial, context);
      EXPECT_EQ(test::bytes_of(trial),
                test::bytes_of(run_trial(one.scene, one.candidates[i], options)))
          << one.name << ", candidate " << i;
    }
  }
}

}  // namespace
}  // namespace prehend

#include "sim/scene/free_start.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/joined.h"
#include "sim/base/random.h"
#include "sim/robot/hand/self_collision.h"

namespace prehend {
namespace {

constexpr int kPostures = 200;         // random ones
constexpr double kNearlyAll = 0.95;    // of them
constexpr std::uint64_t kSeed = 5849;  // of their own

using Pair = std::pair<int, int>;

class FreeStart {
 public:
  explicit FreeStart(Platform& platform)
      : platform_(platform),
        whole_(assemble(platform)),
        links_(whole_.robot),
        start_(initial_dofs(platform)) {
    // How a hand closes is looked at where its preshapes are derived.
    const std::vector<Pair> pairs = links_.pairs();
    for (const Pair& pair : pairs) {
      const std::size_t robot = robot_of(pair.first);
      if (robot == robot_of(pair.second) && robot + 1 == platform.robots.size()) {
        links_.leave_out(pair);
      }
    }
  }

  void find() {
    exempt_always_meeting();
    const std::vector<Pair> met = links_.colliding(start_);
    if (met.empty()) return;
    std::vector<double> middle = start_;
    for (std::size_t d = 0; d < carrying_dofs(); ++d) middle[d] = between(d, 0.5);
    if (links_.any(middle)) {
      Random random(kSeed);
      for (int k = 0; k < kPostures && links_.any(middle); ++k) middle = posture(random);
    }
    if (links_.any(middle)) return;
    start_at(middle);
    note("links collide where all joints are at 0 or at the limit next to it (" + names(met) +
         "): the arm starts elsewhere; \"start\" in a scene file says where");
  }

 private:
  std::size_t robot_of(int link) const {
    std::size_t robot = 0;
    for (std::size_t r = 1; r < whole_.parts.size(); ++r) {
      if (link >= whole_.parts[r].first_link) robot = r;
    }
    return robot;
  }

  // The degrees of freedom of all robots but the last, which is the hand.
  std::size_t carrying_dofs() const { return index(whole_.parts.back().first_dof); }

  double between(std::size_t dof, double part) const {
    const DegreeOfFreedom& of = whole_.robot.dofs[dof];
    return of.lower + part * (of.upper - of.lower);
  }

  std::vector<double> posture(Random& random) const {
    std::vector<double> dofs = start_;
    for (std::size_t d = 0; d < carrying_dofs(); ++d) dofs[d] = between(d, random.uniform());
    return dofs;
  }

  std::string names(const std::vector<Pair>& pairs) const {
    std::string all;
    for (const auto& [a, b] : pairs) {
      add_part(all,
               whole_.robot.links[index(a)].name + " and " + whole_.robot.links[index(b)].name);
    }
    return all;
  }

  void note(const std::string& words) { platform_.robots.front().robot.notes.push_back(words); }

  void exempt(const Pair& pair) {
    const std::size_t robot = robot_of(pair.first);
    if (robot == robot_of(pair.second)) {
      const int first = whole_.parts[robot].first_link;
      platform_.robots[robot].robot.exempt_pairs.emplace_back(pair.first - first,
                                                              pair.second - first);
    } else {
      platform_.exempt_pairs.emplace_back(whole_.robot.links[index(pair.first)].name,
                                          whole_.robot.links[index(pair.second)].name);
    }
    links_.leave_out(pair);
  }

  void exempt_always_meeting() {
    const std::vector<Pair> met = links_.colliding(start_);
    if (met.empty()) return;
    std::vector<int> times(met.size(), 0);
    Random random(kSeed);
    for (int k = 0; k < kPostures; ++k) {
      const std::vector<double> dofs = posture(random);
      for (std::size_t p = 0; p < met.size(); ++p) {
        if (links_.meet({met[p].first}, {met[p].second}, dofs)) ++times[p];
      }
    }
    std::vector<Pair> always;
    for (std::size_t p = 0; p < met.size(); ++p) {
      if (times[p] < kNearlyAll * kPostures) continue;
      exempt(met[p]);
      always.push_back(met[p]);
    }
    if (always.empty()) return;
    note("links that meet in nearly all postures are not checked against each other: " +
         names(always));
  }

  void start_at(const std::vector<double>& dofs) {
    auto next = dofs.begin();
    for (MountedRobot& mounted : platform_.robots) {
      for (DegreeOfFreedom& dof : mounted.robot.dofs) dof.initial = *next++;
    }
  }

  Platform& platform_;
  const AssembledPlatform whole_;
  SelfCollision links_;
  const std::vector<double> start_;
};

}  // namespace

void find_free_start(Platform& platform) { FreeStart(platform).find(); }

}  // namespace prehend

// What grasps are worth that were planned from depth images:
//
//   views_benchmark FILE... [--hands NAMES] [--angles N] [--only one|three|hull|truth] [--details]
//                   [--threads N] [--voxel METRES]
//
// Each mesh (in metres) stands on a table and is seen from N sides (8), by one camera or three. Of
// each hand (names with commas between them) the best grasp is planned, without an arm, on what is
// made of the views, on the convex hull of what one camera saw, and on the mesh itself; and is then
// tried on the mesh: h,p/n, of n cases h hold where the hand comes until it touches, p where it
// goes as far as in the plan. The cases are those in which the best grasp of a plan on the mesh
// holds.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "benchmarks/support/percentile.h"
#include "benchmarks/views/view_cases.h"
#include "sim/base/input_error.h"

namespace prehend::bench {
namespace {

struct Words {
  std::vector<std::string> files;
  std::vector<std::string> hands = {"franka_hand", "robotiq_2f85", "barrett"};
  int angles = 8;
  std::string only;
  int threads = 1;
  ReconstructOptions steps;
  bool details = false;

  bool wants(const std::string& what) const { return only.empty() || only == what; }
};

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts(1);
  for (const char c : list) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Words read(const std::vector<std::string>& words) {
  Words read;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool more = i + 1 < words.size();
    if (words[i] == "--details") {
      read.details = true;
    } else if (words[i] == "--hands" && more) {
      read.hands = parts_of(words[++i]);
    } else if (words[i] == "--angles" && more) {
      read.angles = std::stoi(words[++i]);
    } else if (words[i] == "--threads" && more) {
      read.threads = std::stoi(words[++i]);
    } else if (words[i] == "--voxel" && more) {
      read.steps.voxel = std::stod(words[++i]);
    } else if (words[i] == "--only" && more) {
      read.only = words[++i];
    } else if (words[i].starts_with("--")) {
      throw InputError({.field = words[i], .problem = "is no option"});
    } else {
      read.files.push_back(words[i]);
    }
  }
  return read;
}

struct Share {
  int held = 0;
  int as_planned = 0;
  int tried = 0;

  void add(const ViewResult& result) {
    held += result.holds ? 1 : 0;
    as_planned += result.holds_as_planned ? 1 : 0;
    ++tried;
  }
  std::string text() const {
    if (tried == 0) return "-";
    return std::to_string(held) + "," + std::to_string(as_planned) + "/" + std::to_string(tried);
  }
};

constexpr std::size_t kKinds = kAll<PlannedFrom>.size();

using Shares = std::array<Share, kKinds>;

class Benchmark {
 public:
  explicit Benchmark(Words words) : words_(std::move(words)) {}

  void run() {
    std::printf("%-18s %-12s", "object", "hand");
    for (const PlannedFrom from : kAll<PlannedFrom>) {
      std::printf(" %12s", std::string(name_of(from)).c_str());
    }
    std::printf("  symmetries\n");
    for (const std::string& file : words_.files) try_object(file);
    for (const std::string& hand : words_.hands) print("all", hand, total_[hand], "");
    std::printf(
        "reconstruction on %d threads: one view %.0f ms in the median, 95 %% %.0f ms; three "
        "views %.0f ms, %.0f ms\n",
        words_.threads, benchmark::percentile(times_[0], 0.5),
        benchmark::percentile(times_[0], 0.95), benchmark::percentile(times_[1], 0.5),
        benchmark::percentile(times_[1], 0.95));
    std::printf(
        "from one view to ranked grasps: %.0f ms in the median, 95 %% %.0f ms; to the surest: %.0f "
        "ms, %.0f ms\n",
        benchmark::percentile(to_grasps_[0], 0.5), benchmark::percentile(to_grasps_[0], 0.95),
        benchmark::percentile(to_grasps_[1], 0.5), benchmark::percentile(to_grasps_[1], 0.95));
  }

 private:
  struct Seen {
    std::vector<SeenObject> one;  // of each angle; empty meshes where there was none
    std::vector<double> one_milliseconds;
    std::vector<SeenObject> three;
    std::string symmetries;
  };

  SeenObject seen_by(const TableCase& object, double angle, int count, std::vector<double>& times) {
    const std::vector<DepthView> views = views_of(object, angle, count);
    SeenObject seen;
    const benchmark::Clock::time_point start = benchmark::Clock::now();
    try {
      seen = reconstruct(views, words_.steps, {.threads = words_.threads}).objects.front();
    } catch (const InputError& error) {
      std::printf("  %s: %s\n", object.name.c_str(), error.what());
    }
    times.push_back(benchmark::milliseconds_since(start));
    return seen;
  }

  Seen see(const TableCase& object) {
    Seen seen;
    for (int k = 0; k < words_.angles; ++k) {
      const double angle = 0.3 + 2.0 * std::numbers::pi * k / words_.angles;
      if (words_.wants("one") || words_.wants("hull")) {
        seen.one.push_back(seen_by(object, angle, 1, times_[0]));
        seen.one_milliseconds.push_back(times_[0].back());
        seen.symmetries += name_of(seen.one.back().symmetry).substr(0, 1);
      }
      if (words_.wants("three")) seen.three.push_back(seen_by(object, angle, 3, times_[1]));
    }
    return seen;
  }

  void note(const ViewResult& result, PlannedFrom from, const std::string& hand, std::size_t k,
            Shares& shares) const {
    shares[static_cast<std::size_t>(from)].add(result);
    if (words_.details && !result.holds) {
      std::printf("  %s, %s, view %zu: %s\n", hand.c_str(), std::string(name_of(from)).c_str(), k,
                  result.outcome.c_str());
    }
  }

  void try_hand(const TableCase& object, const Seen& seen, const std::string& hand) {
    const Grasping grasping(object, hand, words_.threads);
    Shares shares;
    const ViewResult truth = grasping.plan_and_try(object.mesh_W);
    note(truth, PlannedFrom::truth, hand, 0, shares);
    if (truth.holds) {
      for (std::size_t k = 0; k < seen.one.size(); ++k) {
        if (words_.wants("one")) {
          const auto results = grasping.plan_and_try_both(seen.one[k]);
          note(results[0], PlannedFrom::one_view, hand, k, shares);
          note(results[1], PlannedFrom::one_view_sure, hand, k, shares);
          for (std::size_t r = 0; r < results.size(); ++r) {
            to_grasps_[r].push_back(seen.one_milliseconds[k] + results[r].milliseconds);
          }
        }
        if (words_.wants("hull")) {
          note(grasping.plan_and_try(hull_of_seen(seen.one[k])), PlannedFrom::hull, hand, k,
               shares);
        }
      }
      for (std::size_t k = 0; k < seen.three.size(); ++k) {
        const auto results = grasping.plan_and_try_both(seen.three[k]);
        note(results[0], PlannedFrom::three_views, hand, k, shares);
        note(results[1], PlannedFrom::three_views_sure, hand, k, shares);
      }
    }
    print(object.name, hand, shares, seen.symmetries);
    Shares& total = total_[hand];
    for (std::size_t k = 0; k < kKinds; ++k) {
      total[k].held += shares[k].held;
      total[k].as_planned += shares[k].as_planned;
      total[k].tried += shares[k].tried;
    }
  }

  void try_object(const std::string& file) {
    const TableCase object = table_case(file);
    const Seen seen = see(object);
    for (const std::string& hand : words_.hands) try_hand(object, seen, hand);
  }

  static void print(const std::string& object, const std::string& hand, const Shares& shares,
                    const std::string& symmetries) {
    std::printf("%-18s %-12s", object.c_str(), hand.c_str());
    for (const Share& share : shares) std::printf(" %12s", share.text().c_str());
    std::printf("  %s\n", symmetries.c_str());
    std::fflush(stdout);
  }

  Words words_;
  std::map<std::string, Shares> total_;
  std::array<std::vector<double>, 2> times_;      // of reconstructions, by the clock [ms]
  std::array<std::vector<double>, 2> to_grasps_;  // from one view: ranked, and the surest [ms]
};

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    prehend::bench::Benchmark(prehend::bench::read({words + 1, words + count})).run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "views_benchmark: %s\n", error.what());
    return 1;
  }
}

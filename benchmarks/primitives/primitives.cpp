// Whether primitives are a property of the object, and how close they come to it:
//
//   primitives_benchmark FILE... [--quick] [--details]
//   primitives_benchmark FILE... --sheet FILE.png
//
// The primitives of each mesh (in metres), and those of the same mesh moved, scaled, with finer and
// coarser triangles, with noise, with holes, and seen from one side: how many of them have the same
// kinds in the same numbers, and how far they are from those of the mesh as it is
// (distance_between). --quick: fewer repetitions. --details: also the kinds that differ. --sheet:
// pictures of the meshes with their primitives instead.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/primitives/changed_meshes.h"
#include "benchmarks/primitives/primitive_sets.h"
#include "benchmarks/support/percentile.h"
#include "benchmarks/support/resources.h"
#include "planner/show/picture/image.h"
#include "planner/show/primitives_picture.h"
#include "primitives/decompose.h"
#include "sim/base/input_error.h"
#include "sim/base/random.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/sphere_directions.h"

namespace prehend::bench {
namespace {

// What changes a mesh, and how its primitives are brought back for comparison.
struct Change {
  TriangleMesh mesh;
  Pose X_NO = Pose::Identity();  // how it was moved, before it was scaled
  double factor = 1.0;
};

struct Kind {
  const char* name;
  int repeats;
  std::function<Change(const TriangleMesh& mesh, int repeat, Random& random)> change;
};

// Of the edges of meshes that get noise or holes [m].
constexpr double kEdge = 3e-3;

std::vector<Kind> kinds(bool quick) {
  const auto noise = [](double deviation) {
    return [deviation](const TriangleMesh& mesh, int, Random& random) {
      return Change{with_noise(with_short_edges(mesh, kEdge), deviation, random)};
    };
  };
  const int few = quick ? 1 : 4;
  return {
      {"moved, scaled", few,
       [](const TriangleMesh& mesh, int, Random& random) {
         const Pose X_NO = random.pose(0.5);
         const double factor = std::exp(random.uniform(-1.0, 1.0));
         return Change{scaled_mesh(transformed(mesh, X_NO), factor), X_NO, factor};
       }},
      {"subdivided", 1,
       [](const TriangleMesh& mesh, int, Random&) {
         return Change{with_short_edges(mesh, kEdge)};
       }},
      {"decimated", 1,
       [](const TriangleMesh& mesh, int, Random&) {
         return Change{clustered(mesh, bounds(mesh).diagonal() / 50.0)};
       }},
      {"noise 0.5 mm", few, noise(0.5e-3)},
      {"noise 1 mm", quick ? 2 : few, noise(1e-3)},
      {"noise 2 mm", few, noise(2e-3)},
      {"5 holes", quick ? 2 : few,
       [](const TriangleMesh& mesh, int, Random& random) {
         return Change{with_holes(with_short_edges(mesh, kEdge), 5, 0.1, random)};
       }},
      {"one side", quick ? 4 : 8,
       [](const TriangleMesh& mesh, int repeat, Random&) {
         const Vector3 half = half_sphere_directions(4)[static_cast<std::size_t>(repeat % 4)];
         return Change{seen_from(with_short_edges(mesh, kEdge), repeat < 4 ? half : -half)};
       }},
  };
}

// How primitives of changed meshes are beside those of the mesh.
struct Tally {
  int same = 0;
  int tried = 0;
  std::vector<double> apart;  // mm
};

constexpr double kMillimetresPerMetre = 1e3;

void try_mesh(const std::string& file, const std::vector<Kind>& kinds, bool details,
              std::vector<Tally>& total) {
  const TriangleMesh mesh = load_mesh(file).mesh;
  const double start = benchmark::processor_seconds();
  const std::vector<Primitive> known = decompose(mesh, {}, {.threads = 1}).primitives;
  const double seconds = benchmark::processor_seconds() - start;
  const SurfaceResidual residual = residual_of(mesh, known);
  const std::size_t name = file.find_last_of('/') + 1;
  std::printf("%-20.20s %5.2f %6.2f %6.3f ", file.substr(name).c_str(),
              kMillimetresPerMetre * residual.median, kMillimetresPerMetre * residual.percentile_95,
              seconds);
  Random random(7);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    int same = 0;
    for (int i = 0; i < kinds[k].repeats; ++i) {
      const Change change = kinds[k].change(mesh, i, random);
      const std::vector<Primitive> found = decompose(change.mesh).primitives;
      const Pose X_NO = change.X_NO;
      const std::vector<Primitive> expected = moved_primitives(known, X_NO, change.factor);
      if (details && kinds_of(found) != kinds_of(known)) {
        std::printf("\n  %s: %s", kinds[k].name, kinds_text(found).c_str());
      }
      same += kinds_of(found) == kinds_of(known) ? 1 : 0;
      total[k].apart.push_back(kMillimetresPerMetre * distance_between(found, expected) /
                               change.factor);
    }
    total[k].same += same;
    total[k].tried += kinds[k].repeats;
    std::printf(" %d/%d", same, kinds[k].repeats);
    std::fflush(stdout);
  }
  std::printf("  %s\n", kinds_text(known).c_str());
}

int draw_sheet(const std::vector<std::string>& files, const std::string& sheet) {
  constexpr int kColumns = 3;
  std::vector<Image> pictures;
  for (const std::string& file : files) {
    const TriangleMesh mesh = load_mesh(file).mesh;
    pictures.push_back(primitives_picture(mesh, decompose(mesh), {.width = 600, .height = 300}));
  }
  write_png(sheet, grid(pictures, kColumns));
  return 0;
}

int run(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  std::string sheet;
  bool quick = false;
  bool details = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--sheet" && i + 1 < words.size()) {
      sheet = words[++i];
    } else if (word == "--quick") {
      quick = true;
    } else if (word == "--details") {
      details = true;
    } else if (word.starts_with("--")) {
      throw InputError({.field = word, .problem = "is no option"});
    } else {
      files.push_back(word);
    }
  }
  if (!sheet.empty()) return draw_sheet(files, sheet);
  const std::vector<Kind> tried = kinds(quick);
  std::vector<Tally> total(tried.size());
  std::printf("mesh, residual [mm]: median, 95 %%; seconds; the same kinds and numbers when");
  for (const Kind& kind : tried) std::printf(" | %s", kind.name);
  std::printf("\n");
  for (const std::string& file : files) try_mesh(file, tried, details, total);
  for (std::size_t k = 0; k < tried.size(); ++k) {
    std::printf("%-14s %3d of %3d the same (%.0f %%); apart %.2f mm in the median, 95 %% %.2f mm\n",
                tried[k].name, total[k].same, total[k].tried,
                100.0 * total[k].same / std::max(total[k].tried, 1),
                benchmark::percentile(total[k].apart, 0.5),
                benchmark::percentile(total[k].apart, 0.95));
  }
  return 0;
}

}  // namespace
}  // namespace prehend::bench

int main(int count, char** words) {
  try {
    return prehend::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "primitives: %s\n", error.what());
    return 1;
  }
}

// A box between two others on a shelf, made of arrays: where can a Barrett hand take it?
#include <array>
#include <iostream>
#include <prehend/prehend.h>
#include <vector>

namespace {

// The eight corners of a box that stands on z = 0, and twelve triangles between them.
prehend::TriangleMesh standing_box(double width, double depth, double height) {
  std::vector<prehend::Vector3> vertices;
  for (const double z : {0.0, height}) {
    for (const double y : {-depth / 2.0, depth / 2.0}) {
      for (const double x : {-width / 2.0, width / 2.0}) vertices.emplace_back(x, y, z);
    }
  }
  return prehend::make_mesh(vertices, {{0, 2, 3},
                                       {0, 3, 1},
                                       {4, 5, 7},
                                       {4, 7, 6},
                                       {0, 1, 5},
                                       {0, 5, 4},
                                       {2, 6, 7},
                                       {2, 7, 3},
                                       {0, 4, 6},
                                       {0, 6, 2},
                                       {1, 3, 7},
                                       {1, 7, 5}});
}

}  // namespace

int main() {
  const prehend::TriangleMesh box = standing_box(0.06, 0.08, 0.16);  // m
  prehend::Scene scene = prehend::make_scene(
      prehend::make_graspable("tea", box, prehend::Material::plastic, 0.25), "barrett");
  for (const double side : {-1.0, 1.0}) {
    prehend::add_obstacle(scene, side < 0.0 ? "flour" : "rice", box,
                          prehend::translation({side * 0.12, 0.0, 0.0}));
  }

  const prehend::CompiledScene ready = prehend::compile(scene);
  prehend::PlanOptions options;
  options.rank.top = 3;
  const prehend::PlanResult result = prehend::plan(ready, options);

  for (const prehend::ScoredGrasp& grasp : result.grasps) {
    std::cout << "epsilon " << grasp.trial.epsilon.lower << ", " << grasp.trial.contacts.size()
              << " contacts, hand at " << grasp.trial.X_OH.translation().transpose()
              << " m: " << prehend::origin_text(grasp, result) << "\n";
  }
  for (const prehend::CollisionCount& blocker : result.blockers) {
    std::cout << blocker.count << " times " << blocker.link << " met " << blocker.by << "\n";
  }
  prehend::RunRecord record;
  record.scene = scene.name;
  record.options = options;
  prehend::write_file("grasps.json", prehend::grasps_json(ready, result, record));
  prehend::write_file("report.html", prehend::report_html(plan_report(ready, result, record)));
  return result.grasps.empty() ? 1 : 0;
}

// A box between two others on a shelf: where can a Barrett hand take it?
#include <iostream>
#include <prehend/prehend.h>

int main() {
  const prehend::TriangleMesh box = prehend::make_box({0.06, 0.08, 0.16});  // m
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

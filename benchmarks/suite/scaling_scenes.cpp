#include "benchmarks/suite/scaling_scenes.h"

#include "sim/base/random.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/object_generator.h"

namespace prehend::bench {

Scene mug_scene(int triangles) {
  return make_scene(make_graspable("mug", generate_object("mug", triangles), Material::plastic),
                    "barrett");
}

CompiledScene scene_of_triangles(int triangles) { return compile(mug_scene(triangles)); }

CompiledScene scene_of_candidates() {
  return compile(
      make_scene(make_graspable("bottle", generate_object("bottle", 2000), Material::plastic),
                 "parallel_jaw_wide"));
}

Scene scene_among(int obstacles) {
  // Farther away than the hand is at any pre-grasp [m].
  constexpr double kNearest = 0.6;
  constexpr double kFarthest = 1.2;
  Scene scene = mug_scene(5000);
  Random random(1);
  for (int i = 0; i < obstacles; ++i) {
    const Vector3 at = random.vector(kNearest, kFarthest);
    add_obstacle(scene, "box_" + std::to_string(i), make_box(Vector3::Constant(0.02)),
                 translation(at));
  }
  return scene;
}

CompiledScene scene_of_obstacles(int obstacles) { return compile(scene_among(obstacles)); }

}  // namespace prehend::bench

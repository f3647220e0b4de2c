// Scenes of any size.
#pragma once

#include "sim/scene/compiled_scene.h"

namespace prehend::bench {

// A mug of about so many triangles and a Barrett hand, as it is before compile.
Scene mug_scene(int triangles);
CompiledScene scene_of_triangles(int triangles);

// A bottle and a parallel jaw, whose trials cost little.
CompiledScene scene_of_candidates();

// A mug and a Barrett hand among so many boxes of 20 mm, which are near but not in the way. Always
// the same ones.
Scene scene_among(int obstacles);
CompiledScene scene_of_obstacles(int obstacles);

}  // namespace prehend::bench

#include "planner/protocol/session_film.h"

namespace prehend {

void add_moment(SceneFilm& film, const Session& session) {
  const EditedScene& world = *session.state().world;
  const SurfaceIds& surfaces = world.surfaces();
  film.add({.scene = world.scene(),
            .object = surfaces.object,
            .obstacles = surfaces.obstacles,
            .robots = surfaces.robots,
            .X_WH = session.X_WH(),
            .joints = session.state().hand.joints});
}

std::string session_glb(const SceneFilm& film) { return film.glb("session", kSecondsPerCommand); }

}  // namespace prehend

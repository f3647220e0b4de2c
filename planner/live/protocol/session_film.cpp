#include "planner/live/protocol/session_film.h"

namespace prehend {

void add_moment(SceneFilm& film, const Session& session) {
  const EditedScene& world = *session.state().world;
  const SurfaceIds& surfaces = world.surfaces();
  const CompiledArm* arm = session.arm();
  const std::optional<ArmPosture>& posture = session.state().arm;
  const bool has_arm = arm != nullptr && posture.has_value();
  film.add(
      {.scene = world.scene(),
       .object = surfaces.object,
       .obstacles = surfaces.obstacles,
       .robots = surfaces.robots,
       .X_WH = session.X_WH(),
       .joints = session.state().hand.joints,
       .arm_joints = has_arm ? joint_values(arm->robot(), posture->dofs) : std::vector<double>()});
}

std::string session_glb(const SceneFilm& film) { return film.glb("session", kSecondsPerCommand); }

}  // namespace prehend

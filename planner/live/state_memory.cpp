#include "planner/live/state_memory.h"

#include <variant>

namespace prehend {
namespace {

template <typename Value>
std::size_t bytes_of(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}

std::size_t bytes_of(const ShapeSource& source) {
  const auto* written = std::get_if<WrittenShapesSource>(&source);
  return written == nullptr ? 0 : written->geometry.size();
}

std::size_t bytes_of(const Trial& trial) {
  std::size_t bytes = bytes_of(trial.contacts) + bytes_of(trial.joints);
  for (const DofValues& posture : trial.arm_line) bytes += sizeof(DofValues) + bytes_of(posture);
  return bytes;
}

}  // namespace

void StateMemory::add(const TriangleMesh& mesh) {
  bytes_ += bytes_of(mesh.vertices) + bytes_of(mesh.triangles);
}

void StateMemory::add(const Robot& robot) {
  bytes_ += bytes_of(robot.links) + bytes_of(robot.joints);
  for (const Link& link : robot.links) add(link.mesh);
}

void StateMemory::add(const CollisionBody& body) {
  bytes_ += sizeof(body) + bytes_of(body.probes);
  if (is_new(&body.mesh.data())) bytes_ += body.mesh.memory();
}

void StateMemory::add(const EditedScene* world) {
  if (world == nullptr || !is_new(world)) return;
  add(world->base().get());
  const Scene& scene = world->scene();
  bytes_ += sizeof(EditedScene) + bytes_of(scene.object.source);
  add(scene.object.mesh);
  for (const StaticBody& body : scene.obstacles) {
    bytes_ += sizeof(body) + bytes_of(body.source);
    add(body.mesh);
  }
  add(scene.hand);
  if (scene.carrier) {
    for (const MountedRobot& mounted : scene.carrier->platform.robots) add(mounted.robot);
  }
  if (!world->is_ready()) return;
  const CompiledScene& compiled = world->compiled();
  bytes_ += sizeof(compiled);
  for (const PlacedBody& body : compiled.bodies) add(body);
  for (const CompiledLink& link : compiled.links) add(link);
  if (!compiled.arm) return;
  add(compiled.arm->robot());
  bytes_ += bytes_of(compiled.arm->hand_pairs) + bytes_of(compiled.arm->arm_pairs);
  for (const PlacedBody& body : compiled.arm->bodies) add(body);
  for (const CompiledLink& link : compiled.arm->links) add(link);
}

void StateMemory::add(const PlanResult* results) {
  if (results == nullptr || !is_new(results)) return;
  bytes_ += sizeof(*results) + bytes_of(results->tried) + bytes_of(results->primitives);
  for (const ScoredGrasp& grasp : results->grasps) {
    bytes_ += sizeof(grasp) + bytes_of(grasp.trial);
    if (grasp.free) bytes_ += bytes_of(*grasp.free);
    if (!grasp.path) continue;
    for (const auto& posture : grasp.path->positions)
      bytes_ += sizeof(DofValues) + bytes_of(posture);
  }
}

}  // namespace prehend

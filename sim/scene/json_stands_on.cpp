#include "sim/scene/json_stands_on.h"

#include <optional>
#include <string>
#include <vector>

#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/base/nearest_name.h"
#include "sim/scene/stand_on.h"

namespace prehend {
namespace {

// Puts a body on the obstacle that the field names.
void put_down(const JsonField& body, const TriangleMesh& mesh,
              const std::vector<StaticBody>& obstacles, Pose& X_WB) {
  if (!body.has("stands_on")) return;
  const JsonField field = body["stands_on"];
  const std::string name = field.text();
  std::vector<std::string> known;
  for (const StaticBody& obstacle : obstacles) {
    known.push_back(obstacle.name);
    if (obstacle.name != name) continue;
    const std::optional<Pose> down = lowered_onto(mesh, X_WB, obstacle.mesh, obstacle.X_WB);
    if (!down)
      field.fail("must have " + name +
                 " below the body: it would fall past that; move it in \"pose\"");
    X_WB = *down;
    return;
  }
  field.fail("must be an obstacle; " + did_you_mean(name, known) + "there are " +
             (known.empty() ? std::string("none") : joined(known)));
}

// Of a robot, that part which no joint moves, in the frame of its base.
TriangleMesh standing_part(const MountedRobot& base) {
  TriangleMesh part;
  for (const Link& link : base.robot.links) {
    if (link.joint < 0) append(part, transformed(link.mesh, base.X_MR));
  }
  return part;
}

}  // namespace

void put_down_all(const JsonField& root, Scene& scene) {
  if (root.has("object")) {
    put_down(root["object"], scene.object.mesh, scene.obstacles, scene.object.X_WO);
  }
  if (root.has("objects")) {
    for (const JsonField& field : root["objects"].items()) {
      const std::string name = field["name"].text();
      if (name == scene.object.name) {
        put_down(field, scene.object.mesh, scene.obstacles, scene.object.X_WO);
        continue;
      }
      for (StaticBody& other : scene.obstacles) {
        if (other.name == name) put_down(field, other.mesh, scene.obstacles, other.X_WB);
      }
    }
  }
  if (!scene.carrier || !root["robot"].has("stands_on")) return;
  const TriangleMesh base = standing_part(scene.carrier->platform.robots.front());
  if (base.empty()) root["robot"]["stands_on"].fail("the robot has no link that stands still");
  put_down(root["robot"], base, scene.obstacles, scene.carrier->X_WB);
}

}  // namespace prehend

#include "planner/live/surface_ids.h"

#include <bit>
#include <cstdint>
#include <string_view>

#include "sim/base/formatted.h"

namespace prehend {
namespace {

// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits), of words instead of bytes.
class Fingerprint {
 public:
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3ULL; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char letter : text)
      add(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
  }
  void add(const Vector3& v) {
    for (const double x : v) add(x);
  }
  void add(const Pose& pose) {
    for (const double x : pose.matrix().reshaped()) add(x);
  }
  void add(const TriangleMesh& mesh) {
    add(static_cast<std::uint64_t>(mesh.vertices.size()));
    for (const Vector3& v : mesh.vertices) add(v);
    for (const Triangle& t : mesh.triangles) {
      for (const int i : t) add(static_cast<std::uint64_t>(i));
    }
  }
  void add(const Robot& robot) {
    add(std::string_view(robot.name));
    for (const Joint& joint : robot.joints) {
      add(static_cast<std::uint64_t>(joint.parent + 1));
      add(joint.X_PJ);
      add(joint.axis);
      add(joint.zero);
      add(joint.X_JA);
    }
    for (const Link& link : robot.links) {
      add(static_cast<std::uint64_t>(link.joint + 1));
      add(std::string_view(link.name));
      add(std::string_view(link.material));
      add(link.mesh);
    }
  }

  // A multiplication spreads bits upwards only; the shift brings the high ones down.
  std::string text() const {
    const std::uint64_t mixed = hash_ ^ hash_ >> 32U;
    return formatted("%016llx", static_cast<unsigned long long>(mixed));
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::string id_of(const TriangleMesh& mesh) {
  Fingerprint print;
  print.add(mesh);
  return print.text();
}

}  // namespace

SurfaceIds surface_ids(const Scene& scene) {
  SurfaceIds ids;
  if (!scene.object.mesh.empty()) ids.object = id_of(scene.object.mesh);
  for (const StaticBody& body : scene.obstacles) ids.obstacles.push_back(id_of(body.mesh));
  Fingerprint robots;
  robots.add(scene.hand);
  if (scene.carrier) {
    robots.add(scene.carrier->X_WB);
    robots.add(std::string_view(scene.carrier->platform.name));
    for (const double start : scene.carrier->start) robots.add(start);
  }
  ids.robots = robots.text();
  return ids;
}

}  // namespace prehend

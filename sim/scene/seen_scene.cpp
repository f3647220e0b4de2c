#include "sim/scene/seen_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/scene/collision_body.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/cloud/unseen_space.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

constexpr double kSupportGap = 2e-4;  // between the object and what it stands on [m]

std::string name_of_thing(std::size_t at) { return "object" + std::to_string(at + 1); }

TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Vector3& vertex : mesh.vertices) vertex += by;
  return mesh;
}

TriangleMesh only_seen(const SeenObject& thing) {
  TriangleMesh mesh{.vertices = thing.mesh.vertices, .triangles = {}};
  for (std::size_t t = 0; t < thing.mesh.triangles.size(); ++t) {
    if (thing.seen[t] != 0) mesh.triangles.push_back(thing.mesh.triangles[t]);
  }
  return mesh;
}

double area(const TriangleMesh& mesh, const Triangle& triangle) {
  const auto corner = [&](int k) -> const Vector3& {
    return mesh.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
  };
  return 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
}

double completed_share(const SeenObject& thing) {
  double all = 0.0;
  double completed = 0.0;
  for (std::size_t t = 0; t < thing.mesh.triangles.size(); ++t) {
    const double size = area(thing.mesh, thing.mesh.triangles[t]);
    all += size;
    if (thing.seen[t] == 0) completed += size;
  }
  return all > 0.0 ? completed / all : 0.0;
}

CollisionBody body_of(const TriangleMesh& mesh) {
  return make_collision_body({}, mesh, check_mesh(mesh).solid());
}

// A point of the plane in the world.
Vector3 point_on(const SupportPlane& plane) {
  if (plane.outline_W.empty()) return {0.0, 0.0, plane.height};
  return plane.outline_W.front();
}

// How far the lowest vertex of the mesh is above the plane [m].
double least_height(const TriangleMesh& mesh_W, const SupportPlane& plane) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& vertex : mesh_W.vertices) {
    least = std::min(least, plane.normal_W.dot(vertex - point_on(plane)));
  }
  return least;
}

// The slab, its upper face this far below the plane [m].
StaticBody support_slab(const SupportPlane& plane, double below) {
  constexpr double kBeyond = 0.5;  // m
  constexpr double kThickness = 0.05;
  const Vector3 across = any_orthogonal(plane.normal_W);
  Matrix3 axes;
  axes << across, plane.normal_W.cross(across), plane.normal_W;
  Bounds bounds;
  for (const Vector3& corner : plane.outline_W) {
    const Vector3 p = axes.transpose() * corner;
    bounds.lower = bounds.lower.cwiseMin(p);
    bounds.upper = bounds.upper.cwiseMax(p);
  }
  if (plane.outline_W.empty()) {
    bounds.lower = axes.transpose() * point_on(plane);
    bounds.upper = bounds.lower;
  }
  const Vector3 size(bounds.size().x() + 2.0 * kBeyond, bounds.size().y() + 2.0 * kBeyond,
                     kThickness);
  Vector3 middle = bounds.center();
  middle.z() = plane.normal_W.dot(point_on(plane)) - below - 0.5 * kThickness;
  StaticBody slab;
  slab.name = "support";
  slab.mesh = make_box(size);
  slab.X_WB = pose_from(axes, axes * middle);
  slab.source = WrittenShapesSource{formatted(
      R"([{"shape": "box", "size": [%.17g, %.17g, %.17g]}])", size.x(), size.y(), size.z())};
  return slab;
}

// What unseen sides are taken from.
const char* evidence(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::none:
      break;
    case Symmetry::mirror:
      return "a mirror";
    case Symmetry::two_mirrors:
      return "two mirrors";
    case Symmetry::revolution:
      return "revolution";
  }
  return "its widths";
}

void add_support(const SupportPlane& plane, const SeenObject& thing, Scene& scene) {
  constexpr double kNoted = 0.003;  // m
  double least = 0.0;
  for (const TriangleMesh* mesh : {&thing.mesh, &thing.thin, &thing.thick}) {
    if (!mesh->empty()) least = std::min(least, least_height(*mesh, plane));
  }
  scene.obstacles.push_back(support_slab(plane, kSupportGap - least));
  // Without the sign of a zero.
  const double tenths = std::round(1e4 * plane.height) + 0.0;
  scene.notes.push_back(formatted("the support is a plane at z = %.1f mm, tilted by %.1f deg",
                                  0.1 * tenths, plane.tilt * 180.0 / std::numbers::pi));
  if (-least > kNoted) {
    scene.notes.push_back(formatted("%s reaches %.1f mm into the support, which is taken as lower",
                                    scene.object.name.c_str(), -1000.0 * least));
  }
}

// Whether the shapes of another thing stand clear of the object.
void add_other(const SeenObject& other, const std::string& name, const CollisionBody& object,
               Scene& scene) {
  const std::array<TriangleMesh, 3> shapes = {other.mesh, other.thin, only_seen(other)};
  constexpr std::array<const char*, 3> kTaken = {"", "its thin shape", "what was seen of it"};
  const Vector3 middle = bounds(other.mesh).center();
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (shapes[k].empty()) continue;
    StaticBody body;
    body.name = name;
    body.mesh = moved(shapes[k], -middle);
    body.X_WB = translation(middle);
    body.material = Material::plastic;
    body.source = scene.object.source;
    const Pose X_OB = scene.object.X_WO.inverse() * body.X_WB;
    if (bodies_overlap(object, body_of(body.mesh), X_OB)) continue;
    if (k > 0) {
      scene.notes.push_back(name + " is taken as " + kTaken[k] + ": more would overlap " +
                            scene.object.name);
    }
    scene.obstacles.push_back(std::move(body));
    return;
  }
  scene.notes.push_back(name + " is left out: it overlaps " + scene.object.name);
}

}  // namespace

SeenThings seen_things(const ViewsInput& input, const RunContext& context) {
  SeenThings things{reconstruct(input.views, input.steps, context), {}, {}};
  things.unseen = std::make_shared<const UnseenSpace>(input.views);
  things.bodies.notes.insert(things.bodies.notes.begin(), input.notes.begin(), input.notes.end());
  return things;
}

SeenThings load_seen_things(const std::filesystem::path& file, const std::string& unit,
                            const RunContext& context) {
  try {
    SeenThings things = seen_things(load_views(file, unit), context);
    things.source = {std::filesystem::absolute(file).lexically_normal().string(),
                     unit.empty() ? "m" : unit};
    return things;
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
}

std::vector<std::string> seen_names(const SeenThings& things) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < things.bodies.objects.size(); ++i) names.push_back(name_of_thing(i));
  return names;
}

std::size_t seen_thing(const SeenThings& things, const std::string& asked) {
  const std::vector<std::string> names = seen_names(things);
  if (asked.empty()) return 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (asked == names[i] || asked == std::to_string(i + 1)) return i;
  }
  throw InputError({.field = "object",
                    .problem = "no such thing was seen; there is " + joined(names),
                    .value = asked});
}

void place_seen(const SeenThings& things, std::size_t at, Material material, double mass,
                Scene& scene) {
  const SeenObject& thing = things.bodies.objects[at];
  const Vector3 middle = bounds(thing.mesh).center();
  GraspableBody& object = scene.object;
  object = make_graspable(name_of_thing(at), moved(thing.mesh, -middle), material, mass);
  object.X_WO = translation(middle);
  object.completion = Completion{thing.seen, moved(thing.thin, -middle),
                                 moved(thing.thick, -middle), things.unseen};
  object.source = std::monostate{};
  if (!things.source.path.empty()) object.source = things.source;
  scene.notes.insert(scene.notes.end(), things.bodies.notes.begin(), things.bodies.notes.end());
  const std::size_t count = things.bodies.objects.size();
  scene.notes.push_back(
      formatted("%s of %zu seen, with %zu readings: %.0f %% of its surface is completed, by %s",
                object.name.c_str(), count, thing.readings, 100.0 * completed_share(thing),
                evidence(thing.symmetry)));
  const CollisionBody body = body_of(object.mesh);
  for (std::size_t i = 0; i < count; ++i) {
    if (i != at) add_other(things.bodies.objects[i], name_of_thing(i), body, scene);
  }
  if (things.bodies.plane) add_support(*things.bodies.plane, thing, scene);
}

}  // namespace prehend

#include "sim/shape/contact/soft_patch.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "sim/base/index.h"
#include "sim/shape/contact/triangle_overlap.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/triangle_distance.h"

// The pressure of the elastic foundation (Johnson 1985, section 4.3) is integrated triangle pair by
// triangle pair: the springs of one triangle of the link stand on it along its normal; the part of
// an object's triangle that is above it and nearer than the depth is a convex polygon, on which the
// compression is a linear function. The polygon is cut into triangles, over which a quadrature rule
// sums up the pressure. No grid of springs is made: force and centre of pressure are exact for the
// two meshes. Only the torsion is approximate, since the distance from the centre is not a
// polynomial.
namespace prehend {
namespace {

// The springs of one triangle of the link that one triangle of the object presses.
void add_pressed(const PlacedTriangle& object, const PlacedTriangle& link, const Pose& X_OL,
                 int triangle, double depth, std::vector<PressedPart>& parts) {
  const Corners& on_object = object.corner;
  const Vector3& outward = object.normal;
  const Vector3 up = X_OL.linear() * link.normal;
  // Cosine of the angle between the surfaces: springs are counted by the link's area, onto which
  // the object's area is projected. Surfaces that face the same way do not press on each other.
  const double facing = -outward.dot(up);
  if (facing <= 0.0) return;  // or one has no normal
  const Corners on_link = moved(link.corner, X_OL);
  Polygon pressed = over_face(on_link, up, on_object);
  cut(pressed, on_link[0], up);
  cut(pressed, on_link[0] + depth * up, -up);
  for (std::size_t k = 2; k < pressed.size; ++k) {
    PressedPart part;
    part.corners = {pressed.corner[0], pressed.corner[k - 1], pressed.corner[k]};
    const Vector3 edge = part.corners[1] - part.corners[0];
    const double area = 0.5 * facing * edge.cross(part.corners[2] - part.corners[0]).norm();
    if (area <= 0.0) continue;
    part.normal = -outward;
    part.triangle = triangle;
    // The rule of the edges' midpoints, each with a third of the area, is exact for quadratic
    // functions: for the linear pressure and for its moments, hence for the centre of pressure.
    for (std::size_t i = 0; i < 3; ++i) {
      part.gap[i] = (part.middle(i) - on_link[0]).dot(up);
      part.force[i] = area / 3.0 * (depth - part.gap[i]);
    }
    parts.push_back(part);
  }
}

// Lists the parts patch by patch. Parts whose triangles share a vertex of the object are connected.
// A patch has the number of its first vertex, so that patches come in an order that depends on the
// mesh alone. The parts of a patch keep theirs.
void order_by_patch(const TriangleMesh& object, SoftPatchWorkspace& workspace) {
  const auto triangle_of = [&](const PressedPart& part) -> const Triangle& {
    return object.triangles[index(part.triangle)];
  };
  DisjointSets& connected = workspace.connected;
  connected.extend(object.vertices.size());
  for (const PressedPart& part : workspace.parts) {
    const Triangle& t = triangle_of(part);
    connected.merge(index(t[0]), index(t[1]));
    connected.merge(index(t[0]), index(t[2]));
  }
  workspace.order.clear();
  for (std::size_t i = 0; i < workspace.parts.size(); ++i) {
    workspace.order.emplace_back(connected.find(index(triangle_of(workspace.parts[i])[0])), i);
  }
  // All single again, for the next time: few of the object's vertices were met.
  for (const PressedPart& part : workspace.parts) {
    for (const int v : triangle_of(part)) connected.separate(index(v));
  }
  std::sort(workspace.order.begin(), workspace.order.end());
}

Vector3 nearest_on_patch(const Vector3& p, const std::vector<PressedPart>& parts) {
  Vector3 nearest = parts.front().corners[0];
  for (const PressedPart& part : parts) {
    const Vector3 candidate = nearest_point_on(part.corners, p);
    if ((candidate - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = candidate;
  }
  return nearest;
}

// How far from `center` against `normal` the line of the resultant force meets a part, if it does.
std::optional<double> way_out_through(const PressedPart& part, const Vector3& center,
                                      const Vector3& normal) {
  // A line through an edge, as where a plate lies on an edge of the object, has to meet one of its
  // two parts in spite of rounding; still far below the contact threshold [m].
  constexpr double kBeside = 1e-9;
  // Parts that the line would only graze.
  constexpr double kLeastCosine = 1e-3;
  const double cosine = part.normal.dot(normal);
  if (cosine < kLeastCosine) return std::nullopt;
  Corners flat = part.corners;  // seen along the line
  for (Vector3& corner : flat) corner -= (corner - center).dot(normal) * normal;
  // Most parts are all on one side of the line.
  const Vector3 lower = flat[0].cwiseMin(flat[1]).cwiseMin(flat[2]).array() - kBeside;
  const Vector3 upper = flat[0].cwiseMax(flat[1]).cwiseMax(flat[2]).array() + kBeside;
  if ((center.array() < lower.array()).any() || (center.array() > upper.array()).any()) {
    return std::nullopt;
  }
  if ((nearest_point_on(flat, center) - center).norm() > kBeside) return std::nullopt;
  return (center - part.corners[0]).dot(part.normal) / cosine;
}

// The place of a contact with this resultant force. The centre of pressure lies off a curved
// surface; along the line of the force it is moved onto the patch, which changes no torque. (The
// point of the patch nearest to the centre would be beside that line, and under an edge of the
// object on either side of it, as rounding has it.)
Vector3 on_patch(const Vector3& center, const Vector3& normal,
                 const std::vector<PressedPart>& parts) {
  std::optional<double> out;
  for (const PressedPart& part : parts) {
    const std::optional<double> way = way_out_through(part, center, normal);
    if (way && (!out || *way > *out)) out = way;
  }
  // The line passes beside a patch with a hole.
  return out ? Vector3(center - *out * normal) : nearest_on_patch(center, parts);
}

// Sums up the forces of one patch.
SoftPatch resultant(const std::vector<PressedPart>& parts) {
  SoftPatch patch;
  Vector3 normal = Vector3::Zero();
  Vector3 center = Vector3::Zero();  // of pressure
  patch.gap = std::numeric_limits<double>::infinity();
  for (const PressedPart& part : parts) {
    for (std::size_t i = 0; i < 3; ++i) {
      patch.force += part.force[i];
      center += part.force[i] * part.middle(i);
      normal += part.force[i] * part.normal;
      patch.gap = std::min(patch.gap, part.gap[i]);
    }
  }
  center /= patch.force;
  patch.normal = normal.normalized();
  for (const PressedPart& part : parts) {
    for (std::size_t i = 0; i < 3; ++i) {
      // |arm x normal| is the distance from the normal through the centre.
      const Vector3 arm = part.middle(i) - center;
      patch.torsion += part.force[i] * arm.cross(patch.normal).norm() / patch.force;
    }
  }
  patch.position = on_patch(center, patch.normal, parts);
  return patch;
}

}  // namespace

void soft_patches(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                  double depth, SoftPatchWorkspace& workspace, std::vector<SoftPatch>& patches) {
  // Of pairs that are farther apart nothing is left when they are cut.
  find_pairs_maybe_within(object, link, X_OL, depth, workspace.pairs);
  workspace.parts.clear();
  for (const TrianglePair& pair : workspace.pairs) {
    add_pressed(object.triangles()[index(pair.a)], link.triangles()[index(pair.b)], X_OL, pair.a,
                depth, workspace.parts);
  }
  // Patches, and the parts of each, come in the order of mesh and pairs, so that sums are rounded
  // the same way each time.
  order_by_patch(object.mesh(), workspace);
  patches.clear();
  for (auto next = workspace.order.begin(); next != workspace.order.end();) {
    const std::size_t number = next->first;
    workspace.patch.clear();
    for (; next != workspace.order.end() && next->first == number; ++next) {
      workspace.patch.push_back(workspace.parts[next->second]);
    }
    const SoftPatch patch = resultant(workspace.patch);
    if (!(patch.force > 0.0)) continue;
    // Behind those that bear as much.
    const auto place =
        std::upper_bound(patches.begin(), patches.end(), patch,
                         [](const SoftPatch& a, const SoftPatch& b) { return a.force > b.force; });
    patches.insert(place, patch);
  }
  std::erase_if(patches, [&](const SoftPatch& patch) {
    return patch.force < kWeakestPatch * patches.front().force;
  });
}

}  // namespace prehend

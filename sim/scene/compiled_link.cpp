#include "sim/scene/compiled_link.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/link_pairs.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

// Most that the travel of a prismatic joint adds to a distance from the joint frame's origin [m].
double slide_of(const Joint& joint) {
  if (joint.type == JointType::revolute) return 0.0;
  return std::max(std::abs(joint.lower), std::abs(joint.upper));
}

// Distance of `p`, given in the joint frame, from the joint's axis [m]. The common axis z has its
// own formula because it rounds less.
double from_axis_of(const Joint& joint, const Vector3& p) {
  if (joint.axis == Vector3::UnitZ()) return std::hypot(p.x(), p.y());
  return joint.axis.cross(p).norm();
}

// For each joint of the path (base to tip), a bound on how far a point of the link can be from the
// joint's axis in any posture inside the limits [m]; 1 for a prismatic joint, which moves all
// points as far as itself.
//
// The bounds are found from the tip towards the base. For the last joint, the distances of the
// link's vertices from the axis and from the joint frame's origin are exact: its own turn changes
// neither, so that they can be taken at joint value 0. (The slide of a prismatic joint changes the
// latter, and is added.) For the joint before it, all points of the link lie in a ball around the
// last joint's origin with that radius, whatever the posture. So they are at most as far from an
// axis as the ball's centre is, plus the radius, and so on towards the base.
std::vector<double> reaches(const Robot& robot, const std::vector<int>& path,
                            const TriangleMesh& mesh) {
  std::vector<double> reach(path.size());
  double from_frame = 0.0;  // radius of the ball around the origin of the present joint frame [m]
  for (std::size_t k = path.size(); k-- > 0;) {
    const Joint& joint = robot.joints[index(path[k])];
    const Pose X_JA = across(joint, 0.0);
    double from_axis = 0.0;
    if (k + 1 == path.size()) {
      for (const Vector3& p : mesh.vertices) {
        const Vector3 q = X_JA * p;
        from_axis = std::max(from_axis, from_axis_of(joint, q));
        from_frame = std::max(from_frame, q.norm());
      }
    } else {
      const Vector3 next = X_JA * robot.joints[index(path[k + 1])].X_PJ.translation();
      from_axis = from_axis_of(joint, next) + from_frame;
      from_frame += next.norm();
    }
    from_frame += slide_of(joint);
    reach[k] = joint.type == JointType::revolute ? from_axis : 1.0;
  }
  return reach;
}

// The pad of a link; that of a link before it where both are the same, such as those of two like
// fingers.
std::shared_ptr<const PadCache> pad_of(const Robot& robot, const Link& link,
                                       const ProximityMesh& mesh,
                                       const std::vector<CompiledLink>& before) {
  if (!link.pad) return nullptr;
  for (const CompiledLink& other : before) {
    if (other.pad && other.pad->shape() == *link.pad &&
        other.mesh.mesh().vertices == mesh.mesh().vertices &&
        other.mesh.mesh().triangles == mesh.mesh().triangles) {
      return other.pad;
    }
  }
  try {
    return std::make_shared<const PadCache>(mesh, *link.pad);
  } catch (const InputError& error) {
    throw error.under("link " + link.name + ".pad").in_file(robot.name);
  }
}

}  // namespace

CompiledLink compile_link(const Scene& scene, const Robot& robot, const Link& link) {
  if (link.mesh.empty()) {
    throw InputError({robot.name, "link " + link.name, "has no triangles"});
  }
  const Material material = [&] {
    try {
      return material_named(link.material);
    } catch (const InputError& error) {
      throw error.under("link " + link.name).in_file(robot.name);
    }
  }();
  const double friction = scene.friction.between(material, scene.object.material);
  const double depth = scene.compliant_depths.between(material, scene.object.material);
  std::vector<int> joints = joints_to(robot, link.joint);
  std::vector<double> reach = reaches(robot, joints, link.mesh);
  CompiledLink compiled{make_collision_body(link.name, link.mesh, true), friction, depth,
                        std::move(joints), std::move(reach)};
  compiled.friction_deviation = scene.friction_deviations.between(material, scene.object.material);
  const auto own = std::find_if(scene.link_surfaces.begin(), scene.link_surfaces.end(),
                                [&](const LinkSurfaces& of) { return of.link == link.name; });
  const std::vector<MaterialRegion> none;
  compiled.surface = SurfaceMaterials(
      material, own == scene.link_surfaces.end() ? none : own->surfaces, compiled.mesh);
  return compiled;
}

std::vector<CompiledLink> compile_links(const Scene& scene, const Robot& robot) {
  require_sound(robot);
  std::vector<CompiledLink> links;
  for (const Link& link : robot.links) {
    CompiledLink compiled = compile_link(scene, robot, link);
    compiled.pad = pad_of(robot, link, compiled.mesh, links);
    links.push_back(std::move(compiled));
  }
  return links;
}

std::size_t shared_joints(const CompiledLink& a, const CompiledLink& b) {
  const auto differ =
      std::mismatch(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end());
  return static_cast<std::size_t>(differ.first - a.joints.begin());
}

std::vector<LinkPair> collision_pairs([[maybe_unused]] const std::vector<CompiledLink>& links,
                                      const Robot& robot) {
  assert(links.size() == robot.links.size());
  std::vector<LinkPair> pairs;
  for (const auto& [a, b] : checked_pairs(robot)) {
    pairs.push_back({link_id(index(a)), link_id(index(b))});
  }
  return pairs;
}

}  // namespace prehend

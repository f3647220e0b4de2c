#include "sim/scene/compiled_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// Where the frame after the joint is, in the frame before it, at joint value 0.
Pose at_zero(const Joint& joint) {
  return Pose(Eigen::AngleAxisd(joint.theta, Vector3::UnitZ())) *
         translation(Vector3(joint.a, 0.0, joint.d)) *
         Pose(Eigen::AngleAxisd(joint.alpha, Vector3::UnitX()));
}

// Most that a slide adds to a distance from the frame before the joint.
double slide_of(const Joint& joint) {
  if (joint.type == JointType::revolute) return 0.0;
  return std::max(std::abs(joint.lower), std::abs(joint.upper));
}

// Where the frame before the joint is in the frame after the one before it.
Vector3 after_the_one_before(const Robot& robot, int joint) {
  const Chain& chain = robot.chains[index(robot.joints[index(joint)].chain)];
  return joint == chain.first_joint ? Vector3(chain.X_PC.translation()) : Vector3::Zero();
}

// For each joint of the path, the most that a point of the link can be away from its axis.
std::vector<double> reaches(const Robot& robot, const std::vector<int>& path,
                            const TriangleMesh& mesh) {
  std::vector<double> reach(path.size());
  // Distances of the link's points from the last joint's axis and from the frame before it do not
  // depend on that joint's angle, so they are taken as they are at value 0.
  double from_axis = 0.0;
  double from_frame = 0.0;
  for (std::size_t k = path.size(); k-- > 0;) {
    const Joint& joint = robot.joints[index(path[k])];
    if (k + 1 == path.size()) {
      const Pose X = at_zero(joint);
      for (const Vector3& p : mesh.vertices) {
        const Vector3 q = X * p;
        from_axis = std::max(from_axis, std::hypot(q.x(), q.y()));
        from_frame = std::max(from_frame, q.norm());
      }
    } else {
      const Vector3 next = at_zero(joint) * after_the_one_before(robot, path[k + 1]);
      from_axis = std::hypot(next.x(), next.y()) + from_frame;
      from_frame += next.norm();
    }
    from_frame += slide_of(joint);
    reach[k] = joint.type == JointType::revolute ? from_axis : 1.0;
  }
  return reach;
}

CompiledLink compile_link(const Scene& scene, const Robot& robot, const Link& link) {
  if (link.mesh.empty()) {
    throw InputError(robot.name + ": link " + link.name + ": has no triangles");
  }
  const Material material = [&] {
    try {
      return material_named(link.material);
    } catch (const InputError& error) {
      throw InputError(robot.name + ": link " + link.name + ": " + error.what());
    }
  }();
  const double friction = scene.friction.between(material, scene.object.material);
  const double depth = scene.compliant_depths.between(material, scene.object.material);
  std::vector<int> joints = joints_to(robot, link.joint);
  std::vector<double> reach = reaches(robot, joints, link.mesh);
  return {make_collision_body(link.name, link.mesh, true), friction, depth, std::move(joints),
          std::move(reach)};
}

// True when joints, and nothing else, lie between link `a` and the link `b` further out.
bool is_before(const CompiledLink& a, const CompiledLink& b) {
  return a.joints.size() < b.joints.size() &&
         std::equal(a.joints.begin(), a.joints.end(), b.joints.begin());
}

}  // namespace

std::vector<CompiledLink> compile_links(const Scene& scene, const Robot& robot) {
  std::vector<CompiledLink> links;
  for (const Link& link : robot.links) links.push_back(compile_link(scene, robot, link));
  return links;
}

std::vector<LinkPair> separate_pairs(const std::vector<CompiledLink>& links) {
  const auto neighbours = [&](const CompiledLink& a, const CompiledLink& b) {
    const auto between = [&](const CompiledLink& c) { return is_before(a, c) && is_before(c, b); };
    return is_before(a, b) && std::none_of(links.begin(), links.end(), between);
  };
  std::vector<LinkPair> pairs;
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      const bool rigid = links[a].joints == links[b].joints;
      if (rigid || neighbours(links[a], links[b]) || neighbours(links[b], links[a])) continue;
      pairs.push_back({link_id(a), link_id(b)});
    }
  }
  return pairs;
}

}  // namespace prehend

#include "sim/scene/compiled_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/geometry/disjoint_sets.h"
#include "sim/geometry/input_error.h"
#include "sim/geometry/mesh_checks.h"

namespace prehend {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

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
      from_axis = std::abs(joint.a) + from_frame;
      from_frame += std::hypot(joint.a, joint.d);
    }
    from_frame += slide_of(joint);
    reach[k] = joint.type == JointType::revolute ? from_axis : 1.0;
  }
  return reach;
}

// One vertex of each connected component.
std::vector<Vector3> component_vertices(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.merge(index(t[0]), index(t[1]));
    sets.merge(index(t[0]), index(t[2]));
  }
  std::vector<bool> known(mesh.vertices.size(), false);
  std::vector<Vector3> vertices;
  for (const Triangle& t : mesh.triangles) {  // a vertex of no triangle is no part of the surface
    const std::size_t component = sets.find(index(t[0]));
    if (!known[component]) vertices.push_back(mesh.vertices[index(t[0])]);
    known[component] = true;
  }
  return vertices;
}

CompiledLink compile_link(const Scene& scene, const Link& link) {
  if (link.mesh.empty()) {
    throw InputError(scene.hand.name + ": link " + link.name + ": has no triangles");
  }
  const Material material = [&] {
    try {
      return material_named(link.material);
    } catch (const InputError& error) {
      throw InputError(scene.hand.name + ": link " + link.name + ": " + error.what());
    }
  }();
  const double friction = scene.friction.between(material, scene.object.material);
  const double depth = scene.compliant_depths.between(material, scene.object.material);
  std::vector<int> joints = joints_to(scene.hand, link.joint);
  std::vector<double> reach = reaches(scene.hand, joints, link.mesh);
  return {link.name, ProximityMesh(link.mesh), link.joint,       friction,
          depth,     std::move(joints),        std::move(reach), component_vertices(link.mesh)};
}

bool is_before(const CompiledLink& a, const CompiledLink& b) {
  return a.joints.size() < b.joints.size() &&
         std::equal(a.joints.begin(), a.joints.end(), b.joints.begin());
}

// Neighbours in a chain overlap at their joint by construction, and so do a chain's first link and
// the base; every other pair must stay apart.
std::vector<LinkPair> self_pairs(const std::vector<CompiledLink>& links) {
  const auto neighbours = [&](const CompiledLink& a, const CompiledLink& b) {
    const auto between = [&](const CompiledLink& c) { return is_before(a, c) && is_before(c, b); };
    return is_before(a, b) && std::none_of(links.begin(), links.end(), between);
  };
  std::vector<LinkPair> pairs;
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      const bool rigid = links[a].joints == links[b].joints;
      if (rigid || neighbours(links[a], links[b]) || neighbours(links[b], links[a])) continue;
      pairs.push_back({static_cast<int>(a), static_cast<int>(b)});
    }
  }
  return pairs;
}

std::vector<double> gaps_at(const CompiledScene& scene, const Preshape& preshape) {
  const Robot& hand = scene.scene.hand;
  std::vector<Pose> X_HL;
  link_poses(hand, joint_values(hand, preshape.dofs), X_HL);
  std::vector<double> gaps;
  for (const LinkPair& pair : scene.self_pairs) {
    const CompiledLink& a = scene.links[index(pair.a)];
    const CompiledLink& b = scene.links[index(pair.b)];
    const Pose X_AB = X_HL[index(pair.a)].inverse() * X_HL[index(pair.b)];
    gaps.push_back(find_gap(a.mesh, b.mesh, X_AB).lower);
    if (gaps.back() <= 0.0) {
      throw InputError(hand.name + ": preshape " + preshape.name + ": links " + a.name + " and " +
                       b.name + " collide");
    }
  }
  return gaps;
}

}  // namespace

CompiledScene compile(Scene scene) {
  if (!scene.hand.hand) throw InputError(scene.hand.name + ": hand: the robot is not a hand");
  const double radius = max_distance(scene.object.mesh, scene.object.center_of_mass);
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw InputError(scene.object.name + ": the object has no extent");
  }
  CompiledScene compiled{scene, ProximityMesh(scene.object.mesh), {}, {}, {}, {}, {}, {}, false};
  for (const Link& link : scene.hand.links) compiled.links.push_back(compile_link(scene, link));
  const Pose X_OW = scene.object.X_WO.inverse();
  for (const StaticBody& body : scene.obstacles) {
    compiled.obstacles.push_back({body.name, ProximityMesh(body.mesh), X_OW * body.X_WB,
                                  component_vertices(body.mesh), check_mesh(body.mesh).solid()});
  }
  compiled.self_pairs = self_pairs(compiled.links);
  for (const Preshape& preshape : scene.hand.hand->preshapes) {
    compiled.preshape_gaps.push_back(gaps_at(compiled, preshape));
  }
  compiled.wrench_frame = {scene.object.center_of_mass, 1.0 / radius};
  compiled.object_probes = component_vertices(scene.object.mesh);
  compiled.object_is_solid = check_mesh(scene.object.mesh).solid();
  return compiled;
}

}  // namespace prehend

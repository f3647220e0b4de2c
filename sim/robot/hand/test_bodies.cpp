#include "sim/robot/hand/test_bodies.h"

#include <algorithm>
#include <numbers>

#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

struct TestBody {
  std::string name;
  TriangleMesh mesh;  // x along the closing axis, z along the approach [m]
};

std::vector<TestBody> bodies_of(double width) {
  const double r = 0.5 * width;
  const Pose lies(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitX()));
  return {{"sphere", make_sphere(r, 2)},
          {"cylinder", transformed(make_cylinder(r, 1.5 * width, 24), lies)},
          {"box", make_box({width, 1.2 * width, width})}};
}

}  // namespace

int TestHolds::held() const {
  return static_cast<int>(std::count_if(bodies.begin(), bodies.end(),
                                        [](const Held& body) { return body.epsilon > 0.0; }));
}

double TestHolds::mean_epsilon() const {
  double sum = 0.0;
  for (const Held& body : bodies) sum += body.epsilon;
  return bodies.empty() ? 0.0 : sum / static_cast<double>(bodies.size());
}

std::vector<double> test_sizes(double width) { return {0.25 * width, 0.5 * width, 0.8 * width}; }

TestHolds try_bodies(const TestClosing& closing, const HandAxes& axes, std::size_t thumb,
                     const Preshape& open, const std::vector<double>& sizes) {
  constexpr double kBack = 0.25;  // of a size
  TestHolds holds;
  Pose X_BS = Pose::Identity();
  X_BS.linear() << axes.closing, axes.approach.cross(axes.closing), axes.approach;
  const auto at = [&](double distance) {
    Pose X = X_BS;
    X.translation() = axes.origin + distance * axes.approach;
    return X;
  };
  const double reach = closing.reach(axes.origin, axes.approach, open.dofs);
  for (const double size : sizes) {
    for (TestBody& body : bodies_of(size)) {
      TestHolds::Held& held = holds.bodies.emplace_back();
      held.body = body.name;
      held.width = size;
      if (size < open.min_width || size > open.max_width) continue;
      const ProximityMesh mesh(std::move(body.mesh));
      const double far = reach + size;
      const double way = closing.way_in(mesh, at(far), axes.approach, far, open.dofs);
      if (way < 0.0) continue;
      const double near = far - way;
      const auto held_at = [&](double distance) {
        const Pose X =
            closing.pushed(mesh, at(distance), axes.approach, open.max_width + size, open.dofs);
        return closing.hold(mesh, X, open.dofs, thumb);
      };
      held.epsilon = held_at(near);
      if (open.depth > near) held.epsilon = std::max(held.epsilon, held_at(open.depth));
      if (held.epsilon == 0.0) held.epsilon = held_at(near + kBack * size);
    }
  }
  return holds;
}

}  // namespace prehend

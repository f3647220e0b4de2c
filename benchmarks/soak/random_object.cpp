#include "benchmarks/soak/random_object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/make_mesh.h"
#include "sim/shape/object_generator.h"

namespace prehend::soak {
namespace {

// Uniform in the logarithm.
double log_uniform(Random& random, double lower, double upper) {
  return std::exp(random.uniform(std::log(lower), std::log(upper)));
}

Vector3 log_uniform_size(Random& random, double lower, double upper) {
  const double x = log_uniform(random, lower, upper);
  const double y = log_uniform(random, lower, upper);
  return {x, y, log_uniform(random, lower, upper)};
}

// Rings of `around` corners one above the other, joined and closed by a fan at each end.
TriangleMesh stacked(const std::vector<std::vector<Vector3>>& rings) {
  std::vector<Vector3> vertices;
  std::vector<Triangle> triangles;
  const int around = static_cast<int>(rings.front().size());
  for (const auto& ring : rings) vertices.insert(vertices.end(), ring.begin(), ring.end());
  const int last = static_cast<int>(rings.size()) - 1;
  for (int r = 0; r < last; ++r) {
    for (int i = 0; i < around; ++i) {
      const int a = r * around + i;
      const int b = r * around + (i + 1) % around;
      triangles.push_back({a, b, b + around});
      triangles.push_back({a, b + around, a + around});
    }
  }
  for (const int r : {0, last}) {
    Vector3 centre = Vector3::Zero();
    for (const Vector3& p : rings[static_cast<std::size_t>(r)]) centre += p / around;
    const int middle = static_cast<int>(vertices.size());
    vertices.push_back(centre);
    for (int i = 0; i < around; ++i) {
      const int a = r * around + i;
      const int b = r * around + (i + 1) % around;
      triangles.push_back(r == 0 ? Triangle{b, a, middle} : Triangle{a, b, middle});
    }
  }
  return make_mesh(std::move(vertices), std::move(triangles));
}

// A profile of random radii turned about z.
TriangleMesh revolved(Random& random) {
  const int sides = random.integer(3, 40);
  const int levels = random.integer(2, 8);
  const double height = random.uniform(0.03, 0.2);
  std::vector<std::vector<Vector3>> rings;
  for (int level = 0; level < levels; ++level) {
    const double radius = random.uniform(0.005, 0.05);
    rings.emplace_back();
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      rings.back().emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                height * level / (levels - 1));
    }
  }
  return stacked(rings);
}

// A star-shaped section that changes its size, place and turn from one end to the other.
TriangleMesh lofted(Random& random) {
  const int corners = random.integer(3, 14);
  const int levels = random.integer(2, 10);
  std::vector<double> radii;
  for (int i = 0; i < corners; ++i) radii.push_back(random.uniform(0.01, 0.045));
  const double height = random.uniform(0.02, 0.2);
  const double twist = random.uniform(-1.0, 1.0) / levels;
  const double lean = random.uniform(-0.05, 0.05);
  const double taper = random.uniform(0.3, 1.0);
  std::vector<std::vector<Vector3>> rings;
  for (int level = 0; level < levels; ++level) {
    const double up = static_cast<double>(level) / (levels - 1);
    const double scale = 1.0 + up * (taper - 1.0);
    rings.emplace_back();
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / corners + twist * level;
      const double radius = scale * radii[static_cast<std::size_t>(i)];
      rings.back().emplace_back(radius * std::cos(angle) + up * lean, radius * std::sin(angle),
                                up * height);
    }
  }
  return stacked(rings);
}

RandomObject base_shape(Random& random) {
  switch (random.index(8)) {
    case 0: {
      const int cells = random.integer(1, 6);
      return {make_box(log_uniform_size(random, 0.005, 0.2), cells), "box"};
    }
    case 1: {
      const double radius = log_uniform(random, 0.004, 0.08);
      const int sides = random.integer(3, 64);
      const double height = log_uniform(random, 0.005, 0.25);
      return {make_cylinder(radius, height, sides, random.integer(1, 5)), "cylinder"};
    }
    case 2: {
      const double radius = log_uniform(random, 0.005, 0.08);
      return {make_geodesic_sphere(radius, random.integer(1, 9)), "sphere"};
    }
    case 3:
      return {revolved(random), "revolved profile"};
    case 4: {
      // Twisted facets of a loft may cross one another.
      return {lofted(random), "loft", false};
    }
    default: {
      const std::vector<std::string> names = generated_object_names();
      const std::string& name = names[random.index(names.size())];
      return {generate_object(name, random.integer(300, 1800)), name};
    }
  }
}

TriangleMesh scaled(TriangleMesh mesh, const Vector3& factor) {
  for (Vector3& p : mesh.vertices) p = p.cwiseProduct(factor);
  return mesh;
}

double largest_size(const TriangleMesh& mesh) { return bounds(mesh).size().maxCoeff(); }

// The triangles that stay when each is dropped with the probability `share`; at least two.
std::vector<Triangle> thinned(Random& random, const std::vector<Triangle>& triangles,
                              double share) {
  std::vector<Triangle> left;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool dropped = random.uniform() < share;
    if (!dropped || left.size() + triangles.size() - t <= 2) left.push_back(triangles[t]);
  }
  return left;
}

void add_noise(Random& random, RandomObject& object) {
  const double most = largest_size(object.mesh) * log_uniform(random, 1e-5, 0.03);
  for (Vector3& p : object.mesh.vertices) p += random.in_box(most);
  object.words += ", noise";
  object.solid = false;
}

void double_triangles(Random& random, RandomObject& object) {
  const std::size_t count = object.mesh.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (random.index(6) == 0) object.mesh.triangles.push_back(object.mesh.triangles[t]);
  }
  object.words += ", doubled triangles";
}

void turn_triangles(Random& random, RandomObject& object) {
  for (Triangle& t : object.mesh.triangles) {
    if (random.index(4) == 0) std::swap(t[1], t[2]);
  }
  object.words += ", turned triangles";
}

void add_other(Random& random, RandomObject& object) {
  const RandomObject other = base_shape(random);
  const double apart = random.index(3) == 0 ? 1.2 : 0.4;
  const Vector3 by = apart * largest_size(object.mesh) * random.direction();
  append(object.mesh, transformed(other.mesh, pose_from(random.rotation(), by)));
  object.words += " and " + other.words;
  object.solid = false;
}

void cut_open(Random& random, RandomObject& object) {
  object.mesh.triangles = thinned(random, object.mesh.triangles, random.uniform(0.01, 0.3));
  object.words += ", holes";
  object.solid = false;
}

// Half of the objects are as their shape is made; of the others, each has one fault of a mesh.
void spoil(Random& random, RandomObject& object) {
  switch (random.index(10)) {
    case 0:
      return add_noise(random, object);
    case 1:
      return cut_open(random, object);
    case 2:
      return double_triangles(random, object);
    case 3:
      return turn_triangles(random, object);
    case 4:
      return add_other(random, object);
    default:
      return;
  }
}

// Stretched in each direction, and of any size that is accepted; some flattened to a foil.
void resize(Random& random, RandomObject& object) {
  constexpr double kSmallest = 0.0021;
  constexpr double kLargest = 1.0;
  Vector3 factor = Vector3::Ones();
  if (random.index(2) == 0) factor = log_uniform_size(random, 0.5, 2.0);
  const std::size_t kind = random.index(12);
  if (kind == 0) factor[static_cast<Eigen::Index>(random.index(3))] = 0.01;
  object.mesh = scaled(std::move(object.mesh), factor);
  double size = largest_size(object.mesh);
  if (kind == 1) size = log_uniform(random, kSmallest, 0.02);
  if (kind == 2) size = log_uniform(random, 0.2, kLargest);
  size = std::clamp(size, kSmallest, kLargest);
  const double ratio = size / largest_size(object.mesh);
  object.mesh = scaled(std::move(object.mesh), Vector3::Constant(ratio));
  const Vector3 sizes = 1e3 * bounds(object.mesh).size();
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), ", %.3g x %.3g x %.3g mm", sizes.x(), sizes.y(),
                sizes.z());
  object.words += text.data();
}

}  // namespace

RandomObject random_object(Random& random) {
  RandomObject object = base_shape(random);
  spoil(random, object);
  resize(random, object);
  object.mesh = make_mesh(std::move(object.mesh.vertices), std::move(object.mesh.triangles));
  return object;
}

}  // namespace prehend::soak

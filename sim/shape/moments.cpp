#include "sim/shape/moments.h"

#include <cstddef>

namespace prehend {
namespace {

const Vector3& corner(const TriangleMesh& mesh, std::size_t t, std::size_t k) {
  return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
}

// Outer product v v^T.
Matrix3 square(const Vector3& v) { return v * v.transpose(); }

}  // namespace

// The factors are the exact integrals of polynomials over a tetrahedron.
void add_tetrahedron(Moments& sum, const Vector3& a, const Vector3& b, const Vector3& c) {
  const double sextuple = a.cross(b).dot(c);
  sum.zeroth += sextuple / 6.0;
  sum.first += sextuple / 24.0 * (a + b + c);
  sum.second += sextuple / 120.0 * (square(a) + square(b) + square(c) + square(a + b + c));
}

Moments solid_moments(const TriangleMesh& mesh) {
  Moments sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    add_tetrahedron(sum, corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2));
  }
  return sum;
}

// Exact integrals over a triangle.
Moments sheet_moments(const TriangleMesh& mesh) {
  Moments sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = 0.5 * doubled_area_vector(mesh, t).norm();
    const Vector3& a = corner(mesh, t, 0);
    const Vector3& b = corner(mesh, t, 1);
    const Vector3& c = corner(mesh, t, 2);
    sum.zeroth += area;
    sum.first += area / 3.0 * (a + b + c);
    sum.second += area / 12.0 * (square(a) + square(b) + square(c) + square(a + b + c));
  }
  return sum;
}

Moments shifted(const Moments& body, const Vector3& by) {
  const Matrix3 mixed = body.first * by.transpose();
  return {body.zeroth, body.first + body.zeroth * by,
          body.second + mixed + mixed.transpose() + body.zeroth * square(by)};
}

}  // namespace prehend

// Integrals of 1, x and x x^T over bodies: what mass, centre of mass and inertia are made of.
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The integrals over a body (a volume, or a surface). Those of disjoint bodies add up.
struct Moments {
  double zeroth = 0.0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();

  Vector3 center() const { return first / zeroth; }
  // The second central moment of a mass of 1.
  Matrix3 spread() const { return second / zeroth - center() * center().transpose(); }
  // Inertia about the centre for a mass of 1: the trace of the spread times the identity minus the
  // spread.
  Matrix3 unit_inertia() const {
    const Matrix3 about_center = spread();
    return about_center.trace() * Matrix3::Identity() - about_center;
  }
  // Adds `factor` times the integrals of another body.
  void add(double factor, const Moments& other) {
    zeroth += factor * other.zeroth;
    first += factor * other.first;
    second += factor * other.second;
  }
};

// Adds the tetrahedron with the corners 0, a, b and c, with negative sign when a, b, c are
// clockwise seen from outside.
void add_tetrahedron(Moments& sum, const Vector3& a, const Vector3& b, const Vector3& c);

// Of the solid that a closed surface bounds: sums over signed tetrahedra from the origin to each
// triangle, of which those outside the solid cancel.
Moments solid_moments(const TriangleMesh& mesh);

// Of mass on the triangles themselves.
Moments sheet_moments(const TriangleMesh& mesh);

// The body moved by `by`.
Moments shifted(const Moments& body, const Vector3& by);

}  // namespace prehend

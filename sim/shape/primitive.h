// Shape primitives that approximate parts of an object for the generation of candidate grasps:
// solids (box, sphere, cylinder, cone), and curves along what is thin (rim, bar).
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Lengths are in metres.

// The set |x| <= size.x / 2, |y| <= size.y / 2, |z| <= size.z / 2 in its own frame.
struct Box {
  Vector3 size = Vector3::Zero();
};

// The ball |p| <= radius in its own frame.
struct Sphere {
  double radius = 0.0;
};

// The set x^2 + y^2 <= radius^2, |z| <= height / 2 in its own frame.
struct Cylinder {
  double radius = 0.0;
  double height = 0.0;
};

// A cone without its tip, or with it (one of the radii may be 0): the set |z| <= height / 2,
// x^2 + y^2 <= r(z)^2, where r(z) goes linearly from radius_low at -height / 2 to radius_high at
// height / 2.
struct Cone {
  double radius_low = 0.0;
  double radius_high = 0.0;
  double height = 0.0;
};

// A place on the edge of a thin wall.
struct RimPoint {
  Vector3 p = Vector3::Zero();        // on the edge, in the middle of the wall
  Vector3 into = Vector3::UnitZ();    // unit, from the edge into the wall
  Vector3 across = Vector3::UnitX();  // unit, normal of the wall, orthogonal to `into`
};

// The edge of a thin wall that is open to one side: the mouth of a bowl, the border of a sheet.
struct Rim {
  std::vector<RimPoint> points;  // along the edge, at least two
  double width = 0.0;            // thickness of the wall
  double depth = 0.0;            // how far the wall goes on behind the edge, at least
  bool closed = false;           // the last point is followed by the first
};

// Something long that is thin in both directions across, and may be bent: a handle, a loop.
struct Bar {
  std::vector<Vector3> points;  // along its middle, at least two
  double width = 0.0;           // largest size across
  bool closed = false;          // the last point is followed by the first
};

// Any of these.
using Shape = std::variant<Box, Sphere, Cylinder, Cone, Rim, Bar>;

// A shape and its pose in the object.
struct Primitive {
  Shape shape;
  Pose X_OP = Pose::Identity();  // pose of the primitive's frame in the object's
};

// "box", "sphere", "cylinder", "cone", "rim", "bar".
std::string_view shape_name(const Shape& shape);

// Whether it is a curve, a rim or a bar, and no solid.
bool is_curve(const Shape& shape);

// Signed distance [m] of the point p_O (object frame) from the surface of the primitive: negative
// inside, 0 on the surface. A curve is a tube around it, as wide as the rim or the bar, with round
// ends.
double signed_distance(const Primitive& primitive, const Vector3& p_O);

// Area of the whole surface, including the ends of a cylinder or a cone [m^2]; of a curve the side
// of its tube.
double surface_area(const Shape& shape);

// Length of a curve [m], from the last point back to the first where it is closed.
double curve_length(const std::vector<Vector3>& points, bool closed);

// The points of a rim.
std::vector<Vector3> points_of(const Rim& rim);

}  // namespace prehend

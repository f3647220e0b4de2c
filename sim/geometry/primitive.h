// Shape primitives (box, sphere, cylinder) that approximate parts of an object for the generation
// of candidate grasps.
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

// Any of the three.
using Shape = std::variant<Box, Sphere, Cylinder>;

// A shape and its pose in the object.
struct Primitive {
  Shape shape;
  Pose X_OP = Pose::Identity();  // pose of the primitive's frame in the object's
};

std::string_view shape_name(const Shape& shape);  // "box", "sphere", "cylinder"

// Signed distance [m] of the point p_O (object frame) from the surface of the primitive: negative
// inside, 0 on the surface.
double signed_distance(const Primitive& primitive, const Vector3& p_O);

// Area of the whole surface, including the ends of a cylinder [m^2].
double surface_area(const Shape& shape);

}  // namespace prehend

// The three shapes that stand for a piece of an object when grasps are proposed.
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

// The set |p| <= radius.
struct Sphere {
  double radius = 0.0;
};

// The set x^2 + y^2 <= radius^2, |z| <= height / 2.
struct Cylinder {
  double radius = 0.0;
  double height = 0.0;
};

using Shape = std::variant<Box, Sphere, Cylinder>;

// A shape where it is in the object.
struct Primitive {
  Shape shape;
  Pose X_OP = Pose::Identity();  // the primitive's frame in the object's
};

std::string_view shape_name(const Shape& shape);  // "box", "sphere", "cylinder"

// Distance of point p_O (object frame) from the primitive's surface: negative inside, 0 on it [m].
double signed_distance(const Primitive& primitive, const Vector3& p_O);

// Of the whole surface, ends of a cylinder included [m^2].
double surface_area(const Shape& shape);

}  // namespace prehend

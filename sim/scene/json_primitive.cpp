#include "sim/scene/json_primitive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "sim/base/range.h"

namespace prehend {
namespace {

// Sizes [m].
double positive(const JsonField& field) { return field.number(kLengthAbove0); }
double not_negative(const JsonField& field) { return field.number(kDistance); }

Box read_box(const JsonField& field) { return Box{field["size"].vector3(kLengthAbove0)}; }

Cone read_cone(const JsonField& field) {
  const Cone cone{not_negative(field["radius_low"]), not_negative(field["radius_high"]),
                  positive(field["height"])};
  if (cone.radius_low == 0.0 && cone.radius_high == 0.0) {
    field["radius_low"].fail("must be positive where radius_high is 0");
  }
  return cone;
}

// At least two points of a curve, none on the one before it.
std::vector<Vector3> read_points(const JsonField& field) {
  std::vector<Vector3> points;
  for (const JsonField& item : field.items()) {
    points.push_back(item.vector3(kCoordinate));
    if (points.size() > 1 && points.back() == points[points.size() - 2]) {
      item.fail("must differ from the point before");
    }
  }
  if (points.size() < 2) field.fail("must have at least two points");
  return points;
}

// A direction for each point.
std::vector<Vector3> read_directions(const JsonField& field, std::size_t count) {
  std::vector<Vector3> directions;
  for (const JsonField& item : field.items()) {
    const double length = item.vector3().norm();
    if (!(length > 0.0)) item.fail("must not be zero");
    directions.push_back(item.vector3() / length);
  }
  if (directions.size() != count) field.fail("must have as many vectors as points");
  return directions;
}

Rim read_rim(const JsonField& field) {
  const std::vector<Vector3> points = read_points(field["points"]);
  const std::vector<Vector3> into = read_directions(field["into"], points.size());
  const std::vector<Vector3> across = read_directions(field["across"], points.size());
  Rim rim{{}, positive(field["width"]), positive(field["depth"]), field["closed"].boolean()};
  constexpr double kRightAngle = 1e-3;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(into[i].dot(across[i])) > kRightAngle) {
      field["across"].items()[i].fail("must be at a right angle to the vector of \"into\"");
    }
    rim.points.push_back({points[i], into[i], across[i]});
  }
  return rim;
}

Bar read_bar(const JsonField& field) {
  return {read_points(field["points"]), positive(field["width"]), field["closed"].boolean()};
}

// The fields of each shape.
struct ShapeFields {
  std::string_view shape;
  std::vector<std::string_view> fields;
};

const std::array<ShapeFields, 6>& all_shapes() {
  static const std::array<ShapeFields, 6> shapes{
      {{"box", {"size"}},
       {"sphere", {"radius"}},
       {"cylinder", {"radius", "height"}},
       {"cone", {"radius_low", "radius_high", "height"}},
       {"rim", {"points", "into", "across", "width", "depth", "closed"}},
       {"bar", {"points", "width", "closed"}}}};
  return shapes;
}

Shape read_shape(const JsonField& field) {
  const std::string shape = field["shape"].text();
  if (shape == "box") return read_box(field);
  if (shape == "sphere") return Sphere{positive(field["radius"])};
  if (shape == "cylinder") {
    return Cylinder{positive(field["radius"]), positive(field["height"])};
  }
  if (shape == "cone") return read_cone(field);
  if (shape == "rim") return read_rim(field);
  return read_bar(field);
}

nlohmann::ordered_json vectors_to_json(const std::vector<Vector3>& vectors) {
  auto json = nlohmann::ordered_json::array();
  for (const Vector3& v : vectors) json.push_back(vector_to_json(v));
  return json;
}

void add_sizes(const Box& box, nlohmann::ordered_json& json) {
  json["size"] = vector_to_json(box.size);
}

void add_sizes(const Sphere& sphere, nlohmann::ordered_json& json) {
  json["radius"] = sphere.radius;
}

void add_sizes(const Cylinder& cylinder, nlohmann::ordered_json& json) {
  json["radius"] = cylinder.radius;
  json["height"] = cylinder.height;
}

void add_sizes(const Cone& cone, nlohmann::ordered_json& json) {
  json["radius_low"] = cone.radius_low;
  json["radius_high"] = cone.radius_high;
  json["height"] = cone.height;
}

void add_sizes(const Rim& rim, nlohmann::ordered_json& json) {
  std::vector<Vector3> into;
  std::vector<Vector3> across;
  for (const RimPoint& at : rim.points) {
    into.push_back(at.into);
    across.push_back(at.across);
  }
  json["points"] = vectors_to_json(points_of(rim));
  json["into"] = vectors_to_json(into);
  json["across"] = vectors_to_json(across);
  json["width"] = rim.width;
  json["depth"] = rim.depth;
  json["closed"] = rim.closed;
}

void add_sizes(const Bar& bar, nlohmann::ordered_json& json) {
  json["points"] = vectors_to_json(bar.points);
  json["width"] = bar.width;
  json["closed"] = bar.closed;
}

}  // namespace

Primitive read_primitive(const JsonField& field) {
  field.allow_only({"shape", "pose", "size", "radius", "height", "radius_low", "radius_high",
                    "points", "into", "across", "width", "depth", "closed"});
  const std::string shape = field["shape"].text();
  const auto known = std::find_if(all_shapes().begin(), all_shapes().end(),
                                  [&](const ShapeFields& s) { return s.shape == shape; });
  if (known == all_shapes().end()) {
    field["shape"].fail("unknown shape (known: box, sphere, cylinder, cone, rim, bar)");
  }
  // A size that belongs to the shape is required, and one that does not is an error: it would be
  // ignored without notice.
  for (const ShapeFields& other : all_shapes()) {
    for (const std::string_view name : other.fields) {
      const std::string key(name);
      const bool belongs =
          std::find(known->fields.begin(), known->fields.end(), name) != known->fields.end();
      if (belongs) (void)field[key];
      if (!belongs && field.has(key))
        field[key].fail(std::string("a ").append(shape).append(" has no ").append(key));
    }
  }
  return {read_shape(field), field.has("pose") ? read_pose(field["pose"]) : Pose::Identity()};
}

nlohmann::ordered_json primitive_to_json(const Primitive& primitive) {
  nlohmann::ordered_json json{{"shape", shape_name(primitive.shape)}};
  std::visit([&](const auto& shape) { add_sizes(shape, json); }, primitive.shape);
  json["pose"] = pose_to_json(primitive.X_OP);
  return json;
}

BeyondPlane read_beyond(const JsonField& field) {
  field.allow_only({"point", "normal"});
  return {field["point"].vector3(kCoordinate), field["normal"].direction()};
}

nlohmann::ordered_json beyond_to_json(const BeyondPlane& plane) {
  return {{"point", vector_to_json(plane.point_O)}, {"normal", vector_to_json(plane.normal_O)}};
}

}  // namespace prehend

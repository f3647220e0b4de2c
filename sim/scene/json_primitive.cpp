#include "sim/scene/json_primitive.h"

namespace prehend {
namespace {

// A size [m].
double positive(const JsonField& field) {
  if (!(field.number() > 0.0)) field.fail("must be positive");
  if (field.number() > kFarthestPosition) field.fail("must be at most 1e6 m");
  return field.number();
}

Shape read_shape(const JsonField& field) {
  const std::string shape = field["shape"].text();
  if (shape == "box") {
    const Box box{field["size"].vector3()};
    if (!(box.size.minCoeff() > 0.0)) field["size"].fail("must be positive");
    if (box.size.maxCoeff() > kFarthestPosition) field["size"].fail("must be at most 1e6 m");
    return box;
  }
  if (shape == "sphere") return Sphere{positive(field["radius"])};
  if (shape == "cylinder") {
    return Cylinder{positive(field["radius"]), positive(field["height"])};
  }
  field["shape"].fail("unknown shape (known: box, sphere, cylinder)");
}

}  // namespace

Primitive read_primitive(const JsonField& field) {
  field.allow_only({"shape", "size", "radius", "height", "pose"});
  // A size that belongs to the shape is required, and one that does not is an error: it would be
  // ignored without notice.
  for (const char* key : {"size", "radius", "height"}) {
    const std::string shape = field["shape"].text();
    const bool belongs = key == std::string("size")     ? shape == "box"
                         : key == std::string("height") ? shape == "cylinder"
                                                        : shape != "box";
    if (belongs) (void)field[key];
    if (!belongs && field.has(key)) field[key].fail("a " + shape + " has no " + key);
  }
  return {read_shape(field), field.has("pose") ? read_pose(field["pose"]) : Pose::Identity()};
}

nlohmann::ordered_json primitive_to_json(const Primitive& primitive) {
  nlohmann::ordered_json json{{"shape", shape_name(primitive.shape)}};
  if (const Box* box = std::get_if<Box>(&primitive.shape)) json["size"] = vector_to_json(box->size);
  if (const Sphere* sphere = std::get_if<Sphere>(&primitive.shape)) json["radius"] = sphere->radius;
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&primitive.shape)) {
    json["radius"] = cylinder->radius;
    json["height"] = cylinder->height;
  }
  json["pose"] = pose_to_json(primitive.X_OP);
  return json;
}

}  // namespace prehend

#include "sim/robot/files/urdf_geometry.h"

#include <algorithm>
#include <cmath>

#include "sim/base/formatted.h"
#include "sim/base/range.h"
#include "sim/robot/files/shape_mesh.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Shapes that programs added to the format are written with a prefix: drake:capsule.
std::string without_prefix(const std::string& tag) {
  const std::size_t colon = tag.find(':');
  return colon == std::string::npos ? tag : tag.substr(colon + 1);
}

// A part of a robot that is longer than this in metres is drawn in millimetres [m].
constexpr double kLargestPart = 10.0;
constexpr double kMillimetre = 1e-3;

}  // namespace

Pose urdf_origin(const XmlElement& element) {
  const std::optional<XmlElement> origin = element.child("origin");
  if (!origin) return Pose::Identity();
  const Vector3 p = origin->vector3_or("xyz", Vector3::Zero());
  const Vector3 rpy = origin->vector3_or("rpy", Vector3::Zero());
  if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) {
    origin->fail("is farther away than 1e6 m", origin->text("xyz"));
  }
  return translation(p) * Eigen::AngleAxisd(rpy.z(), Vector3::UnitZ()) *
         Eigen::AngleAxisd(rpy.y(), Vector3::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Vector3::UnitX());
}

Vector3 urdf_angles(const Matrix3& R) {
  const double yaw = std::hypot(R(0, 0), R(1, 0)) > 0.0 ? std::atan2(R(1, 0), R(0, 0)) : 0.0;
  const Matrix3 rest = Eigen::AngleAxisd(-yaw, Vector3::UnitZ()).toRotationMatrix() * R;
  return {std::atan2(-rest(1, 2), rest(1, 1)), std::atan2(-rest(2, 0), rest(0, 0)), yaw};
}

TriangleMesh UrdfGeometry::read(const XmlElement& link) {
  TriangleMesh mesh;
  for (const char* tag : {"collision", "visual"}) {
    for (const XmlElement& element : link.children(tag)) {
      const TriangleMesh shape = read_shape(element["geometry"]);
      append(mesh, transformed(shape, urdf_origin(element)));
      if (spent_ > kMostShapeTriangles) {
        element.fail("the shapes of the file must have at most " +
                     std::to_string(kMostShapeTriangles) + " triangles");
      }
    }
    if (mesh.empty()) continue;
    if (std::string_view(tag) == "visual") visual_links_.push_back(link.text("name"));
    break;
  }
  for (const Vector3& p : mesh.vertices) {
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) link.fail("reaches beyond 1e6 m");
  }
  return mesh;
}

TriangleMesh UrdfGeometry::read_shape(const XmlElement& geometry) {
  const std::vector<XmlElement> shapes = geometry.children();
  if (shapes.size() != 1) geometry.fail("must have one shape inside");
  const XmlElement& shape = shapes.front();
  const std::string kind = without_prefix(shape.name());
  if (kind == "mesh") return mesh_of(shape);
  if (is_flat(shape)) return {};
  TriangleMesh mesh = with_field_errors(shape, [&] {
    if (kind == "box") return make_box(shape.vector3("size"));
    if (kind == "sphere") return sphere_mesh(shape.number("radius"));
    if (kind == "cylinder") return cylinder_mesh(shape.number("radius"), shape.number("length"));
    if (kind == "capsule") return capsule_mesh(shape.number("radius"), shape.number("length"));
    if (kind == "ellipsoid") {
      return ellipsoid_mesh({shape.number("a"), shape.number("b"), shape.number("c")});
    }
    shape.fail("unknown shape, known are mesh, box, cylinder, sphere, capsule and ellipsoid");
  });
  spent_ += mesh.triangles.size();
  return mesh;
}

// Whether a size of it is 0, so that it has no volume and is left out.
bool UrdfGeometry::is_flat(const XmlElement& shape) {
  for (const char* attribute : {"size", "radius", "length", "a", "b", "c"}) {
    if (!shape.has(attribute)) continue;
    const std::vector<double> sizes = shape.numbers(attribute);
    if (std::find(sizes.begin(), sizes.end(), 0.0) == sizes.end()) continue;
    remarks_.push_back(shape.place() + ": " + attribute + " is 0: the shape is left out");
    return true;
  }
  return false;
}

TriangleMesh UrdfGeometry::mesh_of(const XmlElement& shape) {
  return with_field_errors(shape, [&] {
    const std::filesystem::path file =
        resolved_uri(shape.text("filename"), shape.file(), *packages_);
    TriangleMesh mesh = mesh_or_nothing(file);
    if (mesh.empty()) {
      remarks_.push_back(shape.place() + ": " + shape.text("filename") +
                         " has no triangles: it is left out");
      return mesh;
    }
    if (!shape.has("scale")) {
      const Bounds box = bounds(mesh);
      const double longest = (box.upper - box.lower).maxCoeff();
      if (longest < kLargestPart) return mesh;
      remarks_.push_back(shape.place() + ": " + shape.text("filename") +
                         formatted(" is %.4g long without a scale: read in mm", longest));
      return scaled(std::move(mesh), Vector3::Constant(kMillimetre));
    }
    const std::vector<double> factors = shape.numbers("scale");
    if (factors.size() == 1) return scaled(std::move(mesh), Vector3::Constant(factors[0]));
    return scaled(std::move(mesh), shape.vector3("scale"));
  });
}

}  // namespace prehend

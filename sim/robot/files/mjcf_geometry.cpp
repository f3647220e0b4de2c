#include "sim/robot/files/mjcf_geometry.h"

#include "sim/base/range.h"
#include "sim/robot/files/mjcf_fitting.h"
#include "sim/robot/files/package_folders.h"
#include "sim/robot/files/shape_mesh.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/convex_hull.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/make_mesh.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// What `fromto` says of a geom: where it is, and half its length.
struct Span {
  Pose X = Pose::Identity();
  double half_length = 0.0;
};

Span span_of(const XmlElement& at) {
  const std::vector<double> ends = at.numbers("fromto");
  if (ends.size() != 6) at.fail("attribute fromto must have 6 numbers", at.text("fromto"));
  const Vector3 from(ends[0], ends[1], ends[2]);
  const Vector3 to(ends[3], ends[4], ends[5]);
  const double length = (to - from).norm();
  if (!(length > 0.0 && length <= kFarthest)) {
    at.fail("the ends must be apart, by at most 1e6 m", at.text("fromto"));
  }
  const Matrix3 R =
      Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), (to - from) / length).toRotationMatrix();
  return {pose_from(R, 0.5 * (from + to)), 0.5 * length};
}

}  // namespace

MjcfGeometry::MjcfGeometry(const XmlElement& root, const MjcfDefaults& defaults)
    : defaults_(defaults) {
  for (const XmlElement& asset : root.children("asset")) {
    for (const XmlElement& mesh : asset.children("mesh")) {
      const std::string stem =
          mesh.has("file") ? std::filesystem::path(mesh.text("file")).stem().string() : "";
      const std::string name = mesh.text_or("name", stem);
      if (name.empty()) mesh.fail("attribute file is missing");
      meshes_.emplace(name, mesh);
    }
  }
}

bool MjcfGeometry::collides(const XmlElement& geom, const std::string& childclass) const {
  for (const char* mask : {"contype", "conaffinity"}) {
    const auto at = defaults_.saying(mask, geom, childclass);
    if (!at || at->number(mask) != 0.0) return true;
  }
  return false;
}

TriangleMesh MjcfGeometry::read(const std::vector<XmlElement>& geoms,
                                const std::string& childclass) {
  TriangleMesh mesh;
  for (const bool colliding : {true, false}) {
    for (const XmlElement& geom : geoms) {
      if (collides(geom, childclass) != colliding) continue;
      append(mesh, read_geom(geom, childclass));
      for (const Vector3& p : mesh.vertices) {
        if (!(p.cwiseAbs().maxCoeff() <= kFarthest)) geom.fail("reaches beyond 1e6 m");
      }
    }
    if (!mesh.empty()) break;
  }
  return mesh;
}

// The vertices that are written in the file, with their faces or else their hull.
TriangleMesh MjcfGeometry::read_written(const XmlElement& asset) {
  const std::vector<double> numbers = asset.numbers("vertex");
  if (numbers.size() % 3 != 0) asset.fail("attribute vertex must have three numbers a vertex");
  if (numbers.size() / 3 > kMostShapeTriangles) asset.fail("has too many vertices");
  std::vector<Vector3> vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    if (!(vertices.back().cwiseAbs().maxCoeff() <= kFarthest)) {
      asset.fail("a vertex is farther away than 1e6 m");
    }
  }
  if (!asset.has("face")) {
    TriangleMesh hull = convex_hull(vertices);
    if (hull.empty()) asset.fail("the vertices have no convex hull");
    return hull;
  }
  const std::vector<double> corners = asset.numbers("face");
  if (corners.size() % 3 != 0) asset.fail("attribute face must have three numbers a triangle");
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double v = corners[i];
    if (!(v >= 0.0 && v < static_cast<double>(vertices.size()))) {
      asset.fail("attribute face must name vertices that are there", std::to_string(v));
    }
    if (i % 3 == 0) triangles.emplace_back();
    triangles.back()[i % 3] = static_cast<int>(v);
  }
  return make_mesh(std::move(vertices), std::move(triangles));
}

TriangleMesh MjcfGeometry::read_asset(const XmlElement& geom, const std::string& childclass) {
  const XmlElement at = defaults_.saying("mesh", geom, childclass).value_or(geom);
  const auto found = meshes_.find(at.text("mesh"));
  if (found == meshes_.end()) at.fail("no mesh of this name in <asset>", at.text("mesh"));
  const XmlElement& asset = found->second;
  return with_field_errors(asset, [&] {
    const auto sized = defaults_.saying("scale", asset, "");
    if (asset.has("vertex")) {
      TriangleMesh written = read_written(asset);
      spent_ += written.triangles.size();
      return sized ? scaled(std::move(written), sized->vector3("scale")) : written;
    }
    const std::filesystem::path name = asset.text("file");
    const std::filesystem::path folder = defaults_.mesh_folder();
    TriangleMesh mesh = mesh_or_nothing(resolved_uri((folder / name).string(), asset.file(), {}));
    if (mesh.empty()) {
      remarks_.push_back(asset.place() + ": " + name.string() +
                         " has no triangles: it is left out");
      return mesh;
    }
    return sized ? scaled(std::move(mesh), sized->vector3("scale")) : mesh;
  });
}

TriangleMesh MjcfGeometry::read_geom(const XmlElement& geom, const std::string& childclass) {
  const auto with_type = defaults_.saying("type", geom, childclass);
  const bool has_mesh = defaults_.saying("mesh", geom, childclass).has_value();
  const std::string type = with_type ? with_type->text("type") : has_mesh ? "mesh" : "sphere";
  if (type == "plane") return {};
  Pose X = defaults_.pose(geom, childclass);
  if (type == "mesh") return transformed(read_asset(geom, childclass), X);
  const auto at = defaults_.saying("size", geom, childclass);
  std::vector<double> size;
  if (has_mesh) {
    const TriangleMesh whole = read_asset(geom, childclass);
    if (whole.empty()) return {};
    const FittedGeom fitted =
        with_field_errors(geom, [&] { return fitted_geom(whole, type, defaults_.fits_bounds()); });
    const auto factor = defaults_.saying("fitscale", geom, childclass);
    for (const double half : fitted.size) {
      size.push_back(half * (factor ? factor->number("fitscale") : 1.0));
    }
    X = X * fitted.X_MG;
  } else {
    if (!at) geom.fail("attribute size is missing");
    size = at->numbers("size");
  }
  if (const auto ends = defaults_.saying("fromto", geom, childclass); ends && !has_mesh) {
    const Span span = span_of(*ends);
    X = span.X;
    const bool round = type == "capsule" || type == "cylinder";
    size.resize(round ? 2 : 3, size.empty() ? 0.0 : size.front());
    size.back() = span.half_length;
  }
  const auto need = [&](std::size_t count) {
    if (size.size() < count) geom.fail("too few sizes for a " + type, at ? at->text("size") : "");
  };
  TriangleMesh mesh = with_field_errors(geom, [&] {
    if (type == "sphere") return need(1), sphere_mesh(size[0]);
    if (type == "capsule" && has_mesh && size[1] == 0.0) return sphere_mesh(size[0]);
    if (type == "capsule") return need(2), capsule_mesh(size[0], 2.0 * size[1]);
    if (type == "cylinder") return need(2), cylinder_mesh(size[0], 2.0 * size[1]);
    if (type == "box") return need(3), make_box({2.0 * size[0], 2.0 * size[1], 2.0 * size[2]});
    if (type == "ellipsoid") return need(3), ellipsoid_mesh({size[0], size[1], size[2]});
    geom.fail("unknown type, known are plane, sphere, capsule, ellipsoid, cylinder, box and mesh",
              type);
  });
  spent_ += mesh.triangles.size();
  if (spent_ > kMostShapeTriangles) {
    geom.fail("the shapes of the file must have at most " + std::to_string(kMostShapeTriangles) +
              " triangles");
  }
  return transformed(mesh, X);
}

}  // namespace prehend

// The geometry of a link of a URDF file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/package_folders.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Reads the geometry of all links of one file.
class UrdfGeometry {
 public:
  explicit UrdfGeometry(const PackageFolders& packages) : packages_(&packages) {}

  // What planning uses of a <link>, in its frame: the shapes of its <collision> elements or, where
  // it has none, those of its <visual> elements. Empty for a link without either. Mesh files that
  // are not used are not opened. Throws InputError that names the element's line.
  TriangleMesh read(const XmlElement& link);

  // Links whose visual geometry was taken.
  const std::vector<std::string>& visual_links() const { return visual_links_; }
  // Shapes that were left out or read in another unit, one sentence each.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  TriangleMesh read_shape(const XmlElement& geometry);
  TriangleMesh mesh_of(const XmlElement& shape);
  bool is_flat(const XmlElement& shape);

  const PackageFolders* packages_;
  std::size_t spent_ = 0;  // of kMostShapeTriangles
  std::vector<std::string> visual_links_;
  std::vector<std::string> remarks_;
};

// The pose of an <origin> inside the element, the identity where there is none: rotations about the
// fixed axes x, y, z in this order (roll, pitch, yaw). Throws InputError beyond 1e6 m.
Pose urdf_origin(const XmlElement& element);

// Those angles of a rotation. The yaw is taken out before the others are found, so that they make
// up for its rounding where the pitch is near a right angle.
Vector3 urdf_angles(const Matrix3& R);

}  // namespace prehend

// The geometry of the bodies of an MJCF file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/robot/files/mjcf_defaults.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// Reads the <geom> elements of one file.
class MjcfGeometry {
 public:
  // Reads the names of the meshes in <asset>, not their files. `defaults` must outlive this.
  MjcfGeometry(const XmlElement& root, const MjcfDefaults& defaults);

  // What planning uses of a body, in its frame: the geoms that take part in collisions (contype or
  // conaffinity is not 0) or, where there is none, all. Planes are left out. Throws InputError that
  // names the line: an unknown mesh or type, sizes that are missing.
  TriangleMesh read(const std::vector<XmlElement>& geoms, const std::string& childclass);

  // Meshes that were left out or taken in place of other shapes, one sentence each.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  TriangleMesh read_geom(const XmlElement& geom, const std::string& childclass);
  static TriangleMesh read_written(const XmlElement& asset);
  TriangleMesh read_asset(const XmlElement& geom, const std::string& childclass);
  bool collides(const XmlElement& geom, const std::string& childclass) const;

  const MjcfDefaults& defaults_;
  std::map<std::string, XmlElement> meshes_;
  std::vector<std::string> remarks_;
  std::size_t spent_ = 0;  // of kMostShapeTriangles
};

}  // namespace prehend

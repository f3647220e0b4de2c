// The geometry of bodies in models of MuJoCo, which takes the convex hull of every mesh.
#pragma once

#include <string>
#include <vector>

#include "sim/base/xml/xml_text.h"
#include "sim/scene/compiled_scene.h"
#include "sim/shape/box_shape.h"
#include "sim/shape/convex_pieces.h"

namespace prehend {

// The convex pieces of all bodies of a scene, in the bodies' frames: the same for all its grasps.
struct MjcfShapes {
  std::vector<TriangleMesh> object;
  std::vector<std::vector<TriangleMesh>> links;      // of the hand
  std::vector<std::vector<TriangleMesh>> obstacles;  // as in the scene
};

// Throws Cancelled.
MjcfShapes mjcf_shapes(const CompiledScene& scene, const ConvexPiecesOptions& options = {},
                       const RunContext& context = {});

// A convex piece in the file.
struct MjcfGeom {
  std::string name;
  std::string mesh;  // empty: a box
  PlacedBox box = {};
};

// Writes the elements <mesh> of a body's pieces, but for boxes, and returns what refers to them:
// BODY/0, BODY/1, ...
std::vector<MjcfGeom> write_meshes(XmlText& xml, const std::string& body,
                                   const std::vector<TriangleMesh>& pieces);

struct MjcfFriction {
  double coefficient = -1.0;  // negative: none of its own
  double torsion = 0.0;       // largest torque about the normal over the normal force [m]
};

// Writes the elements <geom>. MuJoCo takes friction from the geom of higher priority: those with a
// coefficient have it.
void write_geoms(XmlText& xml, const std::vector<MjcfGeom>& geoms, const MjcfFriction& friction,
                 const std::string& color);

// Writes elements <pair> with this coefficient for all pairs of geoms.
void write_pairs(XmlText& xml, const std::vector<MjcfGeom>& a, const std::vector<MjcfGeom>& b,
                 double friction);

}  // namespace prehend

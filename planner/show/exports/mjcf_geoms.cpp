#include "planner/show/exports/mjcf_geoms.h"

#include <algorithm>

#include "sim/base/number_text.h"

namespace prehend {
namespace {

bool same_mesh(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.vertices == b.vertices;
}

}  // namespace

MjcfShapes mjcf_shapes(const CompiledScene& scene, const ConvexPiecesOptions& options,
                       const RunContext& context) {
  MjcfShapes shapes;
  shapes.object = convex_pieces(scene.scene.object.mesh, options, context).pieces;
  const std::vector<Link>& links = scene.scene.hand.links;
  for (std::size_t l = 0; l < links.size(); ++l) {
    const auto same =
        std::find_if(links.begin(), links.begin() + static_cast<std::ptrdiff_t>(l),
                     [&](const Link& of) { return same_mesh(of.mesh, links[l].mesh); });
    const auto known = static_cast<std::size_t>(same - links.begin());
    if (known < l) {
      shapes.links.push_back(std::vector<TriangleMesh>(shapes.links[known]));
    } else {
      shapes.links.push_back(convex_pieces(links[l].mesh, options, context).pieces);
    }
  }
  for (const StaticBody& body : scene.scene.obstacles) {
    shapes.obstacles.push_back(convex_pieces(body.mesh, options, context).pieces);
  }
  return shapes;
}

std::vector<MjcfGeom> write_meshes(XmlText& xml, const std::string& body,
                                   const std::vector<TriangleMesh>& pieces) {
  std::vector<MjcfGeom> geoms;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::string name = body + "/" + std::to_string(k);
    if (const auto box = box_shape(pieces[k])) {
      geoms.push_back({name, "", *box});
      continue;
    }
    std::vector<double> numbers;
    for (const Vector3& p : pieces[k].vertices) {
      for (const double x : p) numbers.push_back(x);
    }
    xml.element("mesh", {{"name", name}, {"vertex", numbers_text(numbers)}});
    geoms.push_back({name, name, {}});
  }
  return geoms;
}

void write_geoms(XmlText& xml, const std::vector<MjcfGeom>& geoms, const MjcfFriction& friction,
                 const std::string& color) {
  for (const MjcfGeom& geom : geoms) {
    XmlAttributes attributes = {{"name", geom.name}};
    if (geom.mesh.empty()) {
      attributes.insert(attributes.end(),
                        {{"type", "box"},
                         {"size", vector_text(Vector3(0.5 * geom.box.size))},
                         {"pos", vector_text(Vector3(geom.box.X_MB.translation()))},
                         {"quat", quaternion_text(geom.box.X_MB)}});
    } else {
      attributes.insert(attributes.end(), {{"type", "mesh"}, {"mesh", geom.mesh}});
    }
    if (friction.coefficient >= 0.0) {
      attributes.insert(
          attributes.end(),
          {{"priority", "1"},
           {"friction", numbers_text({friction.coefficient, friction.torsion, 0.0})}});
    }
    if (friction.torsion > 0.0) attributes.emplace_back("condim", "4");
    attributes.emplace_back("rgba", color);
    xml.element("geom", attributes);
  }
}

void write_pairs(XmlText& xml, const std::vector<MjcfGeom>& a, const std::vector<MjcfGeom>& b,
                 double friction) {
  for (const MjcfGeom& first : a) {
    for (const MjcfGeom& second : b) {
      xml.element("pair", {{"geom1", first.name},
                           {"geom2", second.name},
                           {"friction", numbers_text({friction, friction, 0.0, 0.0, 0.0})}});
    }
  }
}

}  // namespace prehend

// A glTF document that is being gathered, for the functions that write .glb files.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "planner/show/picture/drawn_body.h"
#include "planner/show/picture/vertex_arrays.h"

namespace prehend {

// A place in a list of the document.
using GlbIndex = std::size_t;

// The lists of a document, and the buffer behind them. Geometries, materials and meshes of equal
// contents are stored once.
class GlbDocument {
 public:
  using Json = nlohmann::ordered_json;

  // Faces that meet at less than `crease_angle` [rad] are shaded as one round surface.
  explicit GlbDocument(double crease_angle) : crease_angle_(crease_angle) {}

  // The node's fields "translation" and "rotation". Throws InputError for a pose that is not
  // finite.
  static Json placed(const std::string& name, const Pose& X);
  // The mesh in a colour, as the field "mesh" of a node has it; -1 for a mesh without a triangle
  // that has area: the format has no empty meshes.
  int mesh_of(const SharedMesh& mesh, const Color& color);
  GlbIndex add_node(Json node);
  // The node `child` as one below `parent`; those that are below none are below the root.
  void put_below(GlbIndex parent, GlbIndex child);
  // Numbers of an animation, `size` a key: "SCALAR" (times, which are increasing), "VEC3" or
  // "VEC4".
  GlbIndex add_keys(const std::vector<float>& numbers, std::size_t size);
  // The document's only animation; empty lists: none.
  void set_animation(const std::string& name, Json samplers, Json channels);

  // The whole file. The root is called `name` and turns the world's z axis to glTF's y axis.
  std::string bytes(const std::string& name, const Json& extras) const;

 private:
  struct Geometry {
    SharedMesh mesh;
    Json primitive;  // POSITION, NORMAL and indices by accessor; null: nothing to show
  };

  int geometry_of(const SharedMesh& mesh);
  int coloured(int geometry, int material);
  int material_of(const Color& color);
  // Appends the elements to the buffer with a view of their own. `accessor` is complete but for the
  // view; returns its index. `target` 0: none.
  template <typename Element>
  std::size_t accessor_of(const std::vector<Element>& elements, int target, Json accessor);
  Json primitive_of(const VertexArrays& arrays);

  double crease_angle_;
  std::string buffer_;
  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json materials_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  Json animation_;
  std::vector<bool> is_child_;  // by node
  std::vector<Geometry> geometries_;
  std::map<std::pair<int, int>, int> mesh_numbers_;  // by geometry and material
};

}  // namespace prehend

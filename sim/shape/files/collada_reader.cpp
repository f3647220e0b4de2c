#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/base/number_text.h"
#include "sim/base/xml/xml_file.h"
#include "sim/shape/files/mesh_readers.h"
#include "sim/shape/files/text_scan.h"
#include "sim/shape/polygon.h"

// Elements are those of "COLLADA 1.4.1" (Khronos Group, 2008), chapter 5.
namespace prehend {
namespace {

// A whole number that fits an int.
int whole_number(const XmlElement& element, const std::string& what, double value) {
  constexpr double kLargest = 1e9;
  const bool whole = value >= 0.0 && value <= kLargest && value == std::floor(value);
  if (!whole) element.fail(what + " must be a whole number from 0 to 1e9", shortest_text(value));
  return static_cast<int>(value);
}

int count_of(const XmlElement& element, const char* attribute) {
  return whole_number(element, std::string("attribute ") + attribute, element.number(attribute));
}

std::vector<int> indices_of(const XmlElement& element) {
  std::vector<int> indices;
  for (const double value : element.content_numbers()) {
    indices.push_back(whole_number(element, "an entry", value));
  }
  return indices;
}

std::vector<double> numbers_of(const XmlElement& element, std::size_t count) {
  std::vector<double> numbers = element.content_numbers();
  if (numbers.size() != count) element.fail("must have " + std::to_string(count) + " numbers");
  return numbers;
}

// The id in an attribute "#id".
std::string reference(const XmlElement& element, const char* attribute) {
  std::string id = element.text(attribute);
  if (!id.starts_with('#')) element.fail("only parts of the same file can be referred to", id);
  return id.erase(0, 1);
}

Eigen::Affine3d look_at(const XmlElement& element) {
  const std::vector<double> n = numbers_of(element, 9);
  const Vector3 eye(&n[0]);
  const Vector3 back = (eye - Vector3(&n[3])).normalized();
  const Vector3 up = Vector3(&n[6]).normalized();
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.linear() << up.cross(back).normalized(), up, back;
  X.translation() = eye;
  return X;
}

Eigen::Affine3d rotation(const XmlElement& element) {
  const std::vector<double> n = numbers_of(element, 4);
  const Vector3 axis(n.data());
  const double angle = n[3] * std::numbers::pi / 180.0;
  if (angle == 0.0) return Eigen::Affine3d::Identity();
  if (axis.isZero(0.0)) element.fail("the axis has no length");
  return Eigen::Affine3d(Eigen::AngleAxisd(angle, axis.normalized()));
}

// The transform that an element inside a node states; none for other elements.
std::optional<Eigen::Affine3d> transform_of(const XmlElement& element) {
  const std::string kind = element.name();
  if (kind == "translate") {
    return Eigen::Affine3d(Eigen::Translation3d(Vector3(numbers_of(element, 3).data())));
  }
  if (kind == "scale") {
    return Eigen::Affine3d(Eigen::Scaling(Vector3(numbers_of(element, 3).data())));
  }
  if (kind == "rotate") return rotation(element);
  if (kind == "lookat") return look_at(element);
  if (kind == "skew") element.fail("is not supported");
  if (kind != "matrix") return std::nullopt;
  const std::vector<double> rows = numbers_of(element, 16);
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.affine() =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data()).topRows<3>();
  return X;
}

// Parts of a surface that are not read: polygons with holes, curved surfaces, and fans.
bool is_other_surface(const std::string& name) {
  return name == "ph" || name == "spline" || name == "brep" || name == "trifans";
}

// The elements of a document by kind and id.
class ColladaIds {
 public:
  explicit ColladaIds(const XmlElement& root) { add(root); }

  const XmlElement* find(const std::string& kind, const std::string& id) const {
    const auto found = elements_.find({kind, id});
    return found == elements_.end() ? nullptr : &found->second;
  }

  // The element of this kind that an attribute "#id" of `from` refers to.
  const XmlElement& at(const XmlElement& from, const char* attribute, const char* kind) const {
    const XmlElement* found = find(kind, reference(from, attribute));
    if (!found) from.fail(std::string("there is no ") + kind, from.text(attribute));
    return *found;
  }

 private:
  void add(const XmlElement& element) {
    if (is_other_surface(element.name())) {
      element.fail("is not supported: only polygons and strips are");
    }
    if (element.has("id")) {
      const bool fresh =
          elements_.emplace(std::pair(element.name(), element.text("id")), element).second;
      if (!fresh && element.name() == "node")
        element.fail("two nodes have the id", element.text("id"));
    }
    for (const XmlElement& child : element.children()) add(child);
  }

  std::map<std::pair<std::string, std::string>, XmlElement> elements_;
};

// Where an accessor finds element i of its array: numbers start + i * stride + axis[k].
std::vector<Vector3> points_of(const XmlElement& source, const ColladaIds& ids) {
  const XmlElement accessor = source["technique_common"]["accessor"];
  const XmlElement& array = ids.at(accessor, "source", "float_array");
  const std::vector<double> numbers = array.content_numbers();
  if (index(count_of(array, "count")) != numbers.size()) {
    array.fail("has " + std::to_string(numbers.size()) + " entries, not " + array.text("count"));
  }
  std::array<std::size_t, 3> axes{0, 1, 2};
  const std::vector<XmlElement> params = accessor.children("param");
  for (std::size_t k = 0; k < params.size(); ++k) {
    const std::size_t axis = std::string("XYZ").find(params[k].text_or("name", "-"));
    if (axis != std::string::npos) axes.at(axis) = k;
  }
  const std::size_t start = accessor.has("offset") ? index(count_of(accessor, "offset")) : 0;
  const std::size_t stride = accessor.has("stride") ? index(count_of(accessor, "stride")) : 1;
  const std::size_t count = index(count_of(accessor, "count"));
  if (stride <= *std::max_element(axes.begin(), axes.end()) || params.size() > stride) {
    accessor.fail("the stride is too small for its parameters");
  }
  if (start + count * stride > numbers.size()) {
    accessor.fail("reaches to entry " + std::to_string(start + count * stride) + " of " +
                  std::to_string(numbers.size()));
  }
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double* at = &numbers[start + i * stride];
    const Vector3 point(at[axes[0]], at[axes[1]], at[axes[2]]);
    points.push_back(point.cast<float>().cast<double>());
  }
  return points;
}

// The points of the element that the inputs of a mesh call vertices.
std::vector<Vector3> vertices_of(const XmlElement& vertices, const ColladaIds& ids) {
  for (const XmlElement& input : vertices.children("input")) {
    if (input.text("semantic") == "POSITION") {
      return points_of(ids.at(input, "source", "source"), ids);
    }
  }
  vertices.fail("there is no input POSITION");
}

// One of the elements triangles, polylist, polygons and tristrips. Triangulation takes O(n^2) time,
// hence the limit of corners.
class Primitive {
 public:
  Primitive(const XmlElement& element, const XmlElement& vertices) : element_(element) {
    std::optional<int> offset;
    for (const XmlElement& input : element.children("input")) {
      const int own = input.has("offset") ? count_of(input, "offset") : 0;
      stride_ = std::max(stride_, index(own) + 1);
      if (input.text("semantic") != "VERTEX") continue;
      offset = own;
      if (reference(input, "source") != vertices.text_or("id", "")) {
        input.fail("must refer to the vertices of the mesh", input.text("source"));
      }
    }
    if (!offset) element.fail("there is no input VERTEX");
    offset_ = index(*offset);
  }

  void add_to(TriangleMesh& mesh) const {
    const std::string kind = element_.name();
    const std::size_t count = index(count_of(element_, "count"));
    const std::vector<XmlElement> lists = element_.children("p");
    const bool single = kind == "triangles" || kind == "polylist";
    if (single ? lists.size() > 1 : lists.size() != count) fail(count);
    std::vector<int> sizes;
    if (kind == "polylist") {
      for (const XmlElement& list : element_.children("vcount")) sizes = indices_of(list);
    }
    if (kind == "triangles" && !lists.empty()) {
      // Nothing is made of a count that the text is too short for.
      if (count > lists.front().content().size()) fail(count);
      sizes.assign(count, 3);
    }
    if (single && sizes.size() != count) fail(count);
    if (single && lists.empty() && std::accumulate(sizes.begin(), sizes.end(), 0LL) > 0)
      fail(count);
    for (const XmlElement& list : lists) {
      const std::vector<int> corners = corners_in(list, mesh.vertices.size(), count);
      if (!single) {
        add_face(mesh, corners, kind == "tristrips");
        continue;
      }
      if (std::accumulate(sizes.begin(), sizes.end(), 0LL) != std::ssize(corners)) fail(count);
      auto next = corners.begin();
      for (const int size : sizes) {
        add_face(mesh, {next, next + size}, false);
        next += size;
      }
    }
  }

 private:
  [[noreturn]] void fail(std::size_t count) const {
    element_.fail("the index count does not fit the " + std::to_string(count) + " polygons");
  }

  // The vertices of a list, without the indices of its other inputs.
  std::vector<int> corners_in(const XmlElement& list, std::size_t vertices,
                              std::size_t count) const {
    const std::vector<int> indices = indices_of(list);
    if (indices.size() % stride_ != 0) fail(count);
    std::vector<int> corners;
    for (std::size_t i = offset_; i < indices.size(); i += stride_) {
      if (index(indices[i]) >= vertices) {
        list.fail("a face refers to vertex " + std::to_string(indices[i]) + " of " +
                  std::to_string(vertices));
      }
      corners.push_back(indices[i]);
    }
    return corners;
  }

  void add_face(TriangleMesh& mesh, std::span<const int> corners, bool strip) const {
    constexpr std::size_t kMostCorners = 10'000;
    if (strip) return add_strip(mesh, corners);
    if (corners.size() > kMostCorners) element_.fail("a face of more than 10000 corners");
    add_triangles(mesh, corners);
  }

  const XmlElement& element_;
  std::size_t stride_ = 1;  // indices of a corner, one for each offset of the inputs
  std::size_t offset_ = 0;  // of the index of the vertex
};

// Consecutive triangles with one symbol of a material.
struct SymbolTriangles {
  std::string symbol;
  std::size_t count = 0;
};

struct ColladaGeometry {
  NamedMesh named;
  std::vector<SymbolTriangles> symbols;  // of all triangles in their order
};

ColladaGeometry geometry_of(const XmlElement& geometry, const ColladaIds& ids) {
  const std::optional<XmlElement> mesh = geometry.child("mesh");
  ColladaGeometry whole;
  if (!mesh) return whole;
  NamedMesh& result = whole.named;
  const XmlElement vertices = (*mesh)["vertices"];
  result.mesh.vertices = vertices_of(vertices, ids);
  const std::string part = geometry.text_or("name", geometry.text_or("id", ""));
  for (const XmlElement& element : mesh->children()) {
    const std::string kind = element.name();
    if (kind == "triangles" || kind == "polylist" || kind == "polygons" || kind == "tristrips") {
      Primitive(element, vertices).add_to(result.mesh);
      const std::string symbol = element.text_or("material", "");
      const std::size_t count = result.mesh.triangles.size() - result.named;
      if (count > 0) whole.symbols.push_back({symbol, count});
      std::string name = symbol;
      name += ' ';
      name += part;
      result.name_rest(name);
    }
  }
  return whole;
}

// The diffuse colour of an effect that states it in numbers.
SurfaceColor diffuse_of(const XmlElement& effect) {
  const std::optional<XmlElement> profile = effect.child("profile_COMMON");
  const std::optional<XmlElement> technique = profile ? profile->child("technique") : std::nullopt;
  if (!technique) return std::nullopt;
  for (const XmlElement& shading : technique->children()) {
    const std::optional<XmlElement> diffuse = shading.child("diffuse");
    const std::optional<XmlElement> color = diffuse ? diffuse->child("color") : std::nullopt;
    if (!color) continue;
    const std::vector<double> numbers = color->content_numbers();
    if (numbers.size() != 3 && numbers.size() != 4) color->fail("must have 3 or 4 numbers");
    Eigen::Vector3f result;
    for (int k = 0; k < 3; ++k) {
      const std::optional<float> part = color_part(numbers[index(k)], 1.0);
      if (!part) color->fail("must be from 0 to 1", shortest_text(numbers[index(k)]));
      result[k] = *part;
    }
    return result;
  }
  return std::nullopt;
}

// The materials that an instance of a geometry or a controller binds, by their symbols.
std::map<std::string, const XmlElement*> bound_materials(const XmlElement& instance,
                                                         const ColladaIds& ids) {
  std::map<std::string, const XmlElement*> materials;
  const std::optional<XmlElement> bind = instance.child("bind_material");
  const std::optional<XmlElement> common = bind ? bind->child("technique_common") : std::nullopt;
  if (!common) return materials;
  for (const XmlElement& bound : common->children("instance_material")) {
    materials[bound.text("symbol")] = &ids.at(bound, "target", "material");
  }
  return materials;
}

SurfaceColor color_of_material(const XmlElement& material, const ColladaIds& ids) {
  const std::optional<XmlElement> effect = material.child("instance_effect");
  return effect ? diffuse_of(ids.at(*effect, "url", "effect")) : std::nullopt;
}

// The metres of a unit; a file that says nothing is in metres.
double unit_of(const XmlElement& root) {
  const std::optional<XmlElement> asset = root.child("asset");
  const std::optional<XmlElement> unit = asset ? asset->child("unit") : std::nullopt;
  const double metres = unit ? unit->number_or("meter", 1.0) : 1.0;
  if (!(metres > 0.0)) unit->fail("meter must be positive", unit->text("meter"));
  return metres;
}

// Walks through the nodes of a scene, and through those that they refer to.
class ColladaScene {
 public:
  ColladaScene(const XmlElement& root, bool colors) : ids_(root), colors_(colors) {
    for (const XmlElement& library : root.children("library_geometries")) {
      for (const XmlElement& geometry : library.children("geometry")) {
        geometries_.emplace(geometry.text_or("id", ""), geometry_of(geometry, ids_));
      }
    }
    const XmlElement instance = root["scene"]["instance_visual_scene"];
    const Eigen::Affine3d X_FileScene(Eigen::Scaling(unit_of(root)));
    for (const XmlElement& node : ids_.at(instance, "url", "visual_scene").children("node")) {
      add_node(node, X_FileScene);
    }
  }

  NamedMesh mesh() && { return std::move(mesh_); }

 private:
  void add_node(const XmlElement& node, Eigen::Affine3d X_FileNode) {
    constexpr int kMostNodes = 100'000;
    constexpr std::size_t kDeepest = 200;
    if (++nodes_ > kMostNodes) node.fail("the scene has more than 100000 nodes");
    if (open_.size() == kDeepest) node.fail("nodes are nested deeper than 200");
    const std::string id = node.text_or("id", "");
    if (!id.empty() && std::find(open_.begin(), open_.end(), id) != open_.end()) {
      node.fail("contains itself", id);
    }
    open_.push_back(id);
    const std::vector<XmlElement> children = node.children();
    for (const XmlElement& child : children) {
      if (const auto X = transform_of(child)) X_FileNode = X_FileNode * *X;
    }
    for (const XmlElement& child : children) {
      const std::string kind = child.name();
      if (kind == "instance_geometry") add_geometry(child, "url", child, X_FileNode);
      if (kind == "instance_controller") add_controller(child, X_FileNode);
    }
    for (const XmlElement& child : children) {
      if (child.name() == "node") add_node(child, X_FileNode);
      if (child.name() == "instance_node") add_node(ids_.at(child, "url", "node"), X_FileNode);
    }
    open_.pop_back();
  }

  // `instance` is what binds its materials.
  void add_geometry(const XmlElement& from, const char* attribute, const XmlElement& instance,
                    const Eigen::Affine3d& X) {
    constexpr std::size_t kMostVertices = 50'000'000;
    const auto found = geometries_.find(reference(from, attribute));
    if (found == geometries_.end()) from.fail("there is no geometry", from.text(attribute));
    const NamedMesh& part = found->second.named;
    if (mesh_.mesh.vertices.size() + part.mesh.vertices.size() > kMostVertices) {
      from.fail("more than 50 million vertices");
    }
    append(mesh_.mesh, part.mesh, X);
    for (const NamedTriangles& of : part.names) mesh_.add_name(of.name, of.count);
    if (colors_) add_colors(found->second.symbols, instance);
  }

  // A symbol that is not bound may be the id of a material.
  void add_colors(const std::vector<SymbolTriangles>& symbols, const XmlElement& instance) {
    const auto bound = bound_materials(instance, ids_);
    for (const SymbolTriangles& of : symbols) {
      const auto found = bound.find(of.symbol);
      const XmlElement* material =
          found != bound.end() ? found->second : ids_.find("material", of.symbol);
      mesh_.colors.insert(mesh_.colors.end(), of.count,
                          material != nullptr ? color_of(*material) : std::nullopt);
    }
  }

  // Found once for each material.
  const SurfaceColor& color_of(const XmlElement& material) {
    const auto [entry, fresh] = material_colors_.try_emplace(material.text("id"));
    if (fresh) entry->second = color_of_material(material, ids_);
    return entry->second;
  }

  // A controller deforms a geometry: as a skin moved by joints or as a mean of several shapes.
  void add_controller(const XmlElement& instance, const Eigen::Affine3d& X) {
    const XmlElement& controller = ids_.at(instance, "url", "controller");
    for (const char* kind : {"skin", "morph"}) {
      if (const auto deformed = controller.child(kind))
        add_geometry(*deformed, "source", instance, X);
    }
  }

  ColladaIds ids_;
  bool colors_;  // whether they are wanted
  std::map<std::string, ColladaGeometry> geometries_;
  std::map<std::string, SurfaceColor> material_colors_;  // by id
  std::vector<std::string> open_;                        // ids of the nodes around the present one
  int nodes_ = 0;
  NamedMesh mesh_;
};

}  // namespace

NamedMesh read_collada(const std::string& bytes, const std::filesystem::path& file, bool colors) {
  need_text(bytes);
  const XmlFile document(file, bytes);
  const XmlElement root = document.root();
  if (root.name() != "COLLADA") root.fail("is not the root of a COLLADA file");
  return ColladaScene(root, colors).mesh();
}

}  // namespace prehend

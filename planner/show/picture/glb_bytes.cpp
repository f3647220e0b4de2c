#include "planner/show/picture/glb_bytes.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "planner/show/picture/glb_document.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

void add_body(GlbDocument& document, const DrawnBody& body) {
  GlbDocument::Json node = GlbDocument::placed(body.name, body.X_WB);
  const int mesh = document.mesh_of(body.mesh, body.color);
  if (mesh < 0) return;
  node["mesh"] = mesh;
  document.add_node(std::move(node));
}

}  // namespace

std::string glb_bytes(const std::vector<DrawnBody>& bodies, const std::string& name,
                      const nlohmann::ordered_json& extras, double crease_angle) {
  GlbDocument document(crease_angle);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    try {
      add_body(document, bodies[b]);
    } catch (const InputError& error) {
      throw error.under("bodies[" + std::to_string(b) + "]");
    }
  }
  return document.bytes(name, extras);
}

}  // namespace prehend

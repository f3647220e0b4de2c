#include "planner/show/exports/moveit_scene.h"

#include <algorithm>
#include <string>
#include <vector>

#include "planner/show/exports/moveit_message.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

constexpr const char* kWorldFrame = "world";

class SceneWriter {
 public:
  explicit SceneWriter(YAML::Emitter& yaml) : yaml_(yaml), message_(yaml, RosVersion::ros2) {}

  void write(const Scene& scene) {
    yaml_ << YAML::BeginMap;
    key("name");
    put_text(yaml_, scene.name);
    write_allowed(scene);
    key("world");
    yaml_ << YAML::BeginMap;
    key("collision_objects");
    yaml_ << YAML::BeginSeq;
    write_body(scene.object.name, scene.object.mesh, scene.object.X_WO);
    for (const StaticBody& body : scene.obstacles) write_body(body.name, body.mesh, body.X_WB);
    yaml_ << YAML::EndSeq << YAML::EndMap;
    key("is_diff");
    yaml_ << true << YAML::EndMap;
  }

 private:
  void key(const char* name) { yaml_ << YAML::Key << name << YAML::Value; }

  // moveit_msgs/AllowedCollisionMatrix: the links of the hand with the object, by the
  // names of the robot's own description.
  void write_allowed(const Scene& scene) {
    std::vector<std::string> names = {scene.object.name};
    for (const Link& link : scene.hand.links) {
      const std::string& name = driver_name(link);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    key("allowed_collision_matrix");
    yaml_ << YAML::BeginMap;
    key("entry_names");
    put_texts(yaml_, names);
    key("entry_values");
    yaml_ << YAML::BeginSeq;
    for (std::size_t row = 0; row < names.size(); ++row) {
      yaml_ << YAML::Flow << YAML::BeginMap;
      key("enabled");
      yaml_ << YAML::BeginSeq;
      for (std::size_t column = 0; column < names.size(); ++column) {
        yaml_ << ((row == 0) != (column == 0));
      }
      yaml_ << YAML::EndSeq << YAML::EndMap;
    }
    yaml_ << YAML::EndSeq << YAML::EndMap;
  }

  // moveit_msgs/CollisionObject, to be added (operation 0).
  void write_body(const std::string& name, const TriangleMesh& mesh, const Pose& X_WB) {
    yaml_ << YAML::BeginMap;
    message_.header(kWorldFrame);
    key("pose");
    message_.pose(X_WB);
    key("id");
    put_text(yaml_, name);
    key("meshes");
    yaml_ << YAML::BeginSeq << YAML::BeginMap;
    key("triangles");
    yaml_ << YAML::BeginSeq;
    for (const Triangle& t : mesh.triangles) {
      yaml_ << YAML::Flow << YAML::BeginMap;
      key("vertex_indices");
      yaml_ << YAML::BeginSeq << t[0] << t[1] << t[2] << YAML::EndSeq << YAML::EndMap;
    }
    yaml_ << YAML::EndSeq;
    key("vertices");
    yaml_ << YAML::BeginSeq;
    for (const Vector3& v : mesh.vertices) put_vector(yaml_, v);
    yaml_ << YAML::EndSeq << YAML::EndMap << YAML::EndSeq;
    key("mesh_poses");
    yaml_ << YAML::BeginSeq;
    message_.pose(Pose::Identity());
    yaml_ << YAML::EndSeq;
    key("operation");
    yaml_ << 0 << YAML::EndMap;
  }

  YAML::Emitter& yaml_;
  MoveitMessage message_;
};

}  // namespace

std::string moveit_scene_yaml(const CompiledScene& scene) {
  YAML::Emitter yaml;
  SceneWriter(yaml).write(scene.scene);
  return yaml_text(yaml);
}

}  // namespace prehend

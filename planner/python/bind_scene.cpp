#include <map>
#include <pybind11/stl.h>
#include <utility>

#include "planner/python/arrays.h"
#include "planner/python/scene_handle.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/scene/json_mass.h"
#include "sim/scene/json_region.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/mesh_repair.h"

namespace prehend::python {
namespace {

py::tuple mesh_tuple(const TriangleMesh& mesh) {
  return py::make_tuple(to_array(mesh.vertices), to_array(mesh.triangles));
}

py::tuple load_mesh_in_python(const std::string& file, const std::string& unit) {
  TriangleMesh mesh = load_mesh(file, {.metres_per_unit = metres_per_unit(unit)}).mesh;
  orient_outward(mesh);
  return mesh_tuple(mesh);
}

// The regions that a list in JSON states.
std::vector<SurfaceRegion> regions_in_json(const char* argument, const std::string& list) {
  return read_regions(
      JsonFile("scene", "{\"" + std::string(argument) + "\": " + list + "}").root()[argument]);
}

SceneHandle load_scene_in_python(const std::string& name_or_file, const std::string& hand,
                                 const std::string& unit, bool repair, const std::string& object,
                                 const std::string& keep_out, const std::string& preferred,
                                 double apart) {
  const std::filesystem::path file = find_scene(name_or_file);
  const ObjectChoice choice{object, regions_in_json("keep_out", keep_out),
                            regions_in_json("preferred", preferred), apart};
  SceneHandle handle{
      load_scene(file, {.hand = hand, .unit = unit, .repair = repair, .choice = choice}), {}};
  handle.origin = {scene_reference(file), unit_of_source(file, handle.scene), hand, repair, choice};
  return handle;
}

SceneHandle make_scene_in_python(const Doubles& vertices, const Integers& faces,
                                 const std::string& hand, const std::string& name,
                                 const std::string& material, double mass, bool repair) {
  require(mass > 0.0,
          {.field = "mass", .problem = "must be positive", .value = std::to_string(mass)});
  TriangleMesh mesh = cleaned_mesh(vertices, faces);
  std::vector<std::string> notes;
  if (repair) {
    MeshRepair repaired = repair_mesh(mesh);
    if (std::string words = repair_text(repaired); !words.empty()) notes.push_back(words);
    mesh = std::move(repaired.mesh);
  }
  GraspableBody object = make_graspable(name, std::move(mesh), material_named(material), mass);
  SceneHandle handle{make_scene(std::move(object), hand), {}};
  handle.scene.notes = std::move(notes);
  note_uniform_mass(handle.scene);
  return handle;
}

// `text` is a JSON object with the fields of an object in a scene file that state its mass.
void set_mass_in_python(SceneHandle& self, const std::string& text) {
  const JsonFile file({}, text);
  const JsonField stated = file.root();
  stated.allow_only({"mass", "density", "center_of_mass", "parts"});
  GraspableBody& object = self.scene.object;
  GraspableBody changed =
      make_graspable(object.name, object.mesh, object.material, whole_mass(stated));
  read_mass(stated, changed);
  changed.X_WO = object.X_WO;
  changed.source = object.source;
  changed.restitution = object.restitution;
  changed.completion = object.completion;
  object = std::move(changed);
  note_uniform_mass(self.scene);
  self.origin = {};
}

// The origin of a scene is what a grasp file states, so that the program can load the same scene.
// After a change no file describes the scene, so the origin is cleared.
void add_obstacle_in_python(SceneHandle& self, const std::string& name, const Doubles& vertices,
                            const Integers& faces, const Doubles& X_WB,
                            const std::string& material) {
  add_obstacle(self.scene, name, cleaned_mesh(vertices, faces), pose_of(X_WB),
               material_named(material));
  self.origin = {};
}

// Where each degree of freedom starts, those that `asked` names elsewhere than the robots' files
// say. Throws InputError for an unknown name and a value outside the limits.
std::vector<double> start_of(const Platform& platform, std::map<std::string, double> asked) {
  std::vector<double> start;
  for (const MountedRobot& mounted : platform.robots) {
    for (const DegreeOfFreedom& dof : mounted.robot.dofs) {
      const std::string name = mounted.name + "/" + dof.name;
      const auto given = asked.find(name);
      start.push_back(given == asked.end() ? dof.initial : given->second);
      const bool inside = start.back() >= dof.lower && start.back() <= dof.upper;
      if (!inside) {
        throw InputError({.field = "start." + name,
                          .problem = "outside the limits " + std::to_string(dof.lower) + " to " +
                                     std::to_string(dof.upper) + " rad or m",
                          .value = std::to_string(start.back())});
      }
      if (given != asked.end()) asked.erase(given);
    }
  }
  if (!asked.empty()) {
    throw InputError({.field = "start",
                      .problem = "no degree of freedom of " + platform.name + " is called so",
                      .value = asked.begin()->first});
  }
  return start;
}

void mount_in_python(SceneHandle& self, const std::string& platform, const std::string& hand,
                     const Doubles& X_WB, const std::map<std::string, double>& start) {
  Scene mounted = self.scene;
  mount(mounted, platform, pose_of(X_WB), hand);
  mounted.carrier->start = start_of(mounted.carrier->platform, start);
  // Assigned last: where something above throws, the scene is as it was.
  self = {std::move(mounted), {}};
}

void save(SceneHandle& self, const std::string& file) {
  write_file(file, scene_text(self.scene));
  self.origin = {scene_reference(file), "m", "", true};
}

CompiledHandle compile_in_python(const SceneHandle& handle) {
  // Copies, because Python code may change the scene while another thread compiles it.
  Scene scene = handle.scene;
  CompiledHandle compiled{nullptr, handle.origin};
  const py::gil_scoped_release no_gil;
  compiled.scene = std::make_shared<const CompiledScene>(compile(std::move(scene)));
  return compiled;
}

void bind_bodies(py::module_& core) {
  py::class_<GraspableBody>(core, "GraspableBody", "The object to grasp; its frame is O.")
      .def_readonly("name", &GraspableBody::name)
      .def_property_readonly(
          "vertices", [](const GraspableBody& self) { return to_array(self.mesh.vertices); },
          "(V, 3), frame O [m].")
      .def_property_readonly(
          "faces", [](const GraspableBody& self) { return to_array(self.mesh.triangles); },
          "(F, 3): three vertices each, counter-clockwise seen from outside.")
      .def_property_readonly(
          "X_WO", [](const GraspableBody& self) { return to_array(self.X_WO); },
          "(4, 4): the object's pose in the world.")
      .def_property_readonly(
          "material", [](const GraspableBody& self) { return std::string(name_of(self.material)); },
          R"("glass", "metal", "plastic", "wood" or "rubber".)")
      .def_readonly("mass", &GraspableBody::mass, "[kg]")
      .def_property_readonly(
          "center_of_mass", [](const GraspableBody& self) { return to_array(self.center_of_mass); },
          "(3,), frame O [m].")
      .def_property_readonly(
          "mass_from",
          [](const GraspableBody& self) { return std::string(mass_basis_text(self.mass_basis)); },
          R"(What says where the mass is: "uniform density", which is a guess, "stated centre of mass"
"stated parts" or "named materials".)")
      .def_property_readonly(
          "inertia",
          [](const GraspableBody& self) { return to_array(Eigen::MatrixXd(self.inertia)); },
          "(3, 3), about the centre of mass, axes of O [kg m^2].");
  py::class_<StaticBody>(core, "StaticBody", "An obstacle.")
      .def_readonly("name", &StaticBody::name)
      .def_property_readonly(
          "vertices", [](const StaticBody& self) { return to_array(self.mesh.vertices); },
          "(V, 3), its own frame B [m].")
      .def_property_readonly(
          "faces", [](const StaticBody& self) { return to_array(self.mesh.triangles); }, "(F, 3).")
      .def_property_readonly(
          "X_WB", [](const StaticBody& self) { return to_array(self.X_WB); },
          "(4, 4): its pose in the world.")
      .def_property_readonly(
          "material", [](const StaticBody& self) { return std::string(name_of(self.material)); },
          "As of the object.");
}

void bind_scene_class(py::module_& core) {
  py::class_<SceneHandle>(core, "_Scene")
      .def_property_readonly("name", [](const SceneHandle& self) { return self.scene.name; })
      .def_property_readonly("notes", [](const SceneHandle& self) { return self.scene.notes; })
      .def_property_readonly("object", [](const SceneHandle& self) { return self.scene.object; })
      .def_property_readonly("hand", [](const SceneHandle& self) { return self.scene.hand; })
      .def_property_readonly("obstacles",
                             [](const SceneHandle& self) { return self.scene.obstacles; })
      .def_property_readonly("platform",
                             [](const SceneHandle& self) -> std::optional<std::string> {
                               if (!self.scene.carrier) return std::nullopt;
                               return self.scene.carrier->platform.name;
                             })
      .def("set_pose",
           [](SceneHandle& self, const Doubles& X_WO) {
             self.scene.object.X_WO = pose_of(X_WO);
             self.origin = {};
           })
      .def("set_friction",
           [](SceneHandle& self, const std::string& a, const std::string& b, double friction,
              std::optional<double> kinetic) {
             self.scene.friction.set(material_named(a), material_named(b), friction);
             self.scene.kinetic_friction.set(material_named(a), material_named(b), kinetic);
             self.origin = {};
           })
      .def("friction",
           [](const SceneHandle& self, const std::string& a, const std::string& b) {
             return self.scene.friction.between(material_named(a), material_named(b));
           })
      .def("set_mass", &set_mass_in_python)
      .def("mount", &mount_in_python)
      .def("add_obstacle", &add_obstacle_in_python)
      .def("save", &save)
      .def("text", [](const SceneHandle& self) { return scene_text(self.scene); });
  core.def("load_scene", &load_scene_in_python);
  core.def("scene_objects", [](const std::string& file, const std::string& unit) {
    return scene_objects(file, unit);
  });
  core.def("make_scene", &make_scene_in_python);
}

void bind_compiled_scene(py::module_& core) {
  py::class_<CompiledHandle>(
      core, "CompiledScene",
      "A scene made ready for trials. Immutable: it may be used from several "
      "threads at once. Made by compile().")
      .def_property_readonly(
          "name", [](const CompiledHandle& self) { return self.scene->scene.name; },
          "Of the scene.")
      .def_property_readonly(
          "hand", [](const CompiledHandle& self) { return self.scene->scene.hand; },
          "Robot: the hand that grasps.")
      .def_property_readonly(
          "object", [](const CompiledHandle& self) { return self.scene->scene.object; },
          "GraspableBody: what is grasped.")
      .def_property_readonly(
          "robot",
          [](const CompiledHandle& self) -> std::optional<Robot> {
            if (!self.scene->arm) return std::nullopt;
            return self.scene->arm->robot();
          },
          "Robot: arm and hand as one, or None where the hand flies free.")
      .def_property_readonly(
          "torque_origin",
          [](const CompiledHandle& self) {
            return to_array(Vector3(self.scene->wrench_frame.torque_origin));
          },
          "(3,): the centre of mass, about which torques are taken, frame O [m].")
      .def_property_readonly(
          "torque_scale",
          [](const CompiledHandle& self) { return self.scene->wrench_frame.torque_scale; },
          "Torques are multiplied by it, one over the object's largest radius [1/m].")
      .def("__repr__", [](const CompiledHandle& self) {
        return "<prehend.CompiledScene " + self.scene->scene.name + ", hand " +
               self.scene->scene.hand.name + ">";
      });
  core.def("compile_scene", &compile_in_python);
}

}  // namespace

void bind_scene(py::module_& core) {
  bind_bodies(core);
  bind_scene_class(core);
  bind_compiled_scene(core);
  core.def("load_mesh", &load_mesh_in_python);
  core.def("library_scene_names", &library_scene_names);
}

}  // namespace prehend::python

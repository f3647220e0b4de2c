#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "planner/main/print_mass.h"
#include "planner/main/print_notes.h"
#include "planner/main/print_robot.h"
#include "planner/main/printed_units.h"
#include "planner/main/requested_scene.h"
#include "planner/main/shared_options.h"
#include "planner/show/primitives_picture.h"
#include "planner/show/robot_picture.h"
#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/base/output_file.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/graspit_world.h"
#include "sim/scene/object_mesh.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/scene/scene_text.h"
#include "sim/shape/cloud/files/views_file.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mass_properties.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/mesh_repair.h"

namespace prehend {
namespace {

// Arguments of `inspect`.
struct InspectCommand {
  std::string file;
  std::string unit;                           // empty: the likely one
  bool repair = true;                         // of an object's mesh file
  std::optional<double> primitive_tolerance;  // mm; empty: that of DecomposeOptions
  std::filesystem::path save;                 // of a scene: write it there; empty: do not
  std::filesystem::path picture;              // of a robot: draw it there (PNG); empty: do not
  std::filesystem::path primitives;           // of an object: draw its primitives there (PNG)
  std::vector<std::string> packages;          // of a robot: NAME=FOLDER
  std::filesystem::path srdf;                 // of a robot; empty: that beside it
};

void declare(CLI::App& command, InspectCommand& options) {
  add_examples(command,
               {"inspect bottle.obj --unit mm", "inspect gripper.urdf --picture gripper.png",
                "inspect mug --primitives mug.png"});
  command.add_option("file", options.file, "mesh, robot or scene file, or a library name")
      ->required();
  add_mesh_options(command, options.unit, options.repair);
  command.add_option("--primitive-tolerance", options.primitive_tolerance,
                     "how far the object's surface may be from its primitives, in mm");
  command.add_option("--save", options.save, "of a scene: write it to this file");
  command.add_option("--picture", options.picture, "of a robot: draw it in this file (PNG)");
  command.add_option("--primitives", options.primitives,
                     "of a mesh or scene: draw object and primitives in this file (PNG)");
  add_foreign(command, options.packages, options.srdf);
}

void print_checks(const MeshChecks& checks) {
  std::printf("  triangles %d, vertices %d, components %d\n", checks.triangles, checks.vertices,
              checks.components);
  std::printf("  closed %s, oriented %s\n", checks.closed() ? "yes" : "no",
              checks.misoriented_edges == 0 ? "yes" : "no");
  const auto warn = [](int count, const char* what) {
    if (count > 0) std::printf("  warning: %d %s\n", count, what);
  };
  warn(checks.boundary_edges, "boundary edges (holes)");
  warn(checks.nonmanifold_edges, "edges of three or more triangles");
  warn(checks.misoriented_edges, "edges whose triangles disagree on outside");
  warn(checks.degenerate_triangles, "triangles without area");
  if (checks.inward) std::printf("  warning: the surface faces inward\n");
}

void print_sizes(const Box& box) {
  const Vector3 size = kMillimetres * box.size;
  std::printf("%.1f x %.1f x %.1f mm", size.x(), size.y(), size.z());
}

void print_sizes(const Sphere& sphere) {
  std::printf("radius %.1f mm", kMillimetres * sphere.radius);
}

void print_sizes(const Cylinder& cylinder) {
  std::printf("radius %.1f mm, height %.1f mm", kMillimetres * cylinder.radius,
              kMillimetres * cylinder.height);
}

void print_sizes(const Cone& cone) {
  std::printf("radius %.1f to %.1f mm, height %.1f mm", kMillimetres * cone.radius_low,
              kMillimetres * cone.radius_high, kMillimetres * cone.height);
}

void print_curve(double width, const std::vector<Vector3>& points, bool closed) {
  std::printf("%.2f mm wide, %.1f mm long%s", kMillimetres * width,
              kMillimetres * curve_length(points, closed), closed ? ", closed" : "");
}

void print_sizes(const Rim& rim) { print_curve(rim.width, points_of(rim), rim.closed); }

void print_sizes(const Bar& bar) { print_curve(bar.width, bar.points, bar.closed); }

// Where a curve begins.
void print_start(const Vector3& p_O) {
  const Vector3 p = kMillimetres * p_O;
  std::printf(" from (%.1f, %.1f, %.1f) mm\n", p.x(), p.y(), p.z());
}

void print_shape(const Primitive& primitive) {
  std::printf("  %-8s ", std::string(shape_name(primitive.shape)).c_str());
  std::visit([](const auto& shape) { print_sizes(shape); }, primitive.shape);
  if (const Rim* rim = std::get_if<Rim>(&primitive.shape)) {
    print_start(primitive.X_OP * rim->points.front().p);
  } else if (const Bar* bar = std::get_if<Bar>(&primitive.shape)) {
    print_start(primitive.X_OP * bar->points.front());
  } else {
    const Vector3 p = kMillimetres * primitive.X_OP.translation();
    std::printf(" at (%.1f, %.1f, %.1f) mm\n", p.x(), p.y(), p.z());
  }
}

// The centre of mass is that of uniform density: it is left out where another one is known.
void print_volume(const TriangleMesh& mesh, const MeshChecks& checks, bool centered) {
  const MassProperties mass = mass_properties(mesh);
  const Vector3 center = kMillimetres * mass.center_of_mass;
  std::printf("  volume %.4f litres, ", kLitres * mass.volume);
  if (centered) {
    std::printf("centre of mass (%.2f, %.2f, %.2f) mm, ", center.x(), center.y(), center.z());
  }
  std::printf("from the %s\n", std::string(name_of(mass.source)).c_str());
  if (!checks.solid()) std::printf("  %s\n", trust_text(checks, mass.source).c_str());
}

// Corners of the box around the vertices.
void print_bounds(const char* frame, const TriangleMesh& mesh, const Pose& X_FB) {
  Bounds box;
  for (const Vector3& p_B : mesh.vertices) {
    const Vector3 p_F = kMillimetres * (X_FB * p_B);
    box.lower = box.lower.cwiseMin(p_F);
    box.upper = box.upper.cwiseMax(p_F);
  }
  std::printf("  %s from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f) mm\n", frame, box.lower.x(),
              box.lower.y(), box.lower.z(), box.upper.x(), box.upper.y(), box.upper.z());
}

void print_size(const TriangleMesh& mesh) {
  const Vector3 size = kMillimetres * bounds(mesh).size();
  std::printf("  size %.2f x %.2f x %.2f mm, surface %.1f cm^2\n", size.x(), size.y(), size.z(),
              kSquareCentimetres * surface_area(mesh));
  print_bounds("in its own frame", mesh, Pose::Identity());
}

void print_mesh(const TriangleMesh& mesh, MassBasis basis = MassBasis::uniform,
                const std::optional<Pose>& X_WB = {}) {
  const MeshChecks checks = check_mesh(mesh);
  print_size(mesh);
  if (X_WB) print_bounds("in the world", mesh, *X_WB);
  print_checks(checks);
  print_volume(mesh, checks, basis == MassBasis::uniform);
}

// A mesh file as an object: as it is in the file, and as it is after repair.
void print_repaired(const LoadedMesh& loaded, const MeshRepair& repair) {
  print_size(loaded.mesh);
  print_checks(repair.before);
  if (repair.changed()) {
    std::printf("  repaired: %s\n", repair_text(repair).c_str());
    print_checks(repair.after);
  }
  print_volume(repair.mesh, repair.after, true);
}

void print_distances(const SurfaceDistances& d) {
  std::printf("median %.3g, 95 %% %.3g, largest %.3g mm", kMillimetres * d.median,
              kMillimetres * d.percentile_95, kMillimetres * d.largest);
}

// The folder of the file is made as well.
void write(const std::filesystem::path& file, const std::string& content, Interrupts& interrupts) {
  make_folder(std::filesystem::absolute(file).parent_path());
  interrupts.write(file, content);
}

void print_primitives(const TriangleMesh& mesh, const InspectCommand& command,
                      Interrupts& interrupts) {
  DecomposeOptions options;
  if (command.primitive_tolerance) {
    options.tolerance = requested_tolerance(mesh, *command.primitive_tolerance);
  }
  const Decomposition parts = decompose(mesh, options);
  std::printf(
      "primitives: %zu, which explain %.1f %% of the surface: it is within %.3g mm of them\n",
      parts.primitives.size(), 100.0 * parts.explained, kMillimetres * parts.tolerance);
  std::printf("  distance of the surface from them: ");
  print_distances(parts.distances);
  std::printf("\n");
  for (std::size_t k = 0; k < parts.primitives.size(); ++k) {
    print_shape(parts.primitives[k]);
    std::printf("           %.1f %% of the surface; distance ", 100.0 * parts.share[k]);
    print_distances(parts.distances_of[k]);
    std::printf("\n");
  }
  const std::vector<Primitive> thin = find_thin_parts(ProximityMesh(mesh), parts.primitives);
  if (!thin.empty()) std::printf("thin parts: %zu\n", thin.size());
  for (const Primitive& part : thin) print_shape(part);
  if (command.primitives.empty()) return;
  write(command.primitives, png_bytes(primitives_picture(mesh, parts)), interrupts);
}

std::vector<InspectedRobot> inspected_robots(const Platform& platform) {
  std::vector<InspectedRobot> robots;
  for (const MountedRobot& mounted : platform.robots) robots.push_back(inspected(mounted.robot));
  return robots;
}

// "rubber, wet_glass": of the regions of a body or a link, in their order.
std::string materials_of(const std::vector<MaterialRegion>& surfaces) {
  std::vector<std::string> names;
  for (const MaterialRegion& surface : surfaces) names.push_back(surface_name(surface.of));
  return joined(names);
}

void print_surfaces(const Scene& scene) {
  const auto print = [](const std::string& of, const std::vector<MaterialRegion>& surfaces) {
    if (surfaces.empty()) return;
    std::printf("parts of the surface of %s: %s\n", of.c_str(), materials_of(surfaces).c_str());
  };
  print(scene.object.name, scene.object.surfaces);
  for (const StaticBody& body : scene.obstacles) print(body.name, body.surfaces);
  for (const LinkSurfaces& link : scene.link_surfaces) print(link.link, link.surfaces);
}

void print_scene(const Scene& scene, const InspectCommand& command, Interrupts& interrupts) {
  std::printf("scene %s: object %s of %s, %.3f kg; hand %s; %zu obstacles\n", scene.name.c_str(),
              scene.object.name.c_str(), std::string(name_of(scene.object.material)).c_str(),
              scene.object.mass, scene.hand.name.c_str(), scene.obstacles.size());
  if (scene.carrier) {
    print_platform(scene.carrier->platform, inspected_robots(scene.carrier->platform));
  }
  print_mesh(scene.object.mesh, scene.object.mass_basis, scene.object.X_WO);
  print_mass(scene.object);
  print_surfaces(scene);
  for (const StaticBody& body : scene.obstacles) {
    std::printf("obstacle %s of %s\n", body.name.c_str(),
                std::string(name_of(body.material)).c_str());
    print_mesh(body.mesh, MassBasis::uniform, body.X_WB);
  }
  if (scene.primitives.empty()) {
    print_primitives(scene.object.mesh, command, interrupts);
  } else {
    std::printf("primitives: %zu, given by the scene\n", scene.primitives.size());
    for (const Primitive& primitive : scene.primitives) print_shape(primitive);
  }
}

bool is_robot_name(const std::string& name) {
  for (const auto& names : {library_robot_names(), library_platform_names()}) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
  }
  return false;
}

// Only mesh files are in a unit that the command line says.
void need_metres(const InspectCommand& command) {
  require(command.unit.empty() || command.unit == "m",
          {.field = "--unit", .problem = "only for mesh files", .value = command.unit});
}

// The likely unit of a mesh file, with what there is to say about it on stderr.
std::string noted_unit(const std::filesystem::path& file) {
  const ObjectMesh object = load_object_mesh(file, {.unit = "", .repair = false});
  for (const std::string& note : object.notes) {
    std::cerr << "warning: " << on_one_line(file.stem().string() + ": " + note) << "\n";
  }
  return object.unit;
}

// What the command line says of objects does not fit robots.
void need_plain(const InspectCommand& command) {
  need_metres(command);
  require(!command.primitive_tolerance,
          {.field = "--primitive-tolerance", .problem = "only for meshes and scenes"});
  require(command.primitives.empty(),
          {.field = "--primitives", .problem = "only for meshes and scenes"});
}

void need_no_picture(const InspectCommand& command) {
  require(command.picture.empty(), {.field = "--picture", .problem = "only for robots"});
}

void inspect_platform(const Platform& platform, const InspectCommand& command,
                      Interrupts& interrupts) {
  need_plain(command);
  const std::vector<InspectedRobot> robots = inspected_robots(platform);
  print_platform(platform, robots);
  if (command.picture.empty()) return;
  // A mobile base, an arm and a hand: a row each.
  std::vector<Image> rows;
  for (const InspectedRobot& one : robots) {
    rows.push_back(robot_picture(one.robot, telling_postures(one.robot), one.survey,
                                 {.width = 1200, .height = 800}));
  }
  write(command.picture, png_bytes(grid(rows, 1)), interrupts);
}

void inspect_scene(const Scene& scene, const InspectCommand& command, Interrupts& interrupts) {
  need_no_picture(command);
  print_notes(scene);
  print_scene(scene, command, interrupts);
  if (!command.save.empty()) write(command.save, scene_text(scene), interrupts);
}

// The scene of a GraspIt! file. Where nothing can be derived of its hand, that is said and shown as
// it is; a scene to be saved is one that can be planned with.
Scene graspit_scene(const std::filesystem::path& file, const InspectCommand& command) {
  Scene scene = load_scene(file, {.hand = "", .derive_hand = !command.save.empty()});
  try {
    scene.hand = with_hand(scene.hand);
  } catch (const InputError& error) {
    std::printf("no hand can be derived: %s\n", on_one_line(error.what()).c_str());
  }
  if (scene.carrier) scene.carrier->platform.robots[index(scene.carrier->hand)].robot = scene.hand;
  return scene;
}

// With its colours. Where these alone cannot be read, `refused` is the reason.
LoadedMesh load_with_colors(const std::filesystem::path& file, const std::string& unit,
                            std::string& refused) {
  const double metres = metres_per_unit(unit);
  try {
    return load_mesh(file, {.metres_per_unit = metres, .colors = true});
  } catch (const InputError& error) {
    refused =
        InputError({.field = error.field(), .problem = error.problem(), .value = error.value()})
            .what();
    return load_mesh(file, {.metres_per_unit = metres});
  }
}

void print_colors(const ColoredMesh& mesh, const std::string& refused) {
  if (!refused.empty()) std::printf("  colours cannot be read: %s\n", refused.c_str());
  if (mesh.empty()) return;
  const auto text = [](const ColorShare& one) {
    return color_text(one.color) + formatted(" %.0f %%", 100.0 * one.share);
  };
  std::printf("  colours %s\n", joined(frequent_colors(mesh), ", ", text).c_str());
}

void inspect_mesh_file(const std::filesystem::path& file, const InspectCommand& command,
                       Interrupts& interrupts) {
  need_no_picture(command);
  std::string unit = command.unit;
  if (unit.empty()) unit = noted_unit(file);
  std::string refused;
  LoadedMesh loaded = load_with_colors(file, unit, refused);
  std::printf("mesh %s\n", file.string().c_str());
  if (unit != "m") std::printf("  read in %s\n", unit.c_str());
  if (command.repair) {
    MeshRepair repair = repair_mesh(loaded.mesh);
    print_repaired(loaded, repair);
    loaded.mesh = std::move(repair.mesh);
  } else {
    print_mesh(loaded.mesh);
  }
  if (loaded.degenerate_removed + loaded.duplicates_removed > 0) {
    std::printf("  left out: %d triangles without area, %d duplicates\n", loaded.degenerate_removed,
                loaded.duplicates_removed);
  }
  print_colors(loaded.colors, refused);
  print_primitives(loaded.mesh, command, interrupts);
}

int run_inspect(const InspectCommand& command, Interrupts& interrupts) {
  for (const std::filesystem::path& written : {command.save, command.picture, command.primitives}) {
    if (!written.empty()) require_writable(std::filesystem::absolute(written).parent_path());
  }
  // A file is preferred to a robot of the library of the same name.
  if (!is_there(command.file) && is_robot_name(command.file)) {
    inspect_platform(find_platform(command.file), command, interrupts);
    return 0;
  }
  const std::filesystem::path file = find_scene(command.file);
  if (is_graspit_scene(file)) {
    need_metres(command);
    inspect_scene(graspit_scene(file, command), command, interrupts);
  } else if (has_foreign_robot_name(file)) {
    ForeignRobotOptions options = foreign_options(command.packages, command.srdf);
    if (!command.unit.empty()) options.scale = metres_per_unit(command.unit);
    InspectCommand in_metres = command;
    in_metres.unit.clear();
    inspect_platform(load_platform(file, options), in_metres, interrupts);
  } else if (file.extension() != ".json" && is_views_file(file)) {
    inspect_scene(load_scene(file, {.hand = "", .unit = command.unit}), command, interrupts);
  } else if (file.extension() != ".json") {
    inspect_mesh_file(file, command, interrupts);
  } else {
    need_metres(command);
    const JsonFile json(file);
    // Robot files have chains, platform files robots; other JSON files are scenes.
    if (json.root().has("chains") || json.root().has("robots")) {
      inspect_platform(load_platform(file), command, interrupts);
    } else {
      inspect_scene(load_scene(file, {.hand = "", .unit = "", .repair = command.repair}), command,
                    interrupts);
    }
  }
  return 0;
}

}  // namespace

void add_inspect(CLI::App& app, CommandRequest& request) {
  add_command(app, request, "inspect", "say what prehend sees in a mesh, robot or scene", declare,
              run_inspect);
}

}  // namespace prehend

// Scenes of what depth cameras saw, from arrays.
#include <pybind11/stl.h>
#include <utility>

#include "planner/python/arrays.h"
#include "planner/python/scene_handle.h"
#include "sim/base/input_error.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/seen_scene.h"
#include "sim/shape/cloud/files/cloud_views.h"
#include "sim/shape/cloud/files/depth_checks.h"

namespace prehend::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

// A depth image [m] with its camera.
struct ImageInPython {
  Floats depth;                    // H x W
  std::vector<double> intrinsics;  // fx, fy, cx, cy
  Doubles X_WC;
};

// Points [m] in a frame F.
struct CloudInPython {
  Floats points;   // N x 3
  Floats normals;  // N x 3, or 0 x 3
  std::optional<Doubles> viewpoint;
  Doubles X_WF;
};

DepthView view_in_python(const ImageInPython& image) {
  if (image.depth.ndim() != 2 || image.intrinsics.size() != 4) {
    throw std::invalid_argument("not an image with a camera");
  }
  require_few(static_cast<std::size_t>(image.depth.size()), "pixels");
  DepthCamera camera{image.intrinsics[0],
                     image.intrinsics[1],
                     image.intrinsics[2],
                     image.intrinsics[3],
                     static_cast<int>(image.depth.shape(1)),
                     static_cast<int>(image.depth.shape(0)),
                     pose_of(image.X_WC)};
  const float* first = image.depth.data();
  return checked_view(camera, {first, first + image.depth.size()});
}

PointList points_in(const Floats& array) {
  if (array.ndim() != 2 || array.shape(1) != 3) throw std::invalid_argument("not N x 3");
  require_few(static_cast<std::size_t>(array.shape(0)), "points");
  PointList points;
  points.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    const float* row = array.data(i, 0);
    points.emplace_back(row[0], row[1], row[2]);
  }
  return points;
}

std::vector<DepthView> views_in_python(const CloudInPython& cloud,
                                       std::vector<std::string>& notes) {
  PointCloud read{.points = points_in(cloud.points), .normals = points_in(cloud.normals)};
  read.width = read.points.size();
  CloudPlace place{.X_WF = pose_of(cloud.X_WF)};
  if (cloud.viewpoint) place.viewpoint = vector_of(*cloud.viewpoint);
  return views_of_cloud(read, place, notes);
}

// What is seen, and with what it is grasped: a scene for each thing.
std::vector<SceneHandle> scenes_of_things(const SeenThings& things, const std::string& hand,
                                          const std::string& material, double mass) {
  std::vector<SceneHandle> scenes;
  for (std::size_t at = 0; at < things.bodies.objects.size(); ++at) {
    Scene scene;
    place_seen(things, at, material_named(material), mass, scene);
    const std::vector<std::string> notes = std::move(scene.notes);
    const std::vector<StaticBody> obstacles = std::move(scene.obstacles);
    SceneHandle handle{make_scene(std::move(scene.object), hand), {}};
    handle.scene.notes = notes;
    handle.scene.obstacles = obstacles;
    note_uniform_mass(handle.scene);
    scenes.push_back(std::move(handle));
  }
  return scenes;
}

std::vector<SceneHandle> scenes_from_views(const std::vector<ImageInPython>& images,
                                           const std::vector<CloudInPython>& clouds,
                                           const ReconstructOptions& steps, const std::string& hand,
                                           const std::string& material, double mass) {
  require(mass > 0.0,
          {.field = "mass", .problem = "must be positive", .value = std::to_string(mass)});
  ViewsInput input{.steps = steps};
  const auto with_place = [](std::size_t i, const auto& read) {
    try {
      read();
    } catch (const InputError& error) {
      throw error.under("views[" + std::to_string(i) + "]");
    }
  };
  for (std::size_t i = 0; i < images.size(); ++i) {
    with_place(i, [&] { input.views.push_back(view_in_python(images[i])); });
  }
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    with_place(images.size() + i, [&] {
      for (DepthView& view : views_in_python(clouds[i], input.notes)) {
        input.views.push_back(std::move(view));
      }
    });
  }
  const py::gil_scoped_release no_gil;
  return scenes_of_things(seen_things(input), hand, material, mass);
}

}  // namespace

void bind_views(py::module_& core) {
  py::class_<ImageInPython>(core, "_DepthImage")
      .def(py::init(
          [](const Floats& depth, const std::vector<double>& intrinsics, const Doubles& X_WC) {
            return ImageInPython{depth, intrinsics, X_WC};
          }));
  py::class_<CloudInPython>(core, "_Cloud")
      .def(py::init([](const Floats& points, const Floats& normals,
                       const std::optional<Doubles>& viewpoint, const Doubles& X_WF) {
        return CloudInPython{points, normals, viewpoint, X_WF};
      }));
  core.def("scenes_from_views",
           [](const std::vector<ImageInPython>& images, const std::vector<CloudInPython>& clouds,
              double voxel, bool outliers, bool plane, bool symmetry, double gap, int min_readings,
              const std::string& hand, const std::string& material, double mass) {
             return scenes_from_views(images, clouds,
                                      {voxel, outliers, plane, symmetry, gap, min_readings}, hand,
                                      material, mass);
           });
}

}  // namespace prehend::python

#include "sim/shape/cloud/files/views_file.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/json/json_fields.h"
#include "sim/base/require_settings.h"
#include "sim/shape/cloud/files/cloud_views.h"
#include "sim/shape/cloud/files/depth_checks.h"
#include "sim/shape/cloud/files/depth_png.h"
#include "sim/shape/cloud/files/point_cloud.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/files/ply_elements.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

constexpr double kMillimetre = 0.001;

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

// Metres per unit: m, cm, mm, in, or a number of metres.
double read_unit(const JsonField& field) {
  constexpr Range kUnit{.upper = 1000.0, .without_lower = true};
  if (!field.is_text()) return field.number(kUnit);
  return with_field_errors(field, [&] { return metres_per_unit(field.text()); });
}

// What is read counts together.
class ReadingsBudget {
 public:
  void take(std::size_t count) {
    taken_ += count;
    require_few(taken_, "pixels and points");
  }

 private:
  std::size_t taken_ = 0;
};

// A camera and the metres per count of its images.
struct CameraFields {
  DepthCamera camera;
  double unit = kMillimetre;
};

int read_size(const JsonField& field) {
  const int size = field.integer();
  if (size < 1) field.fail("must be at least 1");
  return size;
}

CameraFields read_camera(const JsonField& field) {
  field.allow_only({"fx", "fy", "cx", "cy", "width", "height", "pose", "unit"});
  CameraFields fields;
  DepthCamera& camera = fields.camera;
  constexpr Range kPixels{.lower = -1e6, .upper = 1e6};
  constexpr Range kFocal{.upper = 1e6, .without_lower = true};
  camera.fx = field["fx"].number(kFocal);
  camera.fy = field["fy"].number(kFocal);
  camera.cx = field["cx"].number(kPixels);
  camera.cy = field["cy"].number(kPixels);
  if (field.has("width")) camera.width = read_size(field["width"]);
  if (field.has("height")) camera.height = read_size(field["height"]);
  if (field.has("pose")) camera.X_WC = read_pose(field["pose"]);
  if (field.has("unit")) fields.unit = read_unit(field["unit"]);
  return fields;
}

// In place, or the name of a file beside this one that has it.
CameraFields read_camera_of(const JsonField& field) {
  if (!field.is_text()) return read_camera(field);
  const JsonFile file(field.file().parent_path() / field.text());
  return read_camera(file.root());
}

void require_size(int stated, int is, const char* field) {
  require(stated == 0 || stated == is,
          {.field = field,
           .problem = "the image has another size: " + std::to_string(is),
           .value = std::to_string(stated)});
}

DepthView view_of_image(const fs::path& file, const CameraFields& fields, ReadingsBudget& budget) {
  const DepthImage image = [&] {
    try {
      return read_depth_png(read_file(file));
    } catch (const InputError& error) {
      throw error.in_file(file.string());
    }
  }();
  budget.take(image.counts.size());
  const DepthCamera& stated = fields.camera;
  require_size(stated.width, image.width, "camera.width");
  require_size(stated.height, image.height, "camera.height");
  DepthCamera camera = stated;
  camera.width = image.width;
  camera.height = image.height;
  std::vector<float> depth;
  depth.reserve(image.counts.size());
  for (const std::uint16_t count : image.counts) {
    depth.push_back(static_cast<float>(fields.unit * count));
  }
  return checked_view(camera, std::move(depth));
}

PointCloud load_cloud(const fs::path& file) {
  const std::string extension = lower_extension(file);
  require(extension == ".pcd" || extension == ".ply",
          {.problem = "unknown format of clouds, known: .pcd .ply", .value = extension});
  const std::string bytes = read_file(file);
  return extension == ".pcd" ? read_pcd(bytes) : read_ply_cloud(bytes);
}

void add_cloud(const fs::path& file, const CloudPlace& place, ReadingsBudget& budget,
               ViewsInput& input) {
  try {
    const PointCloud cloud = load_cloud(file);
    budget.take(cloud.points.size());
    for (DepthView& view : views_of_cloud(cloud, place, input.notes)) {
      input.views.push_back(std::move(view));
    }
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
}

// The settings by their names; the names that are allowed.
std::vector<std::string> read_steps(const JsonField& root, ReconstructOptions& steps) {
  std::vector<std::string> names;
  visit_settings(steps, [&](const std::string& name, auto& value, const Setting&) {
    names.push_back(name);
    if (!root.has(name)) return;
    read_value(root[name], value);
    if (const std::optional<SettingFault> fault = setting_fault(steps)) {
      root[name].fail(fault->problem);
    }
  });
  return names;
}

void add_view(const JsonField& field, ReadingsBudget& budget, ViewsInput& input) {
  const fs::path folder = field.file().parent_path();
  if (field.has("depth") == field.has("cloud")) field.fail("needs either a depth image or a cloud");
  if (field.has("depth")) {
    CameraFields camera = read_camera_of(field["camera"]);
    if (field.has("unit")) camera.unit = read_unit(field["unit"]);
    try {
      input.views.push_back(view_of_image(folder / field["depth"].text(), camera, budget));
    } catch (const InputError& error) {
      if (!error.file().empty()) throw;
      field.fail(error);
    }
    return;
  }
  CloudPlace place;
  if (field.has("unit")) place.metres_per_unit = read_unit(field["unit"]);
  if (field.has("viewpoint")) place.viewpoint = field["viewpoint"].vector3(kCoordinate);
  if (field.has("pose")) place.X_WF = read_pose(field["pose"]);
  add_cloud(folder / field["cloud"].text(), place, budget, input);
}

// A PNG file by itself.
ViewsInput read_image(const fs::path& file) {
  fs::path beside = file;
  beside.replace_extension(".json");
  require(is_file(beside), {.file = file.string(),
                            .problem = "no camera: a JSON file beside it must state fx, fy, cx, cy",
                            .value = beside.filename().string()});
  const JsonFile stated(beside);
  const CameraFields camera = read_camera(stated.root());
  ReadingsBudget budget;
  ViewsInput input;
  try {
    input.views.push_back(view_of_image(file, camera, budget));
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
  return input;
}

}  // namespace

bool states_views(const JsonField& root) {
  return root.is_object() && (root.has("views") || root.has("depth") || root.has("cloud"));
}

ViewsInput read_views(const JsonField& root) {
  ViewsInput input;
  std::vector<std::string> allowed = read_steps(root, input.steps);
  const std::vector<std::string> of_view = {"depth", "camera",    "unit",
                                            "cloud", "viewpoint", "pose"};
  const auto allow = [](const JsonField& field, const std::vector<std::string>& names) {
    field.allow_only(std::vector<std::string_view>(names.begin(), names.end()));
  };
  ReadingsBudget budget;
  if (root.has("views")) {
    allowed.emplace_back("views");
    allow(root, allowed);
    for (const JsonField& field : root["views"].items()) {
      allow(field, of_view);
      add_view(field, budget, input);
    }
    if (input.views.empty()) root["views"].fail("must have at least one view");
  } else {
    allowed.insert(allowed.end(), of_view.begin(), of_view.end());
    allow(root, allowed);
    add_view(root, budget, input);
  }
  return input;
}

bool is_views_file(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".pcd" || extension == ".png") return true;
  try {
    if (extension == ".ply") return !has_ply_surface(read_file(file));
    return extension == ".json" && states_views(JsonFile(file).root());
  } catch (const InputError&) {
    return false;
  }
}

ViewsInput load_views(const std::filesystem::path& file, const std::string& unit) {
  const std::string extension = lower_extension(file);
  if (extension == ".json" || extension == ".png") {
    require(unit.empty() || unit == "m", {.file = file.string(),
                                          .field = "unit",
                                          .problem = "stands in the JSON file of the camera",
                                          .value = unit});
    return extension == ".png" ? read_image(file) : read_views(JsonFile(file).root());
  }
  ReadingsBudget budget;
  ViewsInput input;
  add_cloud(file, {.metres_per_unit = unit.empty() ? 1.0 : metres_per_unit(unit)}, budget, input);
  return input;
}

}  // namespace prehend

// Files of what depth cameras saw: depth images with their cameras, and clouds of points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/shape/cloud/depth_view.h"
#include "sim/shape/cloud/reconstruct.h"

namespace prehend {

class JsonField;  // sim/base/json/json_field.h

// What a file says, with what it names.
struct ViewsInput {
  std::vector<DepthView> views = {};
  ReconstructOptions steps = {};
  std::vector<std::string> notes = {};  // what was assumed, for people: one line each
};

// Whether it is such a file: .pcd, .png, .ply without faces, or JSON that states views, a depth
// image or a cloud. False where the file cannot be read.
bool is_views_file(const std::filesystem::path& file);

// Reads
// - JSON (docs/how-to/camera.md): a list "views", or one view, each a depth image with its camera
//   or a cloud, and the settings of the steps by name;
// - a 16-bit grey PNG, whose camera is in the JSON file of the same name beside it;
// - a PCD or PLY file.
// `unit` is that of a PCD or PLY file: m, cm, mm or in; empty: m. Throws InputError that names
// file, field and value.
ViewsInput load_views(const std::filesystem::path& file, const std::string& unit = {});

// Of JSON that was parsed already: whether it states views, and what it says.
bool states_views(const JsonField& root);
ViewsInput read_views(const JsonField& root);

}  // namespace prehend

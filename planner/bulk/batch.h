// What a batch plans: every object times every hand times every setting.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "planner/plan/plan_options.h"
#include "sim/base/material.h"
#include "sim/scene/scene.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// An object of a batch.
struct BatchObject {
  std::string name;  // unlike that of any other object; may contain "/"
  // What data sets call it: the path of its mesh as seen from the batch file, or the name of a
  // generated object.
  std::string file;
  std::variant<MeshFileSource, GeneratedSource> source;  // unit of a mesh file: may be empty
};

// What the objects stand among, and what carries the hand: a scene whose object is replaced. The
// object stands where that of the scene stood (object_in_scene).
struct BatchScene {
  std::string name;
  std::string scene;  // name of the library or absolute path; empty: the object alone
};

// How much work each plan does.
struct BatchSetting {
  std::string name;
  PlanOptions options;
};

// The lists that are multiplied; none of them is empty.
struct Batch {
  std::string name;
  std::vector<BatchObject> objects;
  std::vector<double> scales = {1.0};  // of the mesh (> 0)
  std::vector<std::string> hands;      // names of the library or absolute paths
  std::vector<BatchScene> scenes = {{"free", ""}};
  // Of the object's material with every other one; none: those of the materials.
  std::vector<std::optional<double>> frictions = {std::nullopt};
  std::vector<BatchSetting> settings;
  std::vector<std::uint64_t> seeds = {1};
  Material material = Material::plastic;  // of the objects
  std::optional<double> density;          // kg/m^3; none: every object has kDefaultObjectMass
  std::string licence;                    // of the meshes, for the data card; empty: not stated
};

// Reads a batch file (docs/reference/batch-file.md). Files are named relative to it. Objects are in
// the order of their names. Throws InputError that names the file, the field and the value: for
// unknown fields, patterns and folders without a mesh, two objects (settings, scenes) of one name,
// a list that names something twice, and more parts than kMostParts. Meshes are not opened.
Batch read_batch(const JsonFile& file);

// More are likely a mistake, and their numbers would not fit an int everywhere.
inline constexpr std::size_t kMostParts = 100'000'000;

}  // namespace prehend

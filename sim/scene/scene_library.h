// Scenes that come with prehend, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prehend {

// The file of a scene: the path as it is where there is such a file, else the library scene of that
// name ("mug"). Throws InputError that lists the names when it is neither.
std::filesystem::path find_scene(const std::string& name_or_file);

// Names of the scenes that come with prehend.
std::vector<std::string> library_scene_names();

// What a grasp file calls a scene: its name if it is the library's, else its absolute path. Throws
// InputError as find_scene.
std::string scene_reference(const std::filesystem::path& name_or_file);

}  // namespace prehend

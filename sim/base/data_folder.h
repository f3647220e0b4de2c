// Location of the robot and scene files that are installed with prehend.
#pragma once

#include <filesystem>
#include <optional>

namespace prehend {

// The folder that contains the folders `robots` and `scenes`. It is searched at run time, so that
// an installed package or a build folder can be moved:
// 1. the folder named by the environment variable PREHEND_DATA, if that is set and not empty;
// 2. otherwise the folder share/prehend next to or above the binary that contains this function
//    (the program or the shared library): the binary's own folder is searched first, then up to
//    five of its parent folders.
// Returns nullopt when neither rule finds a folder. Throws InputError when PREHEND_DATA names a
// folder without a subfolder `robots`.
std::optional<std::filesystem::path> find_data_folder();

// Like find_data_folder, but throws InputError with the searched places when there is no such
// folder.
std::filesystem::path data_folder();

}  // namespace prehend

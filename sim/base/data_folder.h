// Where the robots and scenes that come with prehend are.
#pragma once

#include <filesystem>
#include <optional>

namespace prehend {

// The folder that holds `robots` and `scenes`. It is looked for when the program runs, so that an
// installed package or a build folder can be moved:
// 1. the folder that the environment variable PREHEND_DATA names, if it is set and not empty;
// 2. else share/prehend beside or above the file that holds this function's code, the program or
//    the shared library: in its own folder and in the five folders above that, the nearest first.
// Throws InputError where PREHEND_DATA names a folder without `robots`. Nothing where neither rule
// finds one.
std::optional<std::filesystem::path> find_data_folder();

// The same. Throws InputError that says where it looked when there is none.
std::filesystem::path data_folder();

}  // namespace prehend

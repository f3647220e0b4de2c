// Where files of other programs' formats find the meshes that they name.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace prehend {

// Folders of packages, by the name of the package.
using PackageFolders = std::map<std::string, std::filesystem::path>;

// What a caller says beside the name of a file in another program's format.
struct ForeignRobotOptions {
  PackageFolders packages = {};     // of package://NAME/... in URDF
  std::filesystem::path srdf = {};  // empty: NAME.srdf beside NAME.urdf, if it is there
  std::map<std::string, std::string> arguments = {};  // of xacro: values of <xacro:arg>
  double scale = 1.0;  // of all lengths of the file: 0.001 where they are in mm
};

// The file that `uri` names in the file `from`: a path beside it, file://PATH, or
// package://NAME/PATH (model://NAME/PATH alike). The folder of a package is looked for in
// `packages`, then, as NAME or as a folder of the package's files, in the folder of `from` and in
// each above it, then in the folders of the environment variable ROS_PACKAGE_PATH (separated by
// colons). Throws InputError when none has the file; its problem says where a package was looked
// for and how to say where it is.
std::filesystem::path resolved_uri(const std::string& uri, const std::filesystem::path& from,
                                   const PackageFolders& packages);

}  // namespace prehend

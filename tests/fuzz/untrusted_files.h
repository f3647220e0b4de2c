// Reads files of every kind as users' files are read, and messages as a live session gets them, and
// checks what comes of them. The fuzz
// targets call this with what libFuzzer makes up, the tests with the files of tests/corpus.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace prehend::fuzz {

// What a reader promises and did not keep. The message says which promise.
class BrokenPromise : public std::logic_error {
  using std::logic_error::logic_error;
};

// How bytes become other bytes that a reader looks at more closely than at random ones.
enum class Grammar {
  bytes,
  json,      // JSON text
  glb,       // JSON text in the first chunk of a binary glTF
  messages,  // lines of JSON text
};

// A kind of file that prehend reads. `name` is that of its fuzz target and of its folder in
// tests/corpus.
struct FileKind {
  std::string_view name;
  Grammar grammar = Grammar::bytes;
  // Reads a file with these bytes. Throws InputError for what is no such file, and BrokenPromise.
  void (*read)(std::string_view name, const std::string& bytes) = nullptr;
};

std::span<const FileKind> file_kinds();

// Throws BrokenPromise for a name that none has.
const FileKind& file_kind(std::string_view name);

// Reads a file of this kind. Returns the message where it is refused, else nothing. Whatever this
// throws is a bug in prehend.
std::string refusal(const FileKind& kind, const std::string& bytes);

// The readers (FORMAT_files.cpp).
void read_mesh_file(std::string_view extension, const std::string& bytes);
void read_robot_file(std::string_view name, const std::string& bytes);
void read_platform_file(std::string_view name, const std::string& bytes);
void read_graspit_robot_file(std::string_view name, const std::string& bytes);
void read_graspit_world_file(std::string_view name, const std::string& bytes);
void read_urdf_file(std::string_view name, const std::string& bytes);
void read_mjcf_file(std::string_view name, const std::string& bytes);
void read_xacro_file(std::string_view name, const std::string& bytes);
void read_sdf_file(std::string_view name, const std::string& bytes);
void read_openrave_file(std::string_view name, const std::string& bytes);
void read_scene_file(std::string_view name, const std::string& bytes);
void read_moveit_file(std::string_view name, const std::string& bytes);
void read_grasps_file(std::string_view name, const std::string& bytes);
void read_contacts_file(std::string_view name, const std::string& bytes);
void read_executed_grasps_file(std::string_view name, const std::string& bytes);
void read_graspgen_file(std::string_view name, const std::string& bytes);
void read_acronym_file(std::string_view name, const std::string& bytes);
void read_pcd_file(std::string_view name, const std::string& bytes);
void read_ply_cloud_file(std::string_view name, const std::string& bytes);
void read_depth_png_file(std::string_view name, const std::string& bytes);
void read_views_file(std::string_view name, const std::string& bytes);
void read_session_messages(std::string_view name, const std::string& bytes);

// The path that a file of this kind pretends to have: in its folder of tests/corpus, so that it can
// name other files there.
std::string pretended_path(std::string_view name, std::string_view extension);

// Throws BrokenPromise unless `kept`.
void promised(bool kept, const char* promise);

}  // namespace prehend::fuzz

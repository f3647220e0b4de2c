#include "sim/shape/files/mesh_bytes.h"

#include "sim/base/input_error.h"

namespace prehend {

std::string checked_mesh_bytes(std::string_view extension, const std::string& bytes,
                               const std::filesystem::path& folder) {
  if (extension == "gltf") return checked_gltf(bytes, folder);
  if (extension == "glb") return checked_glb(bytes, folder);
  if (extension == "dae") check_dae(bytes);
  return bytes;
}

// Text in UTF-16 has a byte order mark or, without one, zero bytes, as have nearly all binary
// files. Text in UTF-8 has none.
void need_text(std::string_view bytes) {
  const std::string_view mark = bytes.substr(0, 2);
  if (mark == "\xFE\xFF" || mark == "\xFF\xFE") {
    throw InputError("the text is UTF-16, save it as UTF-8");
  }
  if (bytes.find('\0') != bytes.npos) throw InputError("binary data where text was expected");
}

}  // namespace prehend

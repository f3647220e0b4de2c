// XXH3 is used in this file only. Its functions are compiled into it, so that no library is needed
// to run.
#define XXH_INLINE_ALL  // NOLINT(*-macro-usage): how the header is asked for that
#include "planner/bulk/content_key.h"

#include <cstring>
#include <xxhash.h>

#include <nlohmann/json.hpp>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"

namespace prehend {

struct ContentKey::State {
  XXH3_state_t state;
};

ContentKey::ContentKey() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->state); }
ContentKey::~ContentKey() = default;

ContentKey& ContentKey::add(std::string_view content) {
  add(static_cast<std::uint64_t>(content.size()));
  XXH3_128bits_update(&state_->state, content.data(), content.size());
  return *this;
}

ContentKey& ContentKey::add(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return add(bits);
}

ContentKey& ContentKey::add(std::uint64_t number) {
  XXH3_128bits_update(&state_->state, &number, sizeof number);
  return *this;
}

std::string ContentKey::name() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(&state_->state);
  return formatted("%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                   static_cast<unsigned long long>(hash.low64));
}

std::string mesh_file_key(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  ContentKey key;
  key.add(bytes);
  if (file.extension() == ".gltf") {
    const auto document = nlohmann::json::parse(bytes, nullptr, false);
    if (document.is_object() && document.contains("buffers") && document["buffers"].is_array()) {
      for (const auto& buffer : document["buffers"]) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
        const std::filesystem::path beside = file.parent_path() / buffer["uri"].get<std::string>();
        if (is_file(beside)) key.add(read_file(beside));
      }
    }
  }
  return key.name();
}

}  // namespace prehend

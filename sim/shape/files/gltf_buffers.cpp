#include "sim/shape/files/gltf_buffers.h"

#include <array>
#include <cctype>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/shape/files/gltf_members.h"

namespace prehend {
namespace {

constexpr std::array<signed char, 256> base64_values() {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<signed char, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<signed char>(i);
  }
  return values;
}

// A uri writes characters that it cannot hold, such as blanks, as % and two hexadecimal digits.
std::string without_escapes(const std::string& uri) {
  const auto digit = [&](std::size_t at) {
    return at < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[at])) != 0;
  };
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && digit(i + 1) && digit(i + 2)) {
      name += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

// The name as it is written is tried first: some programs write blanks as they are.
std::string bytes_of_file(const std::string& uri, const std::filesystem::path& folder) {
  for (const std::string& name : {uri, without_escapes(uri)}) {
    const std::filesystem::path file = folder / name;
    if (file.extension() == ".bin" && is_file(file)) return read_file(file);
  }
  const bool of_kind = std::filesystem::path(uri).extension() == ".bin";
  throw InputError({.field = "buffers",
                    .problem = "no file " + uri.substr(0, 200) +
                               (of_kind ? "" : " (only files *.bin are opened)")});
}

std::string bytes_of_uri(const nlohmann::json& uri, const std::filesystem::path& folder) {
  if (!uri.is_string()) throw InputError({.field = "uri", .problem = "is not text"});
  const std::string& text = uri.get_ref<const std::string&>();
  if (!text.starts_with("data:")) return bytes_of_file(text, folder);
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = text.find(kMark);
  if (mark == text.npos) throw InputError({.field = "uri", .problem = "has data but no base64"});
  return from_base64(std::string_view(text).substr(mark + kMark.size()));
}

}  // namespace

std::string from_base64(std::string_view text) {
  static constexpr std::array<signed char, 256> kValues = base64_values();
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  // Four letters hold three bytes. One letter more holds 6 bits, less than a byte.
  if (text.size() % 4 == 1) throw InputError("base64 data that ends inside a byte");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    const int value = kValues[static_cast<unsigned char>(letter)];
    if (value < 0) throw InputError("base64 data with letters that are not base64");
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFF);
    }
  }
  return bytes;
}

GltfBuffers fetch_gltf_buffers(const nlohmann::json& buffers, std::string_view chunk,
                               const std::filesystem::path& folder) {
  // What is fetched is counted, not what is declared: many buffers of no length may name one large
  // file.
  constexpr std::size_t kMostBytes = std::size_t{1} << 31;
  std::size_t bytes = 0;
  GltfBuffers result;
  for (const nlohmann::json& buffer : buffers) {
    if (!buffer.is_object())
      throw InputError({.field = "buffers", .problem = "one is not an object"});
    const std::size_t declared = gltf_count(buffer, "byteLength", 0);
    const bool has_uri = buffer.contains("uri");
    if (!has_uri && !result.starts.empty())
      throw InputError({.field = "buffers", .problem = "one has no uri"});
    const std::string fetched = has_uri ? bytes_of_uri(buffer["uri"], folder) : std::string();
    const std::string_view given = has_uri ? std::string_view(fetched) : chunk;
    if (declared > given.size()) {
      throw InputError({.field = "buffers",
                        .problem = "promise " + std::to_string(declared) + " bytes, there are " +
                                   std::to_string(given.size())});
    }
    result.starts.push_back(result.bytes.size());
    result.lengths.push_back(declared);
    bytes += given.size();
    if (bytes > kMostBytes)
      throw InputError({.field = "buffers", .problem = "more than 2 GiB together"});
    result.bytes += given.substr(0, declared);
    result.bytes.resize((result.bytes.size() + 3) / 4 * 4, '\0');
  }
  return result;
}

}  // namespace prehend

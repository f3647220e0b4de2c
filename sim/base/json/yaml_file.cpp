#include "sim/base/json/yaml_file.h"

#include <charconv>
#include <numbers>
#include <optional>
#include <string>
#include <yaml-cpp/yaml.h>

#include "sim/base/input_file.h"
#include "sim/base/json/json_depth.h"

namespace prehend {
namespace {

using Json = nlohmann::json;

// The whole text as a number; nothing where it is none.
template <typename Number>
std::optional<Number> number_of(const std::string& text) {
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* last = text.data() + text.size();
  Number value{};
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last) return std::nullopt;
  return value;
}

// Of a tag that names the unit of a number, as robot descriptions have them: in SI.
// Source: https://wiki.ros.org/xacro, section "YAML support".
std::optional<double> unit_of(const std::string& tag) {
  if (tag == "!degrees") return std::numbers::pi / 180.0;
  if (tag == "!radians" || tag == "!meters") return 1.0;
  if (tag == "!millimeters") return 1e-3;
  if (tag == "!foot") return 0.3048;
  if (tag == "!inches") return 0.0254;
  return std::nullopt;
}

Json scalar(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  if (node.Tag() == "!") return text;  // in quotes
  if (const auto unit = unit_of(node.Tag())) {
    if (const auto number = number_of<double>(text)) return *unit * *number;
  }
  if (text == "true" || text == "false") return text == "true";
  if (text == "~" || text == "null" || text.empty()) return nullptr;
  // Words that from_chars takes for numbers: nan, inf.
  if (text.find_first_of("0123456789") == std::string::npos) return text;
  if (const auto whole = number_of<std::int64_t>(text)) return *whole;
  if (const auto number = number_of<double>(text)) return *number;
  return text;
}

class YamlReader {
 public:
  // Anchors could stand for far more than was written. Without them each value takes two bytes.
  YamlReader(const std::filesystem::path& file, std::size_t bytes) : file_(file), left_(bytes) {}

  Json value(const YAML::Node& node, int depth) {
    if (depth > kDeepestJson)
      fail(node, "must be nested in at most " + std::to_string(kDeepestJson) + " levels");
    if (left_-- == 0) fail(node, "must not refer to its own parts so often");
    if (node.IsScalar()) return scalar(node);
    if (node.IsSequence()) {
      Json list = Json::array();
      for (const YAML::Node& item : node) list.push_back(value(item, depth + 1));
      return list;
    }
    if (!node.IsMap()) return nullptr;
    Json object = Json::object();
    for (const auto& field : node) {
      const YAML::Node& key = field.first;
      if (!key.IsScalar()) fail(key, "the name of a field must be a word");
      if (object.contains(key.Scalar())) fail(key, "must be given once: " + key.Scalar());
      object[key.Scalar()] = value(field.second, depth + 1);
    }
    return object;
  }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& problem) const {
    throw InputError({file_.string(), "line " + std::to_string(node.Mark().line + 1), problem});
  }

  const std::filesystem::path& file_;
  std::size_t left_;  // values that may still come
};

}  // namespace

bool has_yaml_name(const std::filesystem::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

JsonFile parse_yaml(const std::filesystem::path& file, const std::string& text) {
  try {
    const Json value = YamlReader(file, text.size()).value(YAML::Load(text), 1);
    // Bytes that are no UTF-8 are replaced: JSON cannot hold them.
    return {file, value.dump(-1, ' ', false, Json::error_handler_t::replace)};
  } catch (const YAML::Exception& error) {
    throw InputError({file.string(), "line " + std::to_string(error.mark.line + 1),
                      "must be YAML: " + on_one_line(error.msg)});
  }
}

JsonFile read_yaml(const std::filesystem::path& file) { return parse_yaml(file, read_file(file)); }

}  // namespace prehend

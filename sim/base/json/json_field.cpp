#include "sim/base/json/json_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_depth.h"
#include "sim/base/nearest_name.h"
#include "sim/base/range.h"

// A field knows its name as a path from the root of the file, for example
// obstacles[2].pose.position, which error messages begin with. The path is built on the way down:
// each access appends a key or an index.
namespace prehend {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestValue = 60;     // characters of a value shown in a message
constexpr std::size_t kLongestMessage = 200;  // characters of what the parser says

// A value as text for an error message, shortened; invalid UTF-8 is replaced.
std::string shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > kLongestValue) text = text.substr(0, kLongestValue) + "...";
  return text;
}

// Messages of the parser look like "[json.exception.parse_error.101] parse error at line 3, column
// 5: syntax error ...; ...": the place is repeated in front, so only what follows it is kept.
std::string without_prefix(std::string message) {
  const std::size_t bracket = message.find("] ");
  if (bracket != std::string::npos) message.erase(0, bracket + 2);
  const std::size_t colon = message.find(": ");
  if (message.starts_with("parse error at") && colon != std::string::npos) {
    message.erase(0, colon + 2);
  }
  // A quoted piece of the file may hold a line break; a message is one line.
  message = on_one_line(std::move(message));
  // It quotes the last token, which may be as long as the file.
  if (message.size() > kLongestMessage) message = message.substr(0, kLongestMessage) + "...";
  return message;
}

std::string line_of(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return "line " + std::to_string(1 + std::count(text.begin(), end, '\n'));
}

// Callback of the parser that rejects repeated names in one object: nlohmann::json silently keeps
// the last of them. The stack holds the names seen in each open object.
class RepeatedKeys {
 public:
  explicit RepeatedKeys(const std::filesystem::path& file) : file_(file) {}

  bool operator()(int /*depth*/, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key) {
      const std::string key = parsed.get<std::string>();
      if (!keys_.back().insert(key).second) {
        throw InputError({file_.string(), key, "must be given once in an object"});
      }
    }
    return true;
  }

 private:
  std::filesystem::path file_;
  std::vector<std::set<std::string>> keys_;
};

// Ranges are in SI units, which need not be those of the file.
std::string in_si(const std::string& words, double unit) {
  return unit == 1.0 ? words : words + " in SI units";
}

Json parse(const std::filesystem::path& file, const std::string& text) {
  if (json_depth(text) > kDeepestJson) {
    throw InputError(
        {.file = file.string(),
         .problem = "must be nested in at most " + std::to_string(kDeepestJson) + " levels"});
  }
  RepeatedKeys check(file);
  try {
    return Json::parse(text, [&check](int depth, Json::parse_event_t event, Json& parsed) {
      return check(depth, event, parsed);
    });
  } catch (const Json::parse_error& error) {
    // `byte` counts from one and points at the last character read.
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    throw InputError(
        {file.string(), line_of(text, byte), "must be JSON: " + without_prefix(error.what())});
  } catch (const Json::exception& error) {
    throw InputError(
        {.file = file.string(), .problem = "must be JSON: " + without_prefix(error.what())});
  }
}

}  // namespace

JsonFile::JsonFile(const std::filesystem::path& file) : JsonFile(file, read_file(file)) {}

JsonFile::JsonFile(std::filesystem::path file, const std::string& text)
    : path_(std::move(file)), value_(parse(path_, text)) {}

JsonField JsonFile::root() const { return JsonField(value_, path_, ""); }

void JsonField::fail(const std::string& what) const {
  throw InputError({file_->string(), name_, what, shown(*value_)});
}

void JsonField::fail(const InputError& error) const {
  throw error.under(name_).in_file(file_->string());
}

void JsonField::fail_about(const InputError& error) const {
  if (error.file() == file_->string()) throw error;
  throw error.about(name_, shown(*value_)).in_file(file_->string());
}

void JsonField::require_object() const {
  if (!value_->is_object()) fail("must be an object");
}

void JsonField::allow_only(std::span<const std::string_view> names) const {
  require_object();
  for (const auto& [key, value] : value_->items()) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    const std::string known = joined(names);
    const std::string nearest = nearest_name(key, {names.begin(), names.end()});
    JsonField(value, *file_, name_.empty() ? key : name_ + "." + key)
        .fail("unknown field, known here are " + known +
              (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
  }
}

bool JsonField::has(std::string_view key) const {
  require_object();
  return value_->contains(key);
}

JsonField JsonField::operator[](std::string_view key) const {
  require_object();
  const std::string full = name_.empty() ? std::string(key) : name_ + "." + std::string(key);
  const auto found = value_->find(key);
  if (found == value_->end()) {
    throw InputError({file_->string(), full, "must be given"});
  }
  return JsonField(*found, *file_, full);
}

std::vector<JsonField> JsonField::items() const {
  if (!value_->is_array()) fail("must be a list");
  std::vector<JsonField> fields;
  for (std::size_t i = 0; i < value_->size(); ++i) {
    fields.emplace_back((*value_)[i], *file_, name_ + "[" + std::to_string(i) + "]");
  }
  return fields;
}

std::vector<std::string> JsonField::keys() const {
  require_object();
  std::vector<std::string> names;
  for (const auto& [key, value] : value_->items()) names.push_back(key);
  return names;
}

double JsonField::number() const {
  if (!value_->is_number()) fail("must be a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("must be finite");
  if (std::abs(number) > kLargestNumber) fail("must not be beyond 1e30");
  return number;
}

double JsonField::number(const Range& range, double unit) const {
  const double value = unit * number();
  if (!range.contains(value)) fail(in_si(range.words(), unit));
  return value;
}

int JsonField::integer() const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
    fail("must be a whole number");
  }
  return static_cast<int>(value);
}

bool JsonField::boolean() const {
  if (!value_->is_boolean()) fail("must be true or false");
  return value_->get<bool>();
}

std::uint64_t JsonField::unsigned_integer() const {
  if (!value_->is_number_unsigned()) fail("must be a whole number from 0");
  return value_->get<std::uint64_t>();
}

std::string JsonField::text() const {
  if (!value_->is_string() || value_->get_ref<const std::string&>().empty()) {
    fail("must be a text that is not empty");
  }
  return value_->get<std::string>();
}

std::vector<double> JsonField::numbers(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count) {
    fail("must be a list of " + std::to_string(count) + " numbers");
  }
  std::vector<double> values;
  for (const JsonField& item : items()) values.push_back(item.number());
  return values;
}

std::vector<double> JsonField::numbers(std::size_t count, const Range& range, double unit) const {
  std::vector<double> values = numbers(count);
  for (double& value : values) {
    value *= unit;
    if (!range.contains(value)) fail(in_si("each " + range.words(), unit));
  }
  return values;
}

Vector3 JsonField::vector3(const Range& range, double unit) const {
  const std::vector<double> values = numbers(3, range, unit);
  return {values[0], values[1], values[2]};
}

Vector3 JsonField::vector3() const {
  const std::vector<double> values = numbers(3);
  return {values[0], values[1], values[2]};
}

Vector3 JsonField::direction() const {
  const Vector3 vector = vector3();
  if (!(vector.norm() > kShortestDirection)) fail("must not be the zero vector");
  return vector.normalized();
}

double JsonField::number_or(std::string_view key, double otherwise) const {
  return has(key) ? (*this)[key].number() : otherwise;
}

double JsonField::number_or(std::string_view key, double otherwise, const Range& range,
                            double unit) const {
  return has(key) ? (*this)[key].number(range, unit) : otherwise;
}

std::string JsonField::text_or(std::string_view key, const std::string& otherwise) const {
  return has(key) ? (*this)[key].text() : otherwise;
}

}  // namespace prehend

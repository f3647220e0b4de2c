// A value in a JSON file together with its place, so that every error names the file and the field.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/input_error.h"
#include "sim/base/pose.h"
#include "sim/base/range.h"

namespace prehend {

class JsonField;

// A parsed JSON file. JsonFields refer to it, so it must outlive them.
class JsonFile {
 public:
  // Reads and parses `file`. Throws InputError that names the file: when it cannot be read
  // (read_file), has a syntax error (with the line), is nested deeper than kDeepestJson, or has an
  // object with two fields of the same name (with the name).
  explicit JsonFile(const std::filesystem::path& file);
  // Parses `text` as the content of `file`, which is not opened. Throws as above.
  JsonFile(std::filesystem::path file, const std::string& text);

  const std::filesystem::path& path() const { return path_; }
  // The outermost value.
  JsonField root() const;

 private:
  std::filesystem::path path_;
  nlohmann::json value_;
};

// Vectors that give a direction must be longer: the square of a shorter one has few digits or none.
inline constexpr double kShortestDirection = 1e-100;

// A value in a JSON file. Every function that reads it throws InputError "FILE: FIELD: problem
// (VALUE)" when its type or value does not fit.
class JsonField {
 public:
  // `value` and `file` must outlive the field. `name` is the path of the field from the root, such
  // as "grasps[3].contacts"; empty for the root.
  JsonField(const nlohmann::json& value, const std::filesystem::path& file, std::string name)
      : value_(&value), file_(&file), name_(std::move(name)) {}

  // Throws InputError when the object has a field of another name, so that a misspelt field is not
  // silently ignored.
  void allow_only(std::span<const std::string_view> names) const;
  void allow_only(std::initializer_list<std::string_view> names) const {
    allow_only(std::span(names.begin(), names.size()));
  }

  // Whether the object has this field.
  bool has(std::string_view key) const;
  JsonField operator[](std::string_view key) const;  // of an object; missing is an error
  std::vector<JsonField> items() const;              // of an array
  std::vector<std::string> keys() const;             // of an object, sorted

  // The value, checked for its type. Numbers must be finite and at most kLargestNumber in size,
  // integers in the range of the type.
  double number() const;
  // A number that is in `range` in SI units, of which the file's own is `unit`; the SI value.
  double number(const Range& range, double unit = 1.0) const;
  int integer() const;
  bool boolean() const;
  std::uint64_t unsigned_integer() const;
  std::string text() const;  // not empty
  Vector3 vector3() const;
  Vector3 vector3(const Range& range, double unit = 1.0) const;  // of each coordinate
  Vector3 direction() const;  // a vector that is not zero (kShortestDirection), made unit
  // A list of exactly `count` finite numbers.
  std::vector<double> numbers(std::size_t count) const;
  std::vector<double> numbers(std::size_t count, const Range& range, double unit = 1.0) const;

  // Field `key` of an object, or `otherwise` when it is missing.
  double number_or(std::string_view key, double otherwise) const;
  double number_or(std::string_view key, double otherwise, const Range& range,
                   double unit = 1.0) const;  // `otherwise` in SI units
  std::string text_or(std::string_view key, const std::string& otherwise) const;

  bool is_null() const { return value_->is_null(); }
  bool is_text() const { return value_->is_string(); }
  bool is_list() const { return value_->is_array(); }
  bool is_object() const { return value_->is_object(); }
  std::string json() const { return value_->dump(); }  // the value as JSON text on one line

  const std::filesystem::path& file() const { return *file_; }
  const std::string& name() const { return name_; }

  // Throws InputError "FILE: FIELD: what (VALUE)".
  [[noreturn]] void fail(const std::string& what) const;
  // Throws `error` with the place of this field added: for errors of a function that was given the
  // read value, whose own field name lies inside this field.
  [[noreturn]] void fail(const InputError& error) const;
  // Throws `error` as one of this field (InputError::about): for errors of a function that was
  // given the read value under a name of its own. One that stands in this file stays as it is.
  [[noreturn]] void fail_about(const InputError& error) const;

 private:
  void require_object() const;

  const nlohmann::json* value_;
  const std::filesystem::path* file_;
  std::string name_;
};

// What `make` returns, which uses the value of the field; its InputErrors are told of the field
// (fail_about).
template <typename Make>
auto with_field_errors(const JsonField& field, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    field.fail_about(error);
  }
}

}  // namespace prehend

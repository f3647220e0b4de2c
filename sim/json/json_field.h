// A value in a JSON file that remembers where it stands, so that every complaint names file and
// field.
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

namespace prehend {

class JsonField;

// A parsed file; fields refer to it, so it must outlive them.
class JsonFile {
 public:
  // Throws InputError that names the file, and for bad syntax or a repeated key the line.
  explicit JsonFile(const std::filesystem::path& file);

  const std::filesystem::path& path() const { return path_; }
  JsonField root() const;

 private:
  std::filesystem::path path_;
  nlohmann::json value_;
};

// Every reader throws InputError "FILE: FIELD: what is wrong (VALUE)" when the value does not fit.
class JsonField {
 public:
  JsonField(const nlohmann::json& value, const std::filesystem::path& file, std::string name)
      : value_(&value), file_(&file), name_(std::move(name)) {}

  // An object may only have these fields: a misspelt one must not pass unnoticed.
  void allow_only(std::span<const std::string_view> names) const;
  void allow_only(std::initializer_list<std::string_view> names) const {
    allow_only(std::span(names.begin(), names.size()));
  }

  bool has(std::string_view key) const;
  JsonField operator[](std::string_view key) const;  // of an object; missing is an error
  std::vector<JsonField> items() const;              // of an array
  std::vector<std::string> keys() const;             // of an object, sorted

  double number() const;
  int integer() const;
  bool boolean() const;
  std::uint64_t unsigned_integer() const;
  std::string text() const;  // not empty
  Vector3 vector3() const;
  // `count` numbers.
  std::vector<double> numbers(std::size_t count) const;

  double number_or(std::string_view key, double otherwise) const;
  std::string text_or(std::string_view key, const std::string& otherwise) const;

  bool is_null() const { return value_->is_null(); }
  bool is_text() const { return value_->is_string(); }
  std::string json() const { return value_->dump(); }  // as it stands in the file, on one line

  const std::filesystem::path& file() const { return *file_; }
  const std::string& name() const { return name_; }

  // "FILE: FIELD: what (VALUE)"
  [[noreturn]] void fail(const std::string& what) const;
  // What a function that takes the read value refused it for: its field is one inside this field.
  [[noreturn]] void fail(const InputError& error) const;

 private:
  void require_object() const;

  const nlohmann::json* value_;
  const std::filesystem::path* file_;
  std::string name_;
};

}  // namespace prehend

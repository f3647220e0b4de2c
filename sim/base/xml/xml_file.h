// XML files and their elements, which know their place in the file for error messages.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/pose.h"

namespace tinyxml2 {
class XMLDocument;
// The check sees the class itself where its header is read as well: that one is not ours.
class XMLElement;  // NOLINT(cppcoreguidelines-virtual-class-destructor)
}  // namespace tinyxml2

namespace prehend {

class XmlElement;

// Where an element was written that became part of another file, for messages.
struct XmlPlace {
  std::string file;  // its name; empty: the file itself
  int line = 0;      // from 1
};

// A parsed XML file. XmlElements refer to it, so it must outlive them.
class XmlFile {
 public:
  // Reads and parses `file`. Throws InputError that names the file, with the line where it can:
  // when it cannot be read (read_file), is not well-formed, or defines entities, which no format
  // that prehend reads needs and which can grow without bound or name other files.
  explicit XmlFile(const std::filesystem::path& file);
  // Parses `text` as the content of `file`, which is not opened. Throws as above.
  XmlFile(std::filesystem::path file, const std::string& text);
  XmlFile(XmlFile&&) noexcept;
  XmlFile& operator=(XmlFile&&) noexcept;
  ~XmlFile();

  const std::filesystem::path& path() const { return path_; }
  // The outermost element.
  XmlElement root() const;

 private:
  friend class XmlMaker;

  std::filesystem::path path_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
  std::deque<XmlPlace> places_;  // of elements that XmlMaker has made, which point to them
};

// An element of an XML file. Every function that reads a value throws InputError
// "FILE: line 12, <joint>: problem (VALUE)" when it does not fit.
class XmlElement {
 public:
  // Both must outlive the element.
  XmlElement(const tinyxml2::XMLElement& element, const std::filesystem::path& file)
      : element_(&element), file_(&file) {}

  std::string name() const;  // the tag
  int line() const;          // from 1, in the file where it was written
  XmlPlace written() const;
  const std::filesystem::path& file() const { return *file_; }

  // Elements directly inside, in the order of the file; with a tag, only those.
  std::vector<XmlElement> children() const;
  std::vector<XmlElement> children(std::string_view tag) const;
  // The first of the tag; none: nothing, or an error.
  std::optional<XmlElement> child(std::string_view tag) const;
  XmlElement operator[](std::string_view tag) const;

  bool has(std::string_view attribute) const;
  std::vector<std::string> attributes() const;  // their names, in the order of the file
  // The value of an attribute; a missing one is an error. Text must not be empty.
  std::string text(std::string_view attribute) const;
  double number(std::string_view attribute) const;
  Vector3 vector3(std::string_view attribute) const;
  std::vector<double> numbers(std::string_view attribute) const;  // separated by white space
  // The value, or `otherwise` where the attribute is missing.
  std::string text_or(std::string_view attribute, const std::string& otherwise) const;
  double number_or(std::string_view attribute, double otherwise) const;
  Vector3 vector3_or(std::string_view attribute, const Vector3& otherwise) const;

  // As the file has it, maybe empty; also "" where it is missing.
  std::string raw(std::string_view attribute) const;

  // What stands between the tags, without white space around it; may be empty.
  std::string content() const;
  double content_number() const;
  std::vector<double> content_numbers() const;  // separated by white space

  // The same for a part of the content or of an attribute, which messages call `what`.
  double number_in(std::string_view part, const std::string& what) const;
  std::vector<double> numbers_in(std::string_view part, const std::string& what) const;

  // Throws InputError with the place of this element.
  [[noreturn]] void fail(const std::string& problem, const std::string& value = "") const;
  // Throws `error` as one of this element: for errors of a function that was given its values.
  [[noreturn]] void fail_about(const InputError& error) const;
  // "line 12, <joint>", and "arm.xml line 12, <joint>" where it was written in another file.
  std::string place() const;

 private:
  const tinyxml2::XMLElement* element_;
  const std::filesystem::path* file_;
};

// What `make` returns, which uses values of the element; its InputErrors are told of the element.
template <typename Make>
auto with_field_errors(const XmlElement& element, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    element.fail_about(error);
  }
}

}  // namespace prehend

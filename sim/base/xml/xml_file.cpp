#include "sim/base/xml/xml_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <tinyxml2.h>
#include <utility>

#include "sim/base/input_file.h"
#include "sim/base/range.h"

namespace prehend {
namespace {

constexpr std::size_t kLongestValue = 60;  // characters of a value shown in a message
constexpr std::string_view kBlanks = " \t\r\n";

std::string shown(std::string value) {
  if (value.size() > kLongestValue) value = value.substr(0, kLongestValue) + "...";
  return value;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string line_text(int line) { return "line " + std::to_string(line); }

std::string line_of(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(byte);
  return line_text(1 + static_cast<int>(std::count(text.begin(), end, '\n')));
}

// Messages of the parser look like "Error=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) Line
// number=3: XMLElement name=joint": of the error, only its name is plain.
std::string problem_of(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "there is no element";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "a tag is closed that is not open, or stays open";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deeply";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not written as name=\"value\"";
    default:
      return "must be well-formed XML";
  }
}

std::optional<double> number_of(std::string_view text) {
  // from_chars takes no plus sign.
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(value) || std::abs(value) > kLargestNumber) return std::nullopt;
  return value;
}

double read_number(const XmlElement& element, const std::string& what, std::string_view text) {
  const std::optional<double> value = number_of(trimmed(text));
  if (!value) element.fail(what + " must be a number, at most 1e30 in size", std::string(text));
  return *value;
}

std::vector<double> read_numbers(const XmlElement& element, const std::string& what,
                                 std::string_view text) {
  std::vector<double> values;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    values.push_back(read_number(element, what, text.substr(at, end - at)));
    at = text.find_first_not_of(kBlanks, end);
  }
  return values;
}

std::string named(std::string_view attribute) { return "attribute " + std::string(attribute); }

}  // namespace

XmlFile::XmlFile(const std::filesystem::path& file) : XmlFile(file, read_file(file)) {}

XmlFile::XmlFile(std::filesystem::path file, const std::string& text)
    : path_(std::move(file)),
      document_(std::make_unique<tinyxml2::XMLDocument>(true, tinyxml2::PRESERVE_WHITESPACE)) {
  if (const std::size_t at = text.find("<!ENTITY"); at != std::string::npos) {
    throw InputError({.file = path_.string(),
                      .field = line_of(text, at),
                      .problem = "entities must not be defined here"});
  }
  if (document_->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    const int line = document_->ErrorLineNum();
    throw InputError({.file = path_.string(),
                      .field = line > 0 ? line_text(line) : "",
                      .problem = problem_of(*document_)});
  }
  if (!document_->RootElement()) {
    throw InputError({.file = path_.string(), .problem = "there is no element"});
  }
}

XmlFile::XmlFile(XmlFile&&) noexcept = default;
XmlFile& XmlFile::operator=(XmlFile&&) noexcept = default;
XmlFile::~XmlFile() = default;

XmlElement XmlFile::root() const { return {*document_->RootElement(), path_}; }

std::string XmlElement::name() const { return element_->Name(); }

XmlPlace XmlElement::written() const {
  const void* place = element_->GetUserData();
  return place ? *static_cast<const XmlPlace*>(place) : XmlPlace{"", element_->GetLineNum()};
}

int XmlElement::line() const { return written().line; }

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> found;
  for (const auto* e = element_->FirstChildElement(); e; e = e->NextSiblingElement()) {
    found.emplace_back(*e, *file_);
  }
  return found;
}

std::vector<XmlElement> XmlElement::children(std::string_view tag) const {
  std::vector<XmlElement> found = children();
  std::erase_if(found, [&](const XmlElement& element) { return element.name() != tag; });
  return found;
}

std::optional<XmlElement> XmlElement::child(std::string_view tag) const {
  const auto* found = element_->FirstChildElement(std::string(tag).c_str());
  return found ? std::optional(XmlElement(*found, *file_)) : std::nullopt;
}

XmlElement XmlElement::operator[](std::string_view tag) const {
  const std::optional<XmlElement> found = child(tag);
  if (!found) fail("<" + std::string(tag) + "> is missing inside");
  return *found;
}

bool XmlElement::has(std::string_view attribute) const {
  return element_->Attribute(std::string(attribute).c_str()) != nullptr;
}

std::vector<std::string> XmlElement::attributes() const {
  std::vector<std::string> names;
  for (const auto* a = element_->FirstAttribute(); a; a = a->Next()) names.emplace_back(a->Name());
  return names;
}

std::string XmlElement::text(std::string_view attribute) const {
  const char* value = element_->Attribute(std::string(attribute).c_str());
  if (!value) fail(named(attribute) + " is missing");
  std::string text(trimmed(value));
  if (text.empty()) fail(named(attribute) + " is empty");
  return text;
}

std::string XmlElement::raw(std::string_view attribute) const {
  const char* value = element_->Attribute(std::string(attribute).c_str());
  return value ? value : "";
}

double XmlElement::number(std::string_view attribute) const {
  return read_number(*this, named(attribute), text(attribute));
}

std::vector<double> XmlElement::numbers(std::string_view attribute) const {
  return read_numbers(*this, named(attribute), text(attribute));
}

Vector3 XmlElement::vector3(std::string_view attribute) const {
  const std::vector<double> values = numbers(attribute);
  if (values.size() != 3) fail(named(attribute) + " must have three numbers", text(attribute));
  return {values[0], values[1], values[2]};
}

std::string XmlElement::text_or(std::string_view attribute, const std::string& otherwise) const {
  return has(attribute) ? text(attribute) : otherwise;
}

double XmlElement::number_or(std::string_view attribute, double otherwise) const {
  return has(attribute) ? number(attribute) : otherwise;
}

Vector3 XmlElement::vector3_or(std::string_view attribute, const Vector3& otherwise) const {
  return has(attribute) ? vector3(attribute) : otherwise;
}

std::string XmlElement::content() const {
  std::string text;
  for (const auto* node = element_->FirstChild(); node; node = node->NextSibling()) {
    if (const auto* piece = node->ToText()) text += piece->Value();
  }
  return std::string(trimmed(text));
}

double XmlElement::content_number() const { return read_number(*this, "the content", content()); }

std::vector<double> XmlElement::content_numbers() const {
  return read_numbers(*this, "the content", content());
}

double XmlElement::number_in(std::string_view part, const std::string& what) const {
  return read_number(*this, what, part);
}

std::vector<double> XmlElement::numbers_in(std::string_view part, const std::string& what) const {
  return read_numbers(*this, what, part);
}

void XmlElement::fail(const std::string& problem, const std::string& value) const {
  throw InputError(
      {.file = file_->string(), .field = place(), .problem = problem, .value = shown(value)});
}

void XmlElement::fail_about(const InputError& error) const {
  const std::string own = file_->string();
  throw error.file() == own ? error : error.about(place()).in_file(own);
}

std::string XmlElement::place() const {
  const XmlPlace at = written();
  return (at.file.empty() ? "" : at.file + " ") + line_text(at.line) + ", <" + name() + ">";
}

}  // namespace prehend

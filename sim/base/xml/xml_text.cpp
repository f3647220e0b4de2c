#include "sim/base/xml/xml_text.h"

#include <cassert>

#include <nlohmann/json.hpp>

#include "sim/base/number_text.h"

namespace prehend {
namespace {

// The writer of JSON knows UTF-8.
std::string utf8_text(std::string_view text) {
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
      .get<std::string>();
}

}  // namespace

std::string markup_text(std::string_view text) {
  std::string escaped;
  for (const char letter : utf8_text(text)) {
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += static_cast<unsigned char>(letter) < ' ' || letter == '\x7f' ? ' ' : letter;
    }
  }
  return escaped;
}

void XmlText::begin(const std::string& tag, const XmlAttributes& attributes) {
  text_ += std::string(2 * open_.size(), ' ') + "<" + tag;
  for (const auto& [name, value] : attributes) {
    text_ += " " + name + "=\"" + markup_text(value) + "\"";
  }
}

void XmlText::element(const std::string& tag, const XmlAttributes& attributes) {
  begin(tag, attributes);
  text_ += "/>\n";
}

void XmlText::open(const std::string& tag, const XmlAttributes& attributes) {
  begin(tag, attributes);
  text_ += ">\n";
  open_.push_back(tag);
}

void XmlText::close() {
  assert(!open_.empty());
  const std::string tag = open_.back();
  open_.pop_back();
  text_ += std::string(2 * open_.size(), ' ') + "</" + tag + ">\n";
}

void XmlText::comment(const std::string& text) {
  text_ += std::string(2 * open_.size(), ' ') + "<!-- " + text + " -->\n";
}

const std::string& XmlText::text() const {
  assert(open_.empty());
  return text_;
}

std::string numbers_text(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + number_text(value);
  return text;
}

std::string vector_text(const Vector3& v) { return numbers_text({v.x(), v.y(), v.z()}); }

std::string quaternion_text(const Pose& pose) {
  const Eigen::Quaterniond q = quaternion_of(pose).normalized();
  return numbers_text({q.w(), q.x(), q.y(), q.z()});
}

}  // namespace prehend

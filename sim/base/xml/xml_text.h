// XML and other markup as text, element by element.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// Text with the characters that HTML, SVG and XML reserve replaced. Control characters become
// spaces, and what is not UTF-8 becomes U+FFFD.
std::string markup_text(std::string_view text);

// Names and values of attributes, in their order. Values are written as markup_text.
using XmlAttributes = std::vector<std::pair<std::string, std::string>>;

class XmlText {
 public:
  // An element on a line of its own.
  void element(const std::string& tag, const XmlAttributes& attributes);
  // An element around those that follow, until close().
  void open(const std::string& tag, const XmlAttributes& attributes = {});
  void close();
  // Must not hold "--".
  void comment(const std::string& text);

  // All that was written; every element has to be closed.
  const std::string& text() const;

 private:
  void begin(const std::string& tag, const XmlAttributes& attributes);

  std::string text_;
  std::vector<std::string> open_;
};

// Numbers as number_text writes them, with spaces between.
std::string numbers_text(const std::vector<double>& values);
std::string vector_text(const Vector3& v);
// w x y z, of unit length, with w >= 0.
std::string quaternion_text(const Pose& pose);

}  // namespace prehend

// XML files that are made of the elements of others: of files that include others, repeat parts of
// themselves or compute what they say.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sim/base/xml/xml_file.h"

namespace prehend {

// Writes a file element by element. Each remembers where it was written, which messages name, so
// that they lead to what the user can change.
class XmlMaker {
 public:
  // `file`: the name of the whole. Elements that came from other files say so.
  explicit XmlMaker(std::filesystem::path file);
  ~XmlMaker();

  // An element around those that follow, until close(), with the place of `like` and its tag, or
  // another one, and without its attributes. Throws InputError where that makes more than 50,000
  // elements, or 100 inside each other.
  void open(const XmlElement& like);
  void open(const XmlElement& like, const std::string& tag);
  void attribute(const std::string& name, const std::string& value);
  void content(const std::string& text);
  void close();

  // `element` with all attributes and all that is in it, as it is.
  void copy(const XmlElement& element);

  // What was written: one element around all. The maker must not be used afterwards.
  XmlFile finished();

 private:
  XmlFile file_;
  tinyxml2::XMLElement* open_ = nullptr;  // the innermost; nullptr: none
  int count_ = 0;
  int depth_ = 0;
};

}  // namespace prehend

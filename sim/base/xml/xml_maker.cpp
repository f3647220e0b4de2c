#include "sim/base/xml/xml_maker.h"

#include <cassert>
#include <tinyxml2.h>
#include <utility>

namespace prehend {
namespace {

// A few lines that repeat each other could fill the memory otherwise.
constexpr int kMostElements = 50000;
constexpr int kDeepest = 100;

}  // namespace

XmlMaker::XmlMaker(std::filesystem::path file) : file_(std::move(file), "<made/>") {
  file_.document_->Clear();
}

XmlMaker::~XmlMaker() = default;

void XmlMaker::open(const XmlElement& like) { open(like, like.name()); }

void XmlMaker::open(const XmlElement& like, const std::string& tag) {
  if (++count_ > kMostElements) {
    like.fail("the file must not grow to more than " + std::to_string(kMostElements) + " elements");
  }
  if (++depth_ > kDeepest) like.fail("elements are nested too deeply");
  tinyxml2::XMLElement* made = file_.document_->NewElement(tag.c_str());
  XmlPlace place = like.written();
  if (place.file.empty() && like.file() != file_.path()) {
    place.file = like.file().filename().string();
  }
  file_.places_.push_back(std::move(place));
  made->SetUserData(&file_.places_.back());
  if (open_ != nullptr) {
    open_->InsertEndChild(made);
  } else {
    assert(file_.document_->RootElement() == nullptr);
    file_.document_->InsertEndChild(made);
  }
  open_ = made;
}

void XmlMaker::attribute(const std::string& name, const std::string& value) {
  open_->SetAttribute(name.c_str(), value.c_str());
}

void XmlMaker::content(const std::string& text) {
  open_->InsertEndChild(file_.document_->NewText(text.c_str()));
}

void XmlMaker::close() {
  open_ = open_->Parent()->ToElement();
  --depth_;
}

void XmlMaker::copy(const XmlElement& element) {
  open(element);
  for (const std::string& name : element.attributes()) attribute(name, element.raw(name));
  const std::string text = element.content();
  if (!text.empty()) content(text);
  for (const XmlElement& child : element.children()) copy(child);
  close();
}

XmlFile XmlMaker::finished() {
  assert(open_ == nullptr && file_.document_->RootElement() != nullptr);
  return std::move(file_);
}

}  // namespace prehend

#include "sim/robot/files/mjcf_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "sim/base/input_file.h"
#include "sim/base/xml/xml_maker.h"
#include "sim/base/xml/xml_text.h"
#include "sim/robot/files/mjcf_defaults.h"

namespace prehend {
namespace {

constexpr std::size_t kMostIncluded = 200;
constexpr int kMostCopies = 10000;        // of one <replicate>
constexpr int kMostCopiesInAll = 100000;  // which may be nested, also around nothing

// Copies a file with the content of included files in its place. Their names are relative to the
// file that includes all others, or else to the one that names them.
class MjcfIncluder {
 public:
  explicit MjcfIncluder(const XmlFile& file) : file_(file), maker_(file.path()) {}

  XmlFile whole() {
    copy(file_.root());
    return maker_.finished();
  }

 private:
  void copy(const XmlElement& element) {
    if (element.name() == "include") return include(element);
    maker_.open(element);
    for (const std::string& name : element.attributes()) maker_.attribute(name, element.raw(name));
    for (const XmlElement& child : element.children()) copy(child);
    maker_.close();
  }

  void include(const XmlElement& element) {
    const std::filesystem::path name = element.text("file");
    std::filesystem::path path = file_.path().parent_path() / name;
    if (!is_file(path)) path = element.file().parent_path() / name;
    if (!is_file(path))
      element.fail("no such file: it must be there, relative to this one", name.string());
    if (files_.size() == kMostIncluded) {
      element.fail("more than 200 files are included: does one include itself?");
    }
    files_.emplace_back(path);
    for (const XmlElement& child : files_.back().root().children()) copy(child);
  }

  const XmlFile& file_;
  std::deque<XmlFile> files_;
  XmlMaker maker_;
};

// Copies a file with what is in frames, at its pose in the body around them.
class MjcfUnframer {
 public:
  explicit MjcfUnframer(const XmlFile& file)
      : root_(file.root()), defaults_(root_), maker_(file.path()) {}

  XmlFile whole() {
    maker_.open(root_);
    attributes(root_, {});
    for (const XmlElement& section : root_.children()) {
      if (section.name() == "worldbody") {
        inside(section, {}, {});
      } else {
        maker_.copy(section);
      }
    }
    maker_.close();
    return maker_.finished();
  }

 private:
  // What the frames around an element say of it.
  struct Around {
    Pose X_BF = Pose::Identity();  // of the innermost frame in the body
    bool is_moved = false;         // whether there is one
    std::string childclass = {};   // of the body or the frames; empty: none
    bool has_class = false;        // whether a frame says it
    std::string suffix = {};       // of names
  };

  // A body, with what its own content has around it.
  void inside(const XmlElement& element, const Around& around, const Around& of_content) {
    maker_.open(element);
    attributes(element, around);
    for (const XmlElement& child : element.children()) place(child, of_content);
    maker_.close();
  }

  void place(const XmlElement& element, const Around& around) {
    const std::string name = element.name();
    if (name == "frame") return open_frame(element, around);
    if (name == "replicate") return replicate(element, around);
    if (name == "body") {
      const std::string childclass = element.text_or("childclass", around.childclass);
      return inside(element, around, {.childclass = childclass, .suffix = around.suffix});
    }
    if (around.is_moved && (name == "joint" || name == "freejoint" || name == "inertial")) {
      element.fail("cannot stand in a frame");
    }
    maker_.open(element);
    attributes(element, around);
    for (const XmlElement& child : element.children()) maker_.copy(child);
    maker_.close();
  }

  void open_frame(const XmlElement& element, Around around) {
    around.X_BF = around.X_BF * defaults_.pose(element, around.childclass);
    around.is_moved = true;
    if (element.has("childclass")) {
      around.childclass = element.text("childclass");
      around.has_class = true;
    }
    for (const XmlElement& child : element.children()) place(child, around);
  }

  // Copy k is moved k times, each time on from the one before.
  void replicate(const XmlElement& element, Around around) {
    const double count = element.number("count");
    if (!(count >= 1.0 && count <= kMostCopies && count == std::floor(count))) {
      element.fail("count must be a whole number from 1 to " + std::to_string(kMostCopies),
                   element.text("count"));
    }
    const Vector3 offset = element.vector3_or("offset", Vector3::Zero());
    const Matrix3 turn =
        element.has("euler") ? defaults_.from_euler(element.vector3("euler")) : Matrix3::Identity();
    const std::string before = around.suffix + element.raw("sep");
    const std::size_t digits = std::to_string(static_cast<int>(count) - 1).size();
    around.is_moved = true;
    for (int k = 0; k < static_cast<int>(count); ++k) {
      if (++copies_ > kMostCopiesInAll) {
        element.fail("the file must not make more than " + std::to_string(kMostCopiesInAll) +
                     " copies");
      }
      const std::string number = std::to_string(k);
      around.suffix = before;
      around.suffix.append(digits - number.size(), '0').append(number);
      for (const XmlElement& child : element.children()) place(child, around);
      around.X_BF = around.X_BF * pose_from(turn, offset);
    }
  }

  void attributes(const XmlElement& element, const Around& around) {
    const std::string name = element.name();
    const bool has_pose = around.is_moved && (name == "body" || name == "geom" || name == "site" ||
                                              name == "camera" || name == "light");
    for (const std::string& attribute : element.attributes()) {
      static constexpr std::array<std::string_view, 7> kOfPose = {
          "pos", "quat", "axisangle", "euler", "xyaxes", "zaxis", "fromto"};
      const bool is_of_pose = std::find(kOfPose.begin(), kOfPose.end(), attribute) != kOfPose.end();
      if (has_pose && is_of_pose) continue;
      maker_.attribute(attribute,
                       element.raw(attribute) + (attribute == "name" ? around.suffix : ""));
    }
    if (around.has_class) {
      const std::string attribute = name == "body" ? "childclass" : "class";
      if (!element.has(attribute)) maker_.attribute(attribute, around.childclass);
    }
    if (has_pose) write_pose(element, around);
  }

  void write_pose(const XmlElement& element, const Around& around) {
    const auto ends = element.name() == "body"
                          ? std::nullopt
                          : defaults_.saying("fromto", element, around.childclass);
    if (ends) {
      std::vector<double> moved;
      const std::vector<double> at = ends->numbers("fromto");
      if (at.size() != 6) ends->fail("attribute fromto must have 6 numbers");
      for (std::size_t k = 0; k < 6; k += 3) {
        const Vector3 p = around.X_BF * Vector3(at[k], at[k + 1], at[k + 2]);
        moved.insert(moved.end(), {p.x(), p.y(), p.z()});
      }
      maker_.attribute("fromto", numbers_text(moved));
      return;
    }
    const Pose X_BE = around.X_BF * defaults_.pose(element, around.childclass);
    maker_.attribute("pos", vector_text(Vector3(X_BE.translation())));
    maker_.attribute("quat", quaternion_text(X_BE));
  }

  XmlElement root_;
  MjcfDefaults defaults_;
  XmlMaker maker_;
  int copies_ = 0;
};

bool has_inside(const XmlElement& element, std::string_view tag) {
  const std::vector<XmlElement> children = element.children();
  return std::any_of(children.begin(), children.end(), [&](const XmlElement& child) {
    return child.name() == tag || has_inside(child, tag);
  });
}

}  // namespace

XmlFile whole_mjcf(const XmlFile& file) {
  const XmlFile included = MjcfIncluder(file).whole();
  return MjcfUnframer(included).whole();
}

bool has_mjcf_parts(const XmlFile& file) {
  const XmlElement root = file.root();
  return has_inside(root, "include") || has_inside(root, "frame") || has_inside(root, "replicate");
}

}  // namespace prehend

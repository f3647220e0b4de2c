#include "sim/robot/files/sdf_parts.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/xml/xml_maker.h"

namespace prehend {
namespace {

constexpr std::size_t kMostSdfFiles = 200;
constexpr int kDeepestModel = 20;
constexpr int kMostModelVisits = 10000;  // a few files that include each other could make millions
constexpr const char* kOwnFrame = "__model__";

// Names inside a model: what stands before them, and the frame that the model itself is.
struct SdfScope {
  std::string prefix = {};
  std::string model = kOwnFrame;

  std::string name(const std::string& name) const {
    if (name == kOwnFrame) return model;
    return name == "world" ? name : prefix + name;
  }
};

// A model that stands in the file or is included by it.
struct SdfPart {
  XmlElement model;
  std::optional<XmlElement> include = {};  // what says its name and place
};

bool has_moving_joint(const XmlElement& model) {
  for (const XmlElement& child : model.children()) {
    if (child.name() == "joint" && child.text_or("type", "fixed") != "fixed") return true;
    if (child.name() == "model" && has_moving_joint(child)) return true;
  }
  return false;
}

bool is_before_1_5(const std::string& version) {
  return version == "1.4" || version == "1.3" || version == "1.2" || version == "1.0";
}

class SdfJoiner {
 public:
  SdfJoiner(const XmlFile& file, const PackageFolders& packages)
      : file_(file), packages_(packages), maker_(file.path()) {}

  XmlFile whole() {
    const XmlElement root = file_.root();
    const SdfPart robot = robot_of(root);
    maker_.open(root);
    maker_.attribute("version", root.text_or("version", "1.7"));
    maker_.open(robot.model, "model");
    const std::string name = name_of_part(robot);
    if (!name.empty()) maker_.attribute("name", name);
    content_of(robot.model, {}, 0);
    maker_.close();
    maker_.close();
    return maker_.finished();
  }

 private:
  // Of all models in the file and its worlds.
  SdfPart robot_of(const XmlElement& root) {
    std::vector<SdfPart> all;
    std::optional<InputError> missing;
    std::vector<XmlElement> sections = root.children("world");
    sections.insert(sections.begin(), root);
    for (const XmlElement& section : sections) {
      for (const XmlElement& child : section.children()) {
        if (child.name() == "model") all.push_back({child});
        if (child.name() != "include") continue;
        try {
          all.push_back({included(child), child});
        } catch (const InputError& error) {
          if (!missing) missing = error;
        }
      }
    }
    std::vector<SdfPart> robots;
    for (const SdfPart& part : all) {
      if (has_robot_inside(part.model, 0)) robots.push_back(part);
    }
    if (robots.empty() && missing) throw InputError(*missing);
    if (robots.empty()) robots = all;
    if (robots.empty()) root.fail("there is no <model> inside");
    if (robots.size() > 1) {
      std::string names;
      for (const SdfPart& part : robots) names += (names.empty() ? "" : ", ") + name_of_part(part);
      robots[1].model.fail("there are several models; give a file of one", names);
    }
    return robots.front();
  }

  // Includes are looked at for the first of them that can be read.
  bool has_robot_inside(const XmlElement& model, int depth) {
    visit(model, depth);
    if (has_moving_joint(model)) return true;
    const std::vector<XmlElement> inside = model.children("include");
    return std::any_of(inside.begin(), inside.end(), [&](const XmlElement& include) {
      return has_robot_inside(included(include), depth + 1);
    });
  }

  void visit(const XmlElement& model, int depth) {
    if (depth <= kDeepestModel && ++visits_ <= kMostModelVisits) return;
    model.fail("models must be inside each other at most 20 deep, and 10,000 in all");
  }

  static std::string name_of_part(const SdfPart& part) {
    const std::optional<XmlElement> name =
        part.include ? part.include->child("name") : std::nullopt;
    return name ? name->content() : part.model.raw("name");
  }

  // The model that an <include> names.
  XmlElement included(const XmlElement& include) {
    const std::string uri = include["uri"].content();
    if (uri.starts_with("http://") || uri.starts_with("https://")) {
      include.fail("only local models can be read: save it, and name its folder", uri);
    }
    if (const auto frame = include.child("placement_frame")) {
      frame->fail("cannot be read; save the model as one (gz sdf -p FILE)", frame->content());
    }
    const std::filesystem::path path = model_file(include, uri);
    auto known = files_.find(path);
    if (known == files_.end()) {
      if (files_.size() == kMostSdfFiles) include.fail("more than 200 files are included");
      known = files_.emplace(path, XmlFile(path)).first;
    }
    const XmlElement root = known->second.root();
    const std::optional<XmlElement> model =
        root.name() == "sdf" ? root.child("model") : std::nullopt;
    if (!model) root.fail("must be an SDF file with a <model> inside");
    return *model;
  }

  std::filesystem::path model_file(const XmlElement& include, std::string uri) const {
    while (uri.ends_with('/')) uri.pop_back();
    return with_field_errors(include, [&] {
      if (uri.ends_with(".sdf")) return resolved_uri(uri, include.file(), packages_);
      std::optional<std::filesystem::path> config;
      try {
        config = resolved_uri(uri + "/model.config", include.file(), packages_);
      } catch (const InputError&) {
        return resolved_uri(uri + "/model.sdf", include.file(), packages_);
      }
      const XmlFile described(*config);
      const std::vector<XmlElement> versions = described.root().children("sdf");
      if (versions.empty()) described.root().fail("must name the model's file in <sdf>");
      return config->parent_path() / versions.back().content();
    });
  }

  void content_of(const XmlElement& model, const SdfScope& scope, int depth) {
    visit(model, depth);
    for (const XmlElement& child : model.children()) {
      const std::string tag = child.name();
      if (tag == "model") inner_model({child}, scope, depth);
      if (tag == "include") inner_model({included(child), child}, scope, depth);
      if (tag == "link" || tag == "joint" || tag == "frame") part_of(child, scope);
    }
  }

  // A model becomes a frame of its name, and its content.
  void inner_model(const SdfPart& part, const SdfScope& around, int depth) {
    const std::string name = name_of_part(part);
    if (name.empty()) part.model.fail("attribute name is missing");
    const bool is_merged =
        (part.include ? *part.include : part.model).text_or("merge", "false") == "true";
    SdfScope scope{.prefix = around.prefix + name + "::", .model = around.prefix + name};
    if (is_merged) scope = {.prefix = around.prefix, .model = around.prefix + "merged " + name};
    const std::optional<std::string> link = canonical_link(part.model, scope, depth);
    if (!link) part.model.fail("must have a link", name);
    std::optional<XmlElement> pose = part.include ? part.include->child("pose") : std::nullopt;
    if (!pose) pose = part.model.child("pose");
    maker_.open(part.model, "frame");
    maker_.attribute("name", scope.model);
    maker_.attribute("attached_to", *link);
    place(part.model, pose, around, around.model);
    maker_.close();
    content_of(part.model, scope, depth + 1);
  }

  std::optional<std::string> canonical_link(const XmlElement& model, const SdfScope& scope,
                                            int depth) {
    visit(model, depth);
    if (model.has("canonical_link")) return scope.name(model.text("canonical_link"));
    if (const auto link = model.child("link")) return scope.name(link->text("name"));
    for (const XmlElement& child : model.children()) {
      if (child.name() != "model" && child.name() != "include") continue;
      const bool is_included = child.name() == "include";
      const SdfPart part = is_included ? SdfPart{included(child), child} : SdfPart{child};
      const SdfScope inner{.prefix = scope.prefix + name_of_part(part) + "::"};
      if (const auto link = canonical_link(part.model, inner, depth + 1)) return link;
    }
    return std::nullopt;
  }

  // A <pose>, relative to `otherwise` where it does not say to what.
  void place(const XmlElement& like, const std::optional<XmlElement>& pose, const SdfScope& scope,
             const std::string& otherwise) {
    maker_.open(pose ? *pose : like, "pose");
    if (pose) {
      for (const char* attribute : {"degrees", "rotation_format"}) {
        if (pose->has(attribute)) maker_.attribute(attribute, pose->text(attribute));
      }
    }
    const bool says = pose && pose->has("relative_to");
    const std::string base = says ? scope.name(pose->text("relative_to")) : otherwise;
    if (!base.empty()) maker_.attribute("relative_to", base);
    if (pose && !pose->content().empty()) maker_.content(pose->content());
    maker_.close();
  }

  // A link, joint or frame.
  void part_of(const XmlElement& element, const SdfScope& scope) {
    maker_.open(element);
    const std::string tag = element.name();
    maker_.attribute("name", scope.name(element.text("name")));
    if (element.has("type")) maker_.attribute("type", element.text("type"));
    std::string base = tag == "link" ? scope.model : "";
    if (tag == "frame") {
      base = scope.name(element.text_or("attached_to", kOwnFrame));
      maker_.attribute("attached_to", base);
    }
    place(element, element.child("pose"), scope, base);
    for (const XmlElement& child : element.children()) {
      if (child.name() != "pose") inside(child, element, scope);
    }
    maker_.close();
  }

  // What stands in a link or joint, `of`.
  void inside(const XmlElement& element, const XmlElement& of, const SdfScope& scope) {
    const std::string tag = element.name();
    maker_.open(element);
    for (const std::string& name : element.attributes()) {
      const bool is_scoped = name == "relative_to" || name == "expressed_in" || name == "joint";
      maker_.attribute(name, is_scoped ? scope.name(element.text(name)) : element.raw(name));
    }
    if (tag == "xyz" && of.name() == "joint" && !element.has("expressed_in")) {
      maker_.attribute("expressed_in", frame_of_axis(of, scope));
    }
    std::string text = element.content();
    if (tag == "uri") text = found_mesh(element);
    if (of.name() == "joint" && (tag == "parent" || tag == "child")) text = scope.name(text);
    if (!text.empty()) maker_.content(text);
    for (const XmlElement& child : element.children()) inside(child, of, scope);
    maker_.close();
  }

  // Before 1.5 axes are those of the model, and later where the file says so.
  std::string frame_of_axis(const XmlElement& joint, const SdfScope& scope) const {
    const std::optional<XmlElement> axis = joint.child("axis");
    const std::optional<XmlElement> word =
        axis ? axis->child("use_parent_model_frame") : std::nullopt;
    bool is_early = false;
    const auto known = files_.find(joint.file());
    const XmlElement root = known == files_.end() ? file_.root() : known->second.root();
    is_early = is_before_1_5(root.text_or("version", "1.7"));
    const bool in_model = word ? word->content() == "1" || word->content() == "true" : is_early;
    return in_model ? scope.model : scope.name(joint.text("name"));
  }

  // Where the file of a mesh is; as it is written where it is not found.
  std::string found_mesh(const XmlElement& uri) const {
    if (uri.file() == file_.path()) return uri.content();
    try {
      return resolved_uri(uri.content(), uri.file(), packages_).string();
    } catch (const InputError&) {
      return uri.content();
    }
  }

  const XmlFile& file_;
  const PackageFolders& packages_;
  std::map<std::filesystem::path, XmlFile> files_;  // that are included
  XmlMaker maker_;
  int visits_ = 0;
};

// Whether it is one model without others inside.
bool is_whole(const XmlElement& root) {
  const std::vector<XmlElement> models = root.children("model");
  return models.size() == 1 && !root.child("world") && !root.child("include") &&
         !models.front().child("model") && !models.front().child("include");
}

}  // namespace

XmlFile whole_sdf(const XmlFile& file, const PackageFolders& packages) {
  if (is_whole(file.root())) {
    XmlMaker maker(file.path());
    maker.copy(file.root());
    return maker.finished();
  }
  return SdfJoiner(file, packages).whole();
}

}  // namespace prehend

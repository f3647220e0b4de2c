#include "sim/robot/files/xacro_file.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/json/yaml_file.h"
#include "sim/base/xml/xml_maker.h"
#include "sim/robot/files/xacro_expression.h"
#include "sim/robot/files/xacro_members.h"
#include "sim/robot/files/xacro_parameters.h"

namespace prehend {
namespace {

constexpr int kDeepestUse = 60;  // macros, blocks, includes and properties inside each other
constexpr std::size_t kMostFiles = 200;
constexpr int kMostSteps = 1000000;  // elements and properties that are looked at
constexpr std::string_view kPrefix = "xacro:";
constexpr const char* kNameOfElement = "xacro:name";

class XacroScope;

// Elements that a macro or a property holds for later, and where their words are known.
struct XacroBlock {
  std::vector<XmlElement> elements = {};
  XacroScope* scope = nullptr;
};

struct XacroProperty {
  std::string text = {};  // where there is no value yet
  std::optional<XacroValue> value = {};
  bool is_computed = false;  // at this moment
};

struct XacroMacro {
  XmlElement element;
  std::vector<XacroParameter> parameters;
};

// The macros of the file, or of a file that was included with a namespace, and the namespaces in
// it.
struct XacroSpace {
  std::map<std::string, XacroMacro> macros = {};
  std::map<std::string, XacroScope*> spaces = {};
};

// What belongs to the whole run.
struct XacroRun {
  const ForeignRobotOptions& options;
  std::map<std::string, std::string> arguments = {};
  std::filesystem::path folder = {};   // of the file
  std::filesystem::path reading = {};  // the file that is included now, or the file itself
  std::map<std::filesystem::path, XacroValue> data = {};  // YAML files that were read
  int depth = 0;
  int steps = 0;

  void step() {
    if (++steps > kMostSteps) throw InputError("xacro takes too many steps: is a macro endless?");
  }
};

// Counts how deep things are inside each other.
class Deeper {
 public:
  explicit Deeper(XacroRun& run) : run_(run) {
    if (++run_.depth > kDeepestUse) {
      --run_.depth;
      throw InputError("macros, blocks and properties must use each other at most 60 deep");
    }
  }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;
  ~Deeper() { --run_.depth; }

 private:
  XacroRun& run_;
};

// The names that are known in the file, or in one call of a macro.
class XacroScope : public XacroWords {
 public:
  XacroScope(XacroRun& run, XacroSpace& space, XacroScope* around)
      : run_(run), space_(space), around_(around) {}

  XacroValue property(const std::string& name) override {
    run_.step();
    XacroScope* owner = owner_of(name);
    if (!owner) throw InputError({.problem = "no property of this name", .value = name});
    return owner->own_value(name);
  }

  std::string command(const std::string& words) override {
    const std::size_t blank = std::min(words.find(' '), words.size());
    const std::string what = words.substr(0, blank);
    const std::string name =
        words.substr(std::min(words.find_first_not_of(' ', blank), words.size()));
    // resolved_uri knows where packages are.
    if (what == "find" && !name.empty()) return "package://" + name;
    if (what == "dirname") return run_.folder.string();
    if (what == "cwd") return std::filesystem::current_path().string();
    // A variable of the environment is not asked for: results would depend on it.
    if (what == "optenv") {
      const std::size_t otherwise = std::min(name.find(' '), name.size());
      return name.substr(std::min(name.find_first_not_of(' ', otherwise), name.size()));
    }
    if (what != "arg") {
      throw InputError(
          {.problem = "$(...) can be find, arg, eval, optenv, cwd or dirname here; expand the file "
                      "with xacro first (xacro FILE > FILE.urdf)",
           .value = words});
    }
    const auto found = run_.arguments.find(name);
    if (found == run_.arguments.end()) {
      throw InputError({.problem = "the argument has no value: state it in \"arguments\" of "
                                   "NAME.prehend.json beside the file",
                        .value = name});
    }
    return found->second;
  }

  std::optional<XacroValue> property_of(const std::string& space,
                                        const std::string& name) override {
    const auto found = space_.spaces.find(space);
    if (found == space_.spaces.end()) return std::nullopt;
    return found->second->property(name);
  }

  XacroValue load_yaml(const std::string& name) override {
    const std::filesystem::path path = resolved_uri(name, run_.reading, run_.options.packages);
    const auto known = run_.data.find(path);
    if (known != run_.data.end()) return known->second;
    if (run_.data.size() >= kMostFiles) throw InputError("more than 200 YAML files are read");
    return run_.data[path] = xacro_value_of(read_yaml(path).root());
  }

  // The macro of this name, which may begin with namespaces, and the scope that it belongs to: null
  // where that is not another one than this.
  std::pair<const XacroMacro*, XacroScope*> macro(const std::string& name) {
    const std::size_t dot = name.find('.');
    const auto inner = space_.spaces.find(name.substr(0, dot));
    if (dot != std::string::npos && inner != space_.spaces.end()) {
      const auto [found, owner] = inner->second->macro(name.substr(dot + 1));
      return {found, owner ? owner : inner->second};
    }
    const auto found = space_.macros.find(name);
    return {found == space_.macros.end() ? nullptr : &found->second, nullptr};
  }

  XacroSpace& space() { return space_; }
  bool knows(const std::string& name) { return owner_of(name) != nullptr; }
  void set(const std::string& name, XacroProperty property) {
    properties_[name] = std::move(property);
  }
  void set_block(const std::string& name, XacroBlock block) { blocks_[name] = std::move(block); }

  const XacroBlock* block(const std::string& name) const {
    const auto found = blocks_.find(name);
    if (found != blocks_.end()) return &found->second;
    return around_ ? around_->block(name) : nullptr;
  }

  XacroScope* around() const { return around_; }
  XacroScope& outermost() { return around_ ? around_->outermost() : *this; }

 private:
  XacroScope* owner_of(const std::string& name) {
    if (properties_.contains(name)) return this;
    return around_ ? around_->owner_of(name) : nullptr;
  }

  // Computed when it is first asked for: it may use what is defined behind it.
  XacroValue own_value(const std::string& name) {
    XacroProperty& found = properties_.at(name);
    if (found.value) return *found.value;
    if (found.is_computed)
      throw InputError({.problem = "the property must not use itself", .value = name});
    const Deeper deeper(run_);
    found.is_computed = true;
    XacroValue value = xacro_value(found.text, *this);
    found.is_computed = false;
    found.value = value;
    return value;
  }

  XacroRun& run_;
  XacroSpace& space_;
  XacroScope* around_;
  std::map<std::string, XacroProperty> properties_;
  std::map<std::string, XacroBlock> blocks_;
};

class XacroExpansion {
 public:
  XacroExpansion(const XmlFile& file, const ForeignRobotOptions& options)
      : file_(file),
        options_(options),
        maker_(file.path()),
        run_{options, options.arguments, std::filesystem::absolute(file.path()).parent_path(),
             file.path()},
        outermost_(run_, space_, nullptr) {}

  XmlFile expanded() {
    const XmlElement root = file_.root();
    plain(root, outermost_);
    XmlFile made = maker_.finished();
    if (made.root().children().empty() && !space_.macros.empty()) {
      root.fail("the file only defines macros; give the one that calls them",
                space_.macros.begin()->first);
    }
    return made;
  }

 private:
  // What `make` computes; its errors are those of the element.
  template <typename Make>
  auto at(const XmlElement& element, const Make& make) {
    return with_field_errors(element, make);
  }

  std::string text(const XmlElement& element, const std::string& attribute, XacroScope& scope) {
    return at(element, [&] { return xacro_text(element.text(attribute), scope); });
  }

  void inside(const std::vector<XmlElement>& elements, XacroScope& scope) {
    for (const XmlElement& element : elements) expand(element, scope);
  }

  void expand(const XmlElement& element, XacroScope& scope) {
    at(element, [&] { run_.step(); });
    const std::string name = element.name();
    if (!name.starts_with(kPrefix)) return plain(element, scope);
    directive(name.substr(kPrefix.size()), element, scope);
  }

  void plain(const XmlElement& element, XacroScope& scope) {
    plain(element, element.name(), scope);
  }

  void plain(const XmlElement& element, const std::string& tag, XacroScope& scope) {
    maker_.open(element, tag);
    for (const std::string& name : element.attributes()) {
      if (name == "xmlns:xacro" || name == kNameOfElement) continue;
      maker_.attribute(name, at(element, [&] { return xacro_text(element.raw(name), scope); }));
    }
    const std::vector<XmlElement> children = element.children();
    if (children.empty() && !element.content().empty()) {
      maker_.content(at(element, [&] { return xacro_text(element.content(), scope); }));
    }
    inside(children, scope);
    maker_.close();
  }

  void directive(const std::string& name, const XmlElement& element, XacroScope& scope) {
    if (name == "property") return define(element, scope);
    if (name == "macro") return define_macro(element, scope);
    if (name == "arg") return define_argument(element, scope);
    if (name == "include") return include(element, scope);
    if (name == "insert_block") return insert(element, scope);
    if (name == "if" || name == "unless") {
      const bool holds_here =
          at(element, [&] { return holds(xacro_value(element.text("value"), scope)); });
      if (holds_here == (name == "if")) inside(element.children(), scope);
      return;
    }
    if (name == "call") return call(text(element, "macro", scope), element, scope);
    if (name == "element") return plain(element, xml_name(element, kNameOfElement, scope), scope);
    // Of the element around it, which is still open.
    if (name == "attribute") {
      const std::string attribute = xml_name(element, "name", scope);
      maker_.attribute(attribute,
                       at(element, [&] { return xacro_text(element.raw("value"), scope); }));
      return;
    }
    call(name, element, scope);
  }

  // The name of an element or attribute that is computed.
  std::string xml_name(const XmlElement& element, const std::string& attribute, XacroScope& scope) {
    const std::string name = text(element, attribute, scope);
    const auto is_of_name = [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ':' || c > 127;
    };
    const bool is_name =
        !name.empty() && std::all_of(name.begin(), name.end(), is_of_name) &&
        (std::isalpha(static_cast<unsigned char>(name[0])) != 0 || name[0] == '_') &&
        !name.starts_with(kPrefix);
    if (!is_name) element.fail("must have a name that XML knows, not one of xacro", name);
    return name;
  }

  void define(const XmlElement& element, XacroScope& scope) {
    const std::string name = text(element, "name", scope);
    const bool has_text = element.has("value") || element.has("default");
    if (!has_text) return scope.set_block(name, {element.children(), &scope});
    if (!element.has("value") && scope.knows(name)) return;
    const std::string value = element.raw(element.has("value") ? "value" : "default");
    const std::string where = element.text_or("scope", "");
    const bool is_lazy = element.text_or("lazy_eval", "true") != "false";
    if (where.empty() && is_lazy) return scope.set(name, {.text = value});
    XacroScope* target = where.empty()                         ? &scope
                         : where == "global"                   ? &scope.outermost()
                         : where == "parent" && scope.around() ? scope.around()
                                                               : nullptr;
    if (!target) element.fail("scope must be parent, inside a macro, or global", where);
    target->set(name, {.value = at(element, [&] { return xacro_value(value, scope); })});
  }

  void define_macro(const XmlElement& element, XacroScope& scope) {
    std::string name = element.text("name");
    if (name.starts_with(kPrefix)) name.erase(0, kPrefix.size());
    std::vector<XacroParameter> parameters =
        at(element, [&] { return xacro_parameters(element.raw("params")); });
    scope.space().macros.insert_or_assign(name, XacroMacro{element, std::move(parameters)});
  }

  void define_argument(const XmlElement& element, XacroScope& scope) {
    const std::string name = text(element, "name", scope);
    if (run_.arguments.contains(name) || !element.has("default")) return;
    run_.arguments[name] = at(element, [&] { return xacro_text(element.raw("default"), scope); });
  }

  void include(const XmlElement& element, XacroScope& scope) {
    const std::string name = text(element, "filename", scope);
    const XmlFile* included = nullptr;
    try {
      const std::filesystem::path path = resolved_uri(name, element.file(), options_.packages);
      if (files_.size() >= kMostFiles) throw InputError("more than 200 files are included");
      files_.emplace_back(path);
      included = &files_.back();
    } catch (const InputError& error) {
      if (element.text_or("optional", "") == "true") return;
      element.fail_about(error);
    }
    XacroScope& inner = element.has("ns") ? named_scope(text(element, "ns", scope), scope) : scope;
    const std::filesystem::path around = std::exchange(run_.reading, included->path());
    at(element, [&] {
      const Deeper deeper(run_);
      inside(included->root().children(), inner);
    });
    run_.reading = around;
  }

  // Names in a file that is included with a namespace are its own.
  XacroScope& named_scope(const std::string& name, XacroScope& scope) {
    XacroSpace& space = spaces_.emplace_back();
    XacroScope& made = scopes_.emplace_back(run_, space, nullptr);
    scope.space().spaces[name] = &made;
    return made;
  }

  void insert(const XmlElement& element, XacroScope& scope) {
    const std::string name = text(element, "name", scope);
    const XacroBlock* block = scope.block(name);
    if (!block) element.fail("no block of this name", name);
    at(element, [&] {
      const Deeper deeper(run_);
      inside(block->elements, *block->scope);
    });
  }

  void call(const std::string& name, const XmlElement& element, XacroScope& scope) {
    const auto [found, owner] = scope.macro(name);
    if (!found) element.fail("no macro of this name", name);
    // A copy: the macro may define itself anew.
    const XacroMacro macro = *found;
    XacroScope& around = owner ? *owner : scope;
    XacroScope own(run_, around.space(), &around);
    at(element, [&] { hand_over(macro, element, scope, own); });
    at(element, [&] {
      const Deeper deeper(run_);
      inside(macro.element.children(), own);
    });
  }

  // Gives the parameters of a macro their values.
  void hand_over(const XacroMacro& macro, const XmlElement& element, XacroScope& scope,
                 XacroScope& own) {
    const std::vector<XmlElement> children = element.children();
    std::size_t next = 0;
    for (const XacroParameter& parameter : macro.parameters) {
      if (parameter.stars > 0) {
        if (next == children.size())
          throw InputError({"", "", "a block is missing", parameter.name});
        const XmlElement& block = children[next++];
        own.set_block(parameter.name,
                      {parameter.stars == 1 ? std::vector{block} : block.children(), &scope});
      } else if (element.has(parameter.name)) {
        own.set(parameter.name, {.value = xacro_value(element.raw(parameter.name), scope)});
      } else if (parameter.is_forwarded && scope.knows(parameter.name)) {
        own.set(parameter.name, {.value = scope.property(parameter.name)});
      } else if (parameter.otherwise) {
        own.set(parameter.name, {.text = *parameter.otherwise});
      } else {
        throw InputError({"", "", "the parameter has no value", parameter.name});
      }
    }
    for (const std::string& name : element.attributes()) {
      const bool is_known =
          std::any_of(macro.parameters.begin(), macro.parameters.end(),
                      [&](const XacroParameter& p) { return p.stars == 0 && p.name == name; });
      if (!is_known && !(name == "macro" && element.name() == "xacro:call")) {
        throw InputError({"", "", "the macro has no parameter of this name", name});
      }
    }
  }

  const XmlFile& file_;
  const ForeignRobotOptions& options_;
  std::deque<XmlFile> files_;  // that are included
  XmlMaker maker_;
  XacroRun run_;
  XacroSpace space_;
  XacroScope outermost_;
  // Of files that are included with a namespace.
  std::deque<XacroSpace> spaces_;
  std::deque<XacroScope> scopes_;
};

bool has_xacro_inside(const XmlElement& element) {
  if (element.name().starts_with(kPrefix) || element.has("xmlns:xacro")) return true;
  const std::vector<XmlElement> children = element.children();
  return std::any_of(children.begin(), children.end(), has_xacro_inside);
}

}  // namespace

bool has_xacro(const XmlFile& file) { return has_xacro_inside(file.root()); }

XmlFile expanded_xacro(const XmlFile& file, const ForeignRobotOptions& options) {
  return XacroExpansion(file, options).expanded();
}

}  // namespace prehend

#include "sim/robot/files/xacro_expression.h"

#include <map>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/base/json/yaml_file.h"
#include "sim/robot/files/xacro_members.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

constexpr const char* kYaml = R"(
limits:
  shoulder: {lower: !degrees -180, upper: !degrees 180.0, effort: 150, has: true, note: "12"}
  7: [0.1, [2, 3]]
mesh: !millimeters 250
empty: ""
none:
)";

class Words : public XacroWords {
 public:
  XacroValue property(const std::string& name) override {
    if (name == "width") return {0.06};
    if (name == "count") return {3LL};
    if (name == "prefix") return {std::string("left_")};
    throw InputError({.problem = "no property of this name", .value = name});
  }
  std::string command(const std::string& words) override { return "<" + words + ">"; }
  std::optional<XacroValue> property_of(const std::string& space,
                                        const std::string& name) override {
    if (space != "other") return std::nullopt;
    return XacroValue{"other's " + name};
  }
  XacroValue load_yaml(const std::string& name) override {
    return xacro_value_of(parse_yaml(name, kYaml).root());
  }
};

std::string text(const std::string& asked) {
  Words words;
  return xacro_text(asked, words);
}

std::string complaint(const std::string& asked) {
  return test::refusal_of([&] { (void)text(asked); }).what();
}

// What Python 3.11 prints for each.
TEST(XacroExpression, IsWhatPythonSays) {
  const std::map<std::string, std::string> expected = {
      {"1 + 2 * 3", "7"},
      {"(1 + 2) * 3", "9"},
      {"7 / 2", "3.5"},
      {"6 / 2", "3.0"},
      {"-7 // 2", "-4"},
      {"-7 % 3", "2"},
      {"2 ** 3 ** 2", "512"},
      {"-2 ** 2", "-4"},
      {"2 ** -1", "0.5"},
      {"count - 1 + 0.5", "2.5"},
      {"'a' + 'b'", "ab"},
      {"prefix == 'left_'", "True"},
      {"not prefix", "False"},
      {"1 if prefix == 'right_' else -1", "-1"},
      {"count if count > 2 else no_such_name", "3"},
      {"count < 2 and no_such_name", "False"},
      {"count > 2 or no_such_name", "True"},
      {"'x' in ['x', 'y']", "True"},
      {"2 not in [1, 2]", "False"},
      {"[10, 20, 30][-1]", "30"},
      {"(4, 5)[0]", "4"},
      {"prefix[0]", "l"},
      {"max(1, count, 2)", "3"},
      {"min([4, 2])", "2"},
      {"abs(-2)", "2"},
      {"round(2.5)", "2"},
      {"round(0.0625, 2)", "0.06"},
      {"int(2.9)", "2"},
      {"int('12') + 1", "13"},
      {"float(1)", "1.0"},
      {"str(1) + '2'", "12"},
      {"len(prefix)", "5"},
      {"math.floor(-0.5)", "-1"},
      {"radians(180) == pi", "True"},
      {"atan2(0, -1) == pi", "True"},
      {"cos(0)", "1.0"},
      {"True", "True"},
      {"1e3", "1000.0"},
      {".5", "0.5"},
      {"- - 1", "1"},
      {"not not 5", "True"},
  };
  for (const auto& [asked, answer] : expected) {
    EXPECT_EQ(text("${" + asked + "}"), answer) << asked;
  }
}

// As Python with PyYAML and the units of xacro.
TEST(XacroExpression, ReadsFilesOfData) {
  const std::map<std::string, std::string> expected = {
      {"load_yaml('a')['limits']['shoulder']['effort'] + 1", "151"},
      {"xacro.load_yaml('a').limits.shoulder.effort", "150"},
      {"load_yaml('a').limits['shoulder'].lower == -pi", "True"},
      {"load_yaml('a').mesh", "0.25"},
      {"load_yaml('a').limits.shoulder.note + '3'", "123"},
      {"load_yaml('a').limits[7][1][0]", "2"},
      {"len(load_yaml('a'))", "4"},
      {"'limits' in load_yaml('a') and 'other' not in load_yaml('a')", "True"},
      {"load_yaml('a').limits.get('elbow', 5)", "5"},
      {"load_yaml('a').get('elbow')", "None"},
      {"load_yaml('a').none == None", "True"},
      {"load_yaml('a').empty == ''", "True"},
      {"load_yaml('a').keys()[1]", "limits"},
      {"1 if load_yaml('a').limits.shoulder.has else 2", "1"},
      {"load_yaml('a').limits[7]", "[0.1, [2, 3]]"},
      {"other.width", "other's width"},
      {"prefix.upper() + ' Left '.strip().lower()", "LEFT_left"},
      {"prefix.replace('left', 'right').split('_')[0]", "right"},
      {"prefix.startswith('left') and prefix.endswith('_')", "True"},
  };
  for (const auto& [asked, value] : expected) EXPECT_EQ(text("${" + asked + "}"), value) << asked;
}

TEST(XacroExpression, StandsInText) {
  EXPECT_EQ(text("${prefix}finger_${count}"), "left_finger_3");
  EXPECT_EQ(text("${width / 2} 0 ${-width / 2}"), "0.03 0 -0.03");
  EXPECT_EQ(text("$(find pkg)/a ${'}'}"), "<find pkg>/a }");
  EXPECT_EQ(text("$(arg ${prefix}x)"), "<arg left_x>");
  EXPECT_EQ(text("$(eval 1 + 1)"), "2");
  EXPECT_EQ(text("$${count} costs 5$"), "${count} costs 5$");
}

TEST(XacroExpression, ValuesKeepTheirTypes) {
  Words words;
  EXPECT_EQ(std::get<long long>(xacro_value("${count}", words).value), 3);
  EXPECT_EQ(std::get<double>(xacro_value("0.5", words).value), 0.5);
  EXPECT_EQ(std::get<bool>(xacro_value("true", words).value), true);
  EXPECT_EQ(std::get<std::string>(xacro_value("1 2", words).value), "1 2");
  EXPECT_EQ(std::get<std::string>(xacro_value("'1'", words).value), "1");
  EXPECT_TRUE(holds(xacro_value("${count == 3}", words)));
  EXPECT_FALSE(holds(xacro_value("0", words)));
  EXPECT_THROW((void)holds(xacro_value("maybe", words)), InputError);
}

TEST(XacroExpression, MistakesAreNamed) {
  const std::map<std::string, std::string> expected = {
      {"${nothing}", "no property of this name (nothing)"},
      {"${1 / 0}", "division by 0"},
      {"${1 +}", "ends too early"},
      {"${1 2}", "no expression"},
      {"${(1}", "lacks a )"},
      {"${1", "a bracket is not closed"},
      {"${'a}", "a bracket is not closed"},
      {"${1 < 2 < 3}", "compares several at once"},
      {"${'a' * 'b'}", "* needs a number (a)"},
      {"${sqrt(-1)}", "no finite number"},
      {"${10 ** 400}", "no finite number"},
      {"${open('a')}", "expand the file with xacro first"},
      {"${load_yaml('a')['limit']}",
       "there is no such part; there are empty, limits, mesh, none (limit)"},
      {"${load_yaml('a').limits.shoulder.left}", "no such part; there are effort, has, lower"},
      {"${prefix.left}", "only what a YAML file holds has parts with names (left)"},
      {"${prefix.format(1)}", "texts have no such method here (format)"},
      {"${load_yaml('a').items()}", "maps have no such method here (items)"},
      {"${count.lower()}", "only maps and texts have methods here (lower)"},
      {"${count.}", "lacks a name"},
      {"${[load_yaml('a')]}", "lists of lists"},
      {"${[1][3]}", "no element of this number (3)"},
      {"${atan2(1)}", "wrong number of arguments (atan2)"},
      {"${[[1]]}", "lists of lists"},
      {"${" + std::string(200, '(') + "}", "nested deeper than 50"},
      {"${" + std::string(200, '-') + "1}", "nested deeper than 50"},
      {"${" + std::string(3000, '1') + "}", "longer than 2,000"},
  };
  for (const auto& [asked, words] : expected) {
    EXPECT_NE(complaint(asked).find(words), std::string::npos) << asked << ": " << complaint(asked);
  }
}

}  // namespace
}  // namespace prehend

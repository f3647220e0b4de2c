#include "planner/show/exports/yaml_text.h"

#include <cassert>

#include "sim/base/number_text.h"

namespace prehend {

void put_text(YAML::Emitter& yaml, const std::string& text) { yaml << YAML::DoubleQuoted << text; }

// As plain text, not through the emitter's own conversion of doubles: number_text writes numbers
// that readers of YAML 1.1 take for numbers.
void put_number(YAML::Emitter& yaml, double value) { yaml << number_text(value); }

void put_numbers(YAML::Emitter& yaml, const std::vector<double>& values) {
  yaml << YAML::Flow << YAML::BeginSeq;
  for (const double value : values) put_number(yaml, value);
  yaml << YAML::EndSeq;
}

void put_texts(YAML::Emitter& yaml, const std::vector<std::string>& texts) {
  yaml << YAML::Flow << YAML::BeginSeq;
  for (const std::string& text : texts) put_text(yaml, text);
  yaml << YAML::EndSeq;
}

void put_vector(YAML::Emitter& yaml, const Vector3& v) {
  yaml << YAML::Flow << YAML::BeginMap;
  yaml << YAML::Key << "x" << YAML::Value;
  put_number(yaml, v.x());
  yaml << YAML::Key << "y" << YAML::Value;
  put_number(yaml, v.y());
  yaml << YAML::Key << "z" << YAML::Value;
  put_number(yaml, v.z());
  yaml << YAML::EndMap;
}

void put_comment(YAML::Emitter& yaml, const std::string& text) {
  yaml << YAML::Comment(text) << YAML::Newline;
}

std::string yaml_text(const YAML::Emitter& yaml) {
  assert(yaml.good());
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace prehend

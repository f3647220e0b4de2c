// Pieces of the exported YAML files (the only place, with the formats, that knows yaml-cpp).
#pragma once

#include <string>
#include <vector>
#include <yaml-cpp/emitter.h>

#include "sim/base/pose.h"

namespace prehend {

// A string, always in double quotes: without them "no", "1.0" and "~" would be read as a boolean, a
// number and null.
void put_text(YAML::Emitter& yaml, const std::string& text);

// A number as number_text writes it. Throws InputError for what is not finite.
void put_number(YAML::Emitter& yaml, double value);

// [a, b, c] on one line.
void put_numbers(YAML::Emitter& yaml, const std::vector<double>& values);
void put_texts(YAML::Emitter& yaml, const std::vector<std::string>& texts);

// {x: , y: , z: } on one line.
void put_vector(YAML::Emitter& yaml, const Vector3& v);

// Lines of text that readers skip.
void put_comment(YAML::Emitter& yaml, const std::string& text);

// The finished text, with a line end. Pieces in a wrong order are a bug, which is asserted.
std::string yaml_text(const YAML::Emitter& yaml);

}  // namespace prehend

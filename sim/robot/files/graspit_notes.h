// Notes (Robot::notes) of the readers of GraspIt! files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/xml/xml_file.h"

namespace prehend {

// "palm.xml: line 3, <material>: TEXT".
std::string note_of(const XmlElement& element, const std::string& text);

// A word of the file in quotes, at most 40 characters on one line.
std::string in_note(const std::string& word);

// A note for each element directly inside that is not among `known`: it is left out.
void note_unknown(const XmlElement& parent, std::span<const std::string_view> known,
                  std::vector<std::string>& notes);

}  // namespace prehend

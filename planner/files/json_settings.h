// "settings" of a grasp file: all options that the result depends on, besides the scene.
#pragma once

#include "planner/files/grasps_file.h"
#include "sim/json/json_field.h"

namespace prehend {

nlohmann::ordered_json settings_to_json(const RunRecord& record);

// Seed and options of the record; those that the file leaves out stay as they are. Throws
// InputError that names the file and the field.
void read_settings(const JsonField& field, RunRecord& record);

}  // namespace prehend

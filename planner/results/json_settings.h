// "settings" of a grasp file: all options that the result depends on, besides the scene.
#pragma once

#include <string>
#include <vector>

#include "planner/plan/accuracy.h"
#include "planner/results/grasps_file.h"
#include "sim/base/json/json_field.h"

namespace prehend {

nlohmann::ordered_json settings_to_json(const RunRecord& record);

// The options of an accuracy: one of the names of kAll<Accuracy>, or a file with an object of
// settings under the names that grasps.json has for them. In the file "accuracy" names the one that
// it changes, standard where it is left out; "paths" holds the settings of paths. Throws InputError
// that names the file and the field, also for a seed, the number of grasps to return ("top") and a
// model ("learned"), which are no matter of accuracy. `notes`: one for each setting of an earlier
// version in the file that has no effect any more.
PlanOptions read_accuracy(const std::string& name_or_file,
                          std::vector<std::string>* notes = nullptr);

// Seed and options of the record; those that the file leaves out stay as they are. Throws
// InputError that names the file and the field.
void read_settings(const JsonField& field, RunRecord& record);

}  // namespace prehend

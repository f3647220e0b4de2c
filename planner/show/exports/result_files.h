// The files that belong together in the folder of a result, by their names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.h"

namespace prehend {

// Whether `plan` or `evaluate` may write a file of this name: grasps.json, timings.json,
// report.html, any.json, best.png, best_arm.png and all exports.
bool is_result_file(std::string_view name);

// Whether `render` may write a file of this name.
bool is_rendered_file(std::string_view name);

// Whether `simulate` may write a file of this name.
bool is_simulation_file(std::string_view name);

// Removes from `folder` what earlier runs of plan, evaluate and render left there and what is not
// among `written`: pictures and exports of other grasps must not stand beside a new grasps.json.
// All other files stay, and so does everything that is no regular file, such as links, the mesh
// files of `scene` and `input`, a file that the run read (empty: none). Errors are ignored.
void remove_earlier_results(const std::filesystem::path& folder,
                            const std::vector<std::string>& written, const Scene& scene,
                            const std::filesystem::path& input = {});

}  // namespace prehend

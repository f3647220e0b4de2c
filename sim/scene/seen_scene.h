// Scenes of what depth cameras saw: one of the things is the object, the others and what they stand
// on are obstacles.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/scene.h"
#include "sim/shape/cloud/files/views_file.h"
#include "sim/shape/cloud/reconstruct.h"

namespace prehend {

// What was seen, as bodies. The things are called object1, object2, ... in their order.
struct SeenThings {
  Reconstruction bodies;
  ViewsSource source = {};  // no path: made by a program
  std::shared_ptr<const UnseenSpace> unseen = {};
};

// Reads and reconstructs (load_views, reconstruct). Throws InputError that names the file.
SeenThings load_seen_things(const std::filesystem::path& file, const std::string& unit,
                            const RunContext& context = {});
SeenThings seen_things(const ViewsInput& input, const RunContext& context = {});

std::vector<std::string> seen_names(const SeenThings& things);

// The place of the thing of this name, or of this number from 1; of none: 0, which has the most
// readings. Throws InputError that lists the names.
std::size_t seen_thing(const SeenThings& things, const std::string& asked);

// Makes thing `at` the scene's object, of this mass [kg], its frame O in the middle of its bounds
// with the axes of the world. Adds obstacles: the other things and "support", a slab below the
// plane that reaches 0.5 m beyond what was seen of it, and low enough for 0.2 mm between it and the
// object. A thing that the object's completed shape would overlap is taken as its thin shape, else
// as what was seen of it alone, else left out. Adds notes of all that was assumed.
void place_seen(const SeenThings& things, std::size_t at, Material material, double mass,
                Scene& scene);

}  // namespace prehend

// Files of simulations: simulation.json and tables of quantities over time.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace prehend {

struct Simulation;
struct World;

// What happened and all recorded states (docs/reference/simulation.md). The same simulation gives
// the same bytes.
void write_simulation(std::ostream& stream, const std::string& scene, const Simulation& simulation);

// A line of names, then a line for each frame, separated by commas. `names`: which quantities, in
// this order (quantity_names); empty: all. Throws InputError for a name that there is not.
void write_quantities(std::ostream& stream, const Simulation& simulation,
                      const std::vector<std::string>& names);

// Throws InputError for the first name that the world does not have, with those like it.
void require_quantities(const World& world, const std::vector<std::string>& names);

}  // namespace prehend

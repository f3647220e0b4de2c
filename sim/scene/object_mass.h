// How the mass of an object to grasp is spread, and where that is a guess.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/scene/scene.h"

namespace prehend {

// A phrase for reports, such as "uniform density".
std::string_view mass_basis_text(MassBasis basis);

// States the centre of mass, frame O [m]. The inertia about it stays as it is: that of uniform
// density, as long as nothing else is known of how the mass is spread.
void state_center_of_mass(GraspableBody& object, const Vector3& center_O);

// Sets mass, centre of mass and inertia to what follows from `stated` (mass_of_parts, which throws
// InputError). Without parts the density is uniform; mass or density is then needed.
void state_mass(GraspableBody& object, const StatedMass& stated);

// An object that is so long that its centre of mass may be far from that of uniform density.
struct LongObject {
  Vector3 axis_O = Vector3::UnitX();  // unit, along its length; the sign has no meaning
  double length = 0.0;                // from end to end along it [m]
};

// The object if its density was taken as uniform although it is long: the extent of its mass along
// one principal axis is more than kLongObject times that along the next. The extent is the edge of
// the box with the same moments of inertia.
std::optional<LongObject> long_object_of_uniform_mass(const GraspableBody& object);

// A hammer or a screwdriver has 5. What is filled evenly from end to end has less: a wine
// glass 2.9, a drinks bottle 3.2, a can of crisps 3.9. So have things that are heavy at one end but
// not long, a drill or a pan: shape alone does not tell them from a box.
inline constexpr double kLongObject = 4.0;

// Adds a note to the scene where its object is such, and takes away the one that an earlier call
// has added where it no longer is.
void note_uniform_mass(Scene& scene);

}  // namespace prehend

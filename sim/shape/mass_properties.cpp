#include "sim/shape/mass_properties.h"

#include "sim/shape/mass_solid.h"

namespace prehend {

MassProperties mass_properties(const TriangleMesh& mesh) {
  const MassSolid solid = mass_solid(mesh);
  const double size = solid.size;
  MassProperties mass{solid.source, 0.0, solid.from_unit(solid.moments.center()),
                      solid.moments.unit_inertia()};
  if (solid.is_solid()) mass.volume = solid.moments.zeroth * (size * size * size);
  mass.unit_inertia *= size * size;
  return mass;
}

}  // namespace prehend

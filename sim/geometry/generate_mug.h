// A coffee mug with a handle as one closed surface (genus 1).
#pragma once

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Body: a cup of 104 mm outer diameter, the "maximum diameter" of the mug in Miller and Allen,
// GraspIt! A versatile simulator for robotic grasping, IEEE RAM 11(4), 2004; 105 mm high, wall
// 4.5 mm, open at the top. Handle: a bow of 14 mm by 9 mm section on the +x side, reaching 33 mm
// beyond the body like that mug's. Stands on z = 0, body axis on z. Edges about `edge` long [m].
TriangleMesh generate_mug(double edge);

}  // namespace prehend

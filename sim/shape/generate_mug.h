// A coffee mug with a handle as one closed surface (genus 1).
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A mug that stands on the plane z = 0 with its axis on the z axis. Body: a cup with an outer
// diameter of 104 mm, the "maximum diameter" of the mug in Miller and Allen, GraspIt! A versatile
// simulator for robotic grasping, IEEE RAM 11(4), 2004; height 105 mm, wall 4.5 mm, open at the
// top. Handle: a bow with a cross section of 14 mm by 9 mm on the +x side; like that of the mug in
// the paper it reaches 33 mm beyond the body. `edge`: wanted length of the edges of the mesh [m],
// reduced to 18 mm if it is larger.
TriangleMesh generate_mug(double edge);

}  // namespace prehend

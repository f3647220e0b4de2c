// Reads MJCF, the format of the simulator MuJoCo (docs/reference/urdf-files.md).
#pragma once

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/joint_tree.h"

namespace prehend {

// The bodies and joints of a file whose outermost element is <mujoco>, as far as planning needs
// them: hinge and slide joints, geoms, inertia, linear couplings of joints, pairs of bodies that
// are excluded from contact, the keyframe "home". The base is the one body of the world that has no
// joint or a free one; with several bodies, the world, unless the one with joints below it is
// free. What is not carried is in the notes. Throws
// InputError "FILE: line 12, <joint>: problem (VALUE)": ball joints, slide joints without a range,
// missing meshes, elements that make others (include, replicate, composite).
// Source: https://mujoco.readthedocs.io/en/stable/XMLreference.html
JointTree read_mjcf(const XmlFile& file);

}  // namespace prehend

// The grasps that benchmarks and tests share, by the names that the tests use.
#pragma once

#include "benchmarks/grasp_families.h"

namespace prehend::test {

using bench::append;
using bench::Contacts;
using bench::cube_grasp;
using bench::cylinder_grasp;
using bench::doubled;
using bench::grasp_families;
using bench::jaw_grasp;
using bench::loose_grasp;
using bench::NamedGrasp;
using bench::octahedron_grasp;
using bench::on_sphere;
using bench::patch;
using bench::patches_grasp;
using bench::Random;
using bench::random_grasp;
using bench::ring_grasp;
using bench::rotated;

}  // namespace prehend::test

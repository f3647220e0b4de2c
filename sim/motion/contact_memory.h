// Contacts between the bodies and links of a world, kept from step to step while nothing has moved
// far enough to change them.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/shape/contact/surface_contact.h"

namespace prehend {

// A body of a world (robot -1), or a link of one of its robots.
struct SolidId {
  int robot = -1;
  int index = 0;
  friend bool operator==(const SolidId&, const SolidId&) = default;
  friend auto operator<=>(const SolidId&, const SolidId&) = default;
};

// A contact fixed to both of its solids, so that its gap follows their motion: the point on each,
// and the normal in the frame of the first.
struct HeldContact {
  Vector3 p_A = Vector3::Zero();
  Vector3 p_B = Vector3::Zero();
  Vector3 normal_A = Vector3::UnitZ();                // unit, from b into a
  Eigen::Vector4d impulse = Eigen::Vector4d::Zero();  // of the last step, over its time [N]
  bool slides =
      false;  // in the last step; else it sticks where p_A and p_B were opposite each other
};

// How far two contacts of a pair are from being the same: in place, and in normal times `arm` [m].
double difference(const HeldContact& a, const HeldContact& b, double arm);

// Sticks, or slides, from where the solids are now: p_B becomes the point of b opposite to p_A.
void stick_here(const Pose& X_AB, HeldContact& contact);

// What is known of a pair of solids since it was last looked at.
struct PairMemory {
  SolidId a = {};
  SolidId b = {};
  Pose X_AB = Pose::Identity();  // when it was looked at
  double at_least = 0.0;  // the gap was at least this [m]; where contacts are held, of all others
  std::vector<HeldContact> contacts = {};
  double gap = 0.0;  // where contacts are held: that of the surfaces was at least this [m]
  // The surfaces cross by a little: contacts cannot be found, and those held push them apart.
  bool crosses = false;
  // WarmStart::stiffness of the last step.
  double stiffness = std::numeric_limits<double>::infinity();
};

// In ascending order of the pairs.
struct ContactMemory {
  std::vector<PairMemory> pairs;
};

struct ContactSearchOptions {
  // Surfaces closer than this are in contact; where they approach each other, those that may meet
  // within the step as well [m].
  double range = 2e-4;
  // Contacts are searched again after points moved against each other by this [m].
  double refresh = 1e-4;
  // Most contacts of a pair (>= 4): the nearest, and those that it meets first when it tilts.
  int most = 8;
  // Contacts that differ by less than this count once: in place, and in normal times `arm` [m].
  double apart = 1e-3;
  double arm = 0.02;
};

// The contacts of two meshes that are within `range`, as ContactSearchOptions says; `memory` gets
// them. X_AB: pose of b's frame in a's. Impulses are taken over from those held before at the same
// places.
void search_contacts(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB, double range,
                     const ContactSearchOptions& options, ContactWorkspace& workspace,
                     PairMemory& memory);

// A contact at the nearest points of a pair of triangles (of find_gap) that do not meet: for
// surfaces whose contacts are none that search_contacts finds.
HeldContact nearest_contact(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB,
                            const TrianglePair& pair);

// A contact for surfaces that cross: in the middle of the triangles that meet, along the mean of
// their normals. Nothing where these cancel each other.
std::optional<HeldContact> crossing_contact(const ProximityMesh& a, const ProximityMesh& b,
                                            const Pose& X_AB);

}  // namespace prehend

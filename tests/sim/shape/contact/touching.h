// Two bodies placed against each other, seen from any frame.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/contact/contact_region.h"
#include "tests/support/brute_force.h"

namespace prehend::test {

// An object and a link in one world frame; contacts come back in that frame.
class Touching {
 public:
  // The bodies' own frames are X_WO and X_WL: results must not depend on them.
  Touching(const TriangleMesh& object_W, const TriangleMesh& link_W, const Pose& X_WO,
           const Pose& X_WL)
      : X_WO_(X_WO),
        X_OL_(X_WO.inverse() * X_WL),
        object_(transformed(object_W, X_WO.inverse())),
        link_(transformed(link_W, X_WL.inverse())) {}

  std::vector<SurfaceContact> points(const ContactOptions& options = {}) const {
    std::vector<SurfaceContact> found;
    ContactWorkspace workspace;
    find_contact_points(object_, link_, X_OL_, options, workspace, found);
    return in_world(std::move(found));
  }

  std::vector<SurfaceContact> regions(const ContactOptions& options = {}) const {
    std::vector<SurfaceContact> found;
    RegionWorkspace workspace;
    find_contacts(object_, link_, X_OL_, options, workspace, found);
    return in_world(std::move(found));
  }

 private:
  std::vector<SurfaceContact> in_world(std::vector<SurfaceContact> contacts) const {
    for (SurfaceContact& contact : contacts) {
      contact.position = X_WO_ * contact.position;
      contact.normal = X_WO_.linear() * contact.normal;
    }
    return contacts;
  }

  Pose X_WO_;
  Pose X_OL_;
  ProximityMesh object_;
  ProximityMesh link_;
};

// Frames within this of each other lose this much of a position [m].
inline constexpr double kFrameRounding = 1e-12;

// What holds for every contact: on the object, the stated gap away from the link and no more than
// the threshold, with a unit normal from the link into the object.
inline void expect_sound(const std::vector<SurfaceContact>& contacts, const TriangleMesh& object_W,
                         const TriangleMesh& link_W, const ContactOptions& options = {}) {
  const std::vector<Corners> object = soup(object_W);
  const std::vector<Corners> link = soup(link_W);
  for (const SurfaceContact& contact : contacts) {
    EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-9);
    EXPECT_GE(contact.gap, 0.0);
    EXPECT_LE(contact.gap, options.threshold + kFrameRounding);
    EXPECT_LT(point_to_surface(contact.position, object), kFrameRounding);
    const Vector3 on_link = contact.position - contact.gap * contact.normal;
    EXPECT_LT(point_to_surface(on_link, link), kFrameRounding);
    // Just off the contact, towards the link, is outside.
    EXPECT_EQ(winding(contact.position - 1e-5 * contact.normal, object), 0)
        << contact.position.transpose() << " normal " << contact.normal.transpose();
  }
}

inline std::string described(const std::vector<SurfaceContact>& contacts) {
  std::ostringstream text;
  text.precision(9);
  for (const SurfaceContact& contact : contacts) {
    text << "at " << contact.position.transpose() << " normal " << contact.normal.transpose()
         << " gap " << contact.gap << "\n";
  }
  return text.str();
}

// Each expected place is a contact with that normal, and there is no other contact.
inline void expect_places(const std::vector<SurfaceContact>& contacts,
                          const std::vector<Vector3>& places, const Vector3& normal,
                          double tolerance = 1e-9) {
  EXPECT_EQ(contacts.size(), places.size()) << described(contacts);
  for (const Vector3& place : places) {
    const bool found =
        std::any_of(contacts.begin(), contacts.end(), [&](const SurfaceContact& contact) {
          return (contact.position - place).norm() <= tolerance &&
                 (contact.normal - normal).norm() <= 1e-6;
        });
    EXPECT_TRUE(found) << "no contact at " << place.transpose() << " with normal "
                       << normal.transpose();
  }
}

// Calls check(X_WO, X_WL, gap) for random frames and gaps from 0.02 to 0.09 mm.
template <typename Check>
void each_frame(std::uint64_t seed, int count, const Check& check) {
  Random random(seed);
  check(Pose(Pose::Identity()), Pose(Pose::Identity()), 5e-5);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE("frame " + std::to_string(i));
    const Pose X_WO = random.pose(0.3);
    const Pose X_WL = random.pose(0.3);
    check(X_WO, X_WL, random.uniform(2e-5, 9e-5));
    if (testing::Test::HasFailure()) return;  // one reproduction is enough
  }
}

}  // namespace prehend::test

// The points and normals at which a link touches an object.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/shape/contact/contact_options.h"
#include "sim/shape/proximity.h"

namespace prehend {

// A point contact, in the object's frame O. `normal` is unit and points from the link into the
// object.
struct SurfaceContact {
  Vector3 position = Vector3::Zero();  // on the object's surface [m]
  Vector3 normal = Vector3::UnitZ();
  double gap = 0.0;             // between the surfaces along the normal [m]
  TrianglePair triangles = {};  // one of the pairs that touch there: of the object, of the link
};

// A contact of a list by its height along a fixed direction (contact_copies.h).
struct ContactHeight {
  double height = 0.0;      // [m]
  std::size_t contact = 0;  // index in the list
  bool kept = false;
};
struct ContactCopies {
  std::vector<ContactHeight> by_height;
  std::vector<std::size_t> place;  // of each contact of the list in by_height
};

// Points that have been tried as contacts: triangles that share a corner find it each, and the
// tests of a point take much longer than to look for it here.
class TriedPoints {
 public:
  void clear();
  // Whether it was not there yet.
  bool insert(const Vector3& position, const Vector3& normal, double gap);

 private:
  struct Point {
    std::array<std::int64_t, 7> key = {};
    std::uint64_t hash = 0;
  };
  int& place_of(const Point& point);  // where it is, or belongs
  void grow();

  std::vector<Point> points_;
  std::vector<int> places_;  // a hash table with open addressing: index into points_, -1: none
};

// Buffers of find_contact_points, to allocate less; one for each thread.
struct ContactWorkspace {
  std::vector<ClosePair> pairs;
  std::vector<SurfaceContact> points;
  std::vector<int> walls;
  TriedPoints tried;
  ContactCopies copies;
};

// All point contacts between an object and a link that do not intersect, before they are reduced to
// regions; replaces `points`. Each pair of triangles within the threshold gives the points of its
// face contacts (one triangle projected on the other's plane and clipped to it, nearest points
// only), and the nearest points of the pair for edge and vertex contacts. A point is left out where
// the surface around it rises above the contact's tangent plane, since there is then a nearer
// contact beside it, and behind a wall that is thinner than the threshold. Points at the same place
// with the same normal are given once. Sorted by gap, nearest first. `X_OL` is the link's pose in
// O. Source: Miller and Allen 2004, "Contact Determination", figures 6 and 7.
void find_contact_points(const ProximityMesh& object, const ProximityMesh& link, const Pose& X_OL,
                         const ContactOptions& options, ContactWorkspace& workspace,
                         std::vector<SurfaceContact>& points);

}  // namespace prehend

// Copies of contacts are left out, and only those.
#include "sim/shape/contact/contact_copies.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

// By comparing each contact with all that are kept.
std::vector<SurfaceContact> kept_of_all(const std::vector<SurfaceContact>& contacts,
                                        const ContactOptions& options) {
  std::vector<SurfaceContact> kept;
  for (const SurfaceContact& c : contacts) {
    const bool copy = std::any_of(kept.begin(), kept.end(), [&](const SurfaceContact& k) {
      return (k.position - c.position).norm() <= kSamePlace * options.threshold &&
             k.normal.dot(c.normal) > 0.0 &&
             k.normal.cross(c.normal).norm() <= 2.0 * options.angular_tolerance;
    });
    if (!copy) kept.push_back(c);
  }
  return kept;
}

// Contacts around a few places, some just within and some just beyond what counts as the same.
std::vector<SurfaceContact> crowded(Random& random, const ContactOptions& options) {
  std::vector<Vector3> places;
  for (int i = 0; i < 6; ++i) places.push_back(random.in_box(0.05));
  // Places in a row along an axis, and one at the same height along the oblique one of the search.
  for (int i = 0; i < 4; ++i) places.push_back(places[0] + Vector3(0.0, 0.0, 1e-3 * i));
  places.push_back(places[0] + 1e-2 * Vector3(0.6178, 0.4973, 0.6091).cross(Vector3::UnitX()));
  std::vector<SurfaceContact> contacts;
  for (int i = 0; i < 150; ++i) {
    const auto place = static_cast<std::size_t>(random.integer(0, 10));
    const double off = random.uniform(0.0, 1.2 * kSamePlace * options.threshold);
    const Vector3 normal = (Vector3::UnitZ() + random.in_box(0.06)).normalized();
    contacts.push_back({places[place] + off * random.direction(),
                        random.integer(0, 4) == 0 ? Vector3(-normal) : normal, 1e-7 * i});
  }
  return contacts;
}

TEST(ContactCopies, AreTheSameAsByComparingAllWithAll) {
  Random random(31);
  const ContactOptions options;
  ContactCopies workspace;
  std::vector<SurfaceContact> firsts;
  for (int run = 0; run < 200; ++run) {
    const std::vector<SurfaceContact> contacts = crowded(random, options);
    const std::vector<SurfaceContact> expected = kept_of_all(contacts, options);
    first_copies(contacts, options, workspace, firsts);
    ASSERT_LT(firsts.size(), contacts.size());
    ASSERT_EQ(firsts.size(), expected.size());
    for (std::size_t i = 0; i < firsts.size(); ++i) {
      EXPECT_EQ(firsts[i].position, expected[i].position);
      EXPECT_EQ(firsts[i].normal, expected[i].normal);
      EXPECT_EQ(firsts[i].gap, expected[i].gap);
    }
  }
  first_copies({}, options, workspace, firsts);
  EXPECT_TRUE(firsts.empty());
}

}  // namespace
}  // namespace prehend

#include "planner/show/report/grasp_detail.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/results/contacts_file.h"
#include "planner/show/report/contacts_report.h"
#include "sim/quality/wrench_hull.h"
#include "sim/quality/wrench_space.h"
#include "tests/support/grasp_families.h"

namespace prehend {
namespace {

using test::Contacts;
using test::octahedron_grasp;
using test::on_sphere;
using test::random_grasp;
using test::ring_grasp;

const std::vector<std::string> kNoLinks;

GraspDetail detail_of(const Contacts& contacts, const std::vector<std::string>& links = kNoLinks) {
  return grasp_detail(contacts, links, {}, {}, 1, 50);
}

// By the full hull.
double hull_epsilon(const Contacts& contacts) {
  const WrenchHull hull = wrench_hull(contact_wrenches(contacts, {}));
  return hull.force_closure() ? hull.min_offset : 0.0;
}

Contacts without(Contacts contacts, std::size_t i) {
  contacts.erase(contacts.begin() + static_cast<std::ptrdiff_t>(i));
  return contacts;
}

TEST(GraspDetail, NoContactsHaveNone) {
  const GraspDetail detail = detail_of({});
  EXPECT_TRUE(detail.epsilon_without.empty() && detail.links.empty());
  EXPECT_EQ(detail.robust.force_closure, 0.0);
  const WrenchSections sections = space_sections({}, {}, {});
  EXPECT_TRUE(sections.forces.empty() && sections.torques.empty());
}

TEST(GraspDetail, OneContactHoldsNothing) {
  const GraspDetail detail = detail_of(ring_grasp(1, 0.5), {"finger"});
  EXPECT_EQ(detail.epsilon_without, std::vector<double>{0.0});
  ASSERT_EQ(detail.links.size(), 1U);
  EXPECT_EQ(detail.links[0].epsilon_without, 0.0);
  EXPECT_EQ(detail.robust.mean, 0.0);
  EXPECT_EQ(detail.robust.force_closure, 0.0);
}

// Two point contacts leave a torque about the line through them; of two soft fingers both are
// needed.
TEST(GraspDetail, WhatIsNeededIsNotDoneWithout) {
  const Contacts three = ring_grasp(3, 0.8);
  ASSERT_GT(grasp_epsilon(three, {}).lower, 0.05);
  EXPECT_EQ(detail_of(three).epsilon_without, std::vector<double>(3, 0.0));
  Contacts soft = ring_grasp(2, 0.5);
  for (Contact& contact : soft) {
    contact.model = ContactModel::soft_finger;
    contact.torsion = 0.5;
  }
  ASSERT_GT(grasp_epsilon(soft, {}).lower, 0.05);
  EXPECT_EQ(detail_of(soft).epsilon_without, std::vector<double>(2, 0.0));
}

TEST(GraspDetail, ContactsThatAreAlikeShareAlike) {
  const Contacts contacts = octahedron_grasp(0.7);
  const double whole = grasp_epsilon(contacts, {}).lower;
  const std::vector<double> found = detail_of(contacts).epsilon_without;
  ASSERT_EQ(found.size(), 6U);
  for (const double epsilon : found) {
    EXPECT_NEAR(epsilon, found.front(), 1e-9);
    EXPECT_LT(epsilon, whole - 1e-3);
  }
  EXPECT_NEAR(found.front(), hull_epsilon(without(contacts, 0)), 1e-9);
  EXPECT_GT(found.front(), 1e-3);
}

TEST(GraspDetail, EachContactIsLeftOutAsTheHullSays) {
  Random random(41);
  int hold_without = 0;
  for (int i = 0; i < 8; ++i) {
    const Contacts contacts = random_grasp(random, random.integer(3, 6), 0.7);
    const std::vector<double> found = detail_of(contacts).epsilon_without;
    ASSERT_EQ(found.size(), contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      EXPECT_NEAR(found[c], hull_epsilon(without(contacts, c)), 1e-8);
      hold_without += found[c] > 0.01 ? 1 : 0;
    }
  }
  EXPECT_GE(hold_without, 3);
}

TEST(GraspDetail, ADoubledContactIsNotMissed) {
  Contacts contacts = octahedron_grasp(0.5);
  contacts.push_back(contacts.front());
  const double whole = grasp_epsilon(contacts, {}).lower;
  const std::vector<double> found = detail_of(contacts).epsilon_without;
  EXPECT_NEAR(found.front(), whole, 1e-9);
  EXPECT_NEAR(found.back(), whole, 1e-9);
  EXPECT_LT(found[1], whole - 1e-3);
}

TEST(GraspDetail, LinksAreNamedOnceAndLeftOutWhole) {
  const Contacts contacts = octahedron_grasp(0.7);
  const GraspDetail detail = detail_of(contacts, {"b", "a", "b", "c", "b", "c"});
  ASSERT_EQ(detail.links.size(), 3U);
  EXPECT_EQ(detail.links[0].link, "b");
  EXPECT_EQ(detail.links[1].link, "a");
  EXPECT_EQ(detail.links[2].link, "c");
  EXPECT_NEAR(detail.links[0].epsilon_without,
              hull_epsilon({contacts[1], contacts[3], contacts[5]}), 1e-9);
  EXPECT_NEAR(detail.links[1].epsilon_without, detail.epsilon_without[1], 1e-12);
  EXPECT_NEAR(detail.links[2].epsilon_without,
              hull_epsilon({contacts[0], contacts[1], contacts[2], contacts[4]}), 1e-9);
  const GraspDetail alone = detail_of(contacts, std::vector<std::string>(6, "all"));
  ASSERT_EQ(alone.links.size(), 1U);
  EXPECT_EQ(alone.links[0].epsilon_without, 0.0);
}

TEST(GraspDetail, RobustnessIsOfTheSeed) {
  const Contacts contacts = octahedron_grasp(0.7);
  const auto robust = [&](std::uint64_t seed) {
    return grasp_detail(contacts, kNoLinks, {}, {}, seed, 50).robust;
  };
  EXPECT_EQ(robust(1).mean, robust(1).mean);
  EXPECT_NE(robust(1).mean, robust(2).mean);
  EXPECT_EQ(robust(1).force_closure, 1.0);
  EXPECT_LT(robust(1).percentile_5, robust(1).mean);
}

// The largest coordinate of the sections of an octahedron of contacts on the unit sphere. One
// normal force of 1 is all that a push along an axis can come from, if they add up to 1; two
// opposite contacts twist with their friction.
TEST(SpaceSections, OfAnOctahedronOfContacts) {
  const WrenchSections sections = space_sections(octahedron_grasp(0.5), {}, {});
  EXPECT_EQ(sections.forces.coordinates, (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(sections.torques.coordinates, (std::array<int, 3>{3, 4, 5}));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sections.forces.vertices.row(axis).maxCoeff(), 1.0, 1e-9);
    EXPECT_NEAR(sections.forces.vertices.row(axis).minCoeff(), -1.0, 1e-9);
    EXPECT_NEAR(sections.torques.vertices.row(axis).maxCoeff(), 0.5, 1e-9);
    EXPECT_NEAR(sections.torques.vertices.row(axis).minCoeff(), -0.5, 1e-9);
  }
}

// With every normal force up to 1, the friction of the four contacts beside helps to push.
TEST(SpaceSections, OfEachForceUpToOne) {
  WrenchSpaceOptions space;
  space.norm = WrenchNorm::linf;
  const WrenchSections pyramids = space_sections(octahedron_grasp(0.5), {}, space);
  space.cone = FrictionCone::exact;
  const WrenchSections cones = space_sections(octahedron_grasp(0.5), {}, space);
  for (const WrenchSections* sections : {&pyramids, &cones}) {
    ASSERT_FALSE(sections->forces.empty());
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(sections->forces.vertices.row(axis).maxCoeff(), 3.0 + 1e-9);
      EXPECT_GE(sections->forces.vertices.row(axis).maxCoeff(), 2.4);
    }
  }
}

TEST(SpaceSections, OfWhatSpansNothingAreEmpty) {
  for (const Contacts& contacts : {ring_grasp(2, 0.5), octahedron_grasp(0.0), Contacts{}}) {
    for (const FrictionCone cone : {FrictionCone::pyramid, FrictionCone::exact}) {
      WrenchSpaceOptions space;
      space.cone = cone;
      const WrenchSections sections = space_sections(contacts, {}, space);
      EXPECT_TRUE(sections.forces.empty() && sections.torques.empty());
    }
  }
}

// Torques so small beside the forces that the wrenches are flat have no sections, not joggled ones.
TEST(SpaceSections, TorquesInAVastScaleAreFlat) {
  WrenchFrame frame;
  for (const double scale : {1e-9, 1e9}) {
    frame.torque_scale = scale;
    // Levers of a few millimetres or of kilometres make torques of 1e-12 and 1e12.
    std::vector<Contact> contacts = octahedron_grasp(0.5);
    for (Contact& contact : contacts) contact.position *= scale < 1.0 ? 1e-3 : 1e3;
    const WrenchSections sections = space_sections(contacts, frame, {});
    EXPECT_TRUE(sections.forces.empty() && sections.torques.empty()) << scale;
  }
}

TEST(ContactsReport, SaysWhatWasJudged) {
  ContactsFile file;
  file.contacts = octahedron_grasp(0.5);
  JudgedContacts judged;
  judged.epsilon = grasp_epsilon(file.contacts, file.frame, judged.space);
  judged.volume = {1.0, 2.0};
  const Report report = contacts_report("name", file, judged, 3);
  EXPECT_EQ(report.title, "name");
  EXPECT_EQ(report.scene, nullptr);
  ASSERT_EQ(report.grasps.size(), 1U);
  const ReportGrasp& grasp = report.grasps.front();
  EXPECT_EQ(grasp.contacts.size(), 6U);
  EXPECT_TRUE(grasp.force_closure);
  EXPECT_FALSE(grasp.motion.has_value());
  ASSERT_TRUE(grasp.detail.has_value());
  EXPECT_EQ(grasp.detail->epsilon_without.size(), 6U);
  EXPECT_TRUE(grasp.detail->links.empty());
  EXPECT_FALSE(grasp.detail->sections.forces.empty());
  const Report none = contacts_report("none", {}, {}, 3);
  ASSERT_EQ(none.grasps.size(), 1U);
  EXPECT_FALSE(none.grasps.front().force_closure);
  EXPECT_TRUE(none.grasps.front().contacts.empty());
}

}  // namespace
}  // namespace prehend

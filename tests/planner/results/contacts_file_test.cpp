#include "planner/results/contacts_file.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

std::filesystem::path write(const std::string& text) {
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file = testing::TempDir() + "/contacts_" + name + ".json";
  std::ofstream(file) << text;
  return file;
}

TEST(ContactsFile, ReadsEverything) {
  const ContactsFile file = load_contacts(write(R"({
    "contacts": [{"position": [1, 2, 3], "normal": [0, 0, 1], "friction": 0.5},
                 {"position": [1, 2, 4], "normal": [0, 0, -1], "friction": 1,
                  "model": "soft_finger", "torsion": 0.004},
                 {"position": [1, 2, 4], "normal": [0, 0, -1], "model": "frictionless"}],
    "torque_origin": [0, 0, 1], "torque_scale": 10,
    "external": {"force": [1, 0, 0], "torque": [0, 2, 0]},
    "task": {"gravity": {"direction": [0, 0, -1], "weight": 3}},
    "hand": {"torque_limits": [1, 2], "jacobian": [[1, 0], [0, 1], [0, 0], [1, 0], [0, 1], [0, 0],
                                                   [1, 0], [0, 1], [0, 5]]}})"));
  ASSERT_EQ(file.contacts.size(), 3U);
  EXPECT_EQ(file.contacts[0].model, ContactModel::point);
  EXPECT_EQ(file.contacts[1].model, ContactModel::soft_finger);
  EXPECT_EQ(file.contacts[1].torsion, 0.004);
  EXPECT_EQ(file.contacts[2].model, ContactModel::frictionless);
  EXPECT_EQ(file.frame.torque_scale, 10.0);
  EXPECT_EQ((*file.external)[0], 1.0);
  EXPECT_EQ((*file.external)[4], 20.0);  // scaled
  EXPECT_EQ(std::get<TaskGravity>(*file.task).weight, 3.0);
  EXPECT_EQ(file.hand->jacobian(8, 1), 5.0);
}

struct WrittenMistake {
  const char* name;
  const char* text;
  const char* complaint;
};

class ContactsFileMistakes : public testing::TestWithParam<WrittenMistake> {};

TEST_P(ContactsFileMistakes, AreNamed) {
  const std::filesystem::path file = testing::TempDir() + "/mistake_" + GetParam().name + ".json";
  std::ofstream(file) << GetParam().text;
  try {
    (void)load_contacts(file);
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("mistake_"), std::string::npos) << what;
    EXPECT_NE(what.find(GetParam().complaint), std::string::npos) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Corpus, ContactsFileMistakes,
    testing::Values(
        WrittenMistake{"NoContacts", R"({"torque_scale": 1})", "contacts"},
        WrittenMistake{"Misspelt", R"({"contacts": [], "torque_scal": 1})", "torque_scal"},
        WrittenMistake{"Scale", R"({"contacts": [], "torque_scale": 0})", "torque_scale"},
        WrittenMistake{"ZeroNormal",
                       R"({"contacts": [{"position": [0,0,0], "normal": [0,0,0], "friction": 1}]})",
                       "contacts[0].normal: not unit (0, 0, 0)"},
        WrittenMistake{
            "NegativeFriction",
            R"({"contacts": [{"position": [0,0,0], "normal": [0,0,1], "friction": -1}]})",
            "contacts[0].friction: must be from 0 to 1e+06 (-1)"},
        WrittenMistake{
            "ContactField",
            R"({"contacts": [{"position": [0,0,0], "normal": [0,0,1], "friction": 1, "mu": 1}]})",
            "contacts[0].mu: unknown field"},
        WrittenMistake{"NoFriction", R"({"contacts": [{"position": [0,0,0], "normal": [0,0,1]}]})",
                       "needs friction"},
        WrittenMistake{"NoTorsion",
                       R"({"contacts": [{"position": [0,0,0], "normal": [0,0,1], "friction": 1,
                    "model": "soft_finger"}]})",
                       "contacts[0]: a soft_finger needs torsion"},
        WrittenMistake{"Model",
                       R"({"contacts": [{"position": [0,0,0], "normal": [0,0,1], "friction": 1,
                    "model": "sticky"}]})",
                       "contacts[0].model: must be one of frictionless, point, soft_finger, "
                       "suction (\"sticky\")"},
        WrittenMistake{"Jacobian",
                       R"({"contacts": [{"position": [0,0,0], "normal": [0,0,1], "friction": 1}],
                    "hand": {"torque_limits": [1], "jacobian": [[1], [2]]}})",
                       "needs 3 rows"}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

}  // namespace
}  // namespace prehend

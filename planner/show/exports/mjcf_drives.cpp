#include "planner/show/exports/mjcf_drives.h"

#include "sim/base/index.h"
#include "sim/base/number_text.h"

namespace prehend {
namespace {

// A joint that holds its value gives way by so much at its full effort.
constexpr double kHoldingSlide = 5e-4;  // m
constexpr double kHoldingTurn = 0.02;   // rad

}  // namespace

void write_couplings(XmlText& xml, const Robot& hand, const HandDrives& drives) {
  for (const HandCoupling& coupling : drives.couplings) {
    xml.element("joint", {{"joint1", hand.joints[index(coupling.joint)].name},
                          {"joint2", hand.joints[index(coupling.leader)].name},
                          {"polycoef", numbers_text({0.0, coupling.ratio, 0.0, 0.0, 0.0})}});
  }
}

void write_clutches(XmlText& xml, const Robot& hand, const HandDrives& drives,
                    const std::string& contact_time) {
  if (drives.clutches.empty()) return;
  xml.open("tendon");
  for (const HandClutch& clutch : drives.clutches) {
    const std::string& joint = hand.joints[index(clutch.follows.joint)].name;
    const std::string& leader = hand.joints[index(clutch.follows.leader)].name;
    xml.open("fixed", {{"name", joint + "/clutch"},
                       {"frictionloss", number_text(clutch.effort)},
                       {"solreffriction", contact_time}});
    xml.element("joint", {{"joint", joint}, {"coef", "1.0"}});
    xml.element("joint", {{"joint", leader}, {"coef", number_text(-clutch.follows.ratio)}});
    xml.close();
  }
  xml.close();
}

void write_actuators(XmlText& xml, const Robot& hand, const HandDrives& drives) {
  xml.open("actuator");
  for (const HandDrive& drive : drives.drives) {
    const Joint& joint = hand.joints[index(drive.joint)];
    const std::string range = numbers_text({-drive.effort, drive.effort});
    XmlAttributes attributes = {{"name", joint.name},
                                {"joint", joint.name},
                                {"forcelimited", "true"},
                                {"forcerange", range}};
    if (drive.closing != 0.0) {
      attributes.insert(attributes.end(), {{"ctrllimited", "true"}, {"ctrlrange", range}});
      xml.element("motor", attributes);
      continue;
    }
    const double yields = joint.type == JointType::prismatic ? kHoldingSlide : kHoldingTurn;
    attributes.emplace_back("kp", number_text(drive.effort / yields));
    xml.element("position", attributes);
  }
  xml.close();
}

}  // namespace prehend

// The drives of a hand and what couples its joints, in models of MuJoCo.
#pragma once

#include <string>

#include "planner/show/exports/hand_drives.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {

// Writes the elements <equality><joint> of the couplings, inside the open element <equality>: of
// the ways from the grasp on, which is what MuJoCo's are as well.
void write_couplings(XmlText& xml, const Robot& hand, const HandDrives& drives);

// Writes <tendon>, where there are clutches: dry friction between a joint and its place behind its
// leader. `contact_time`: the solref of friction.
void write_clutches(XmlText& xml, const Robot& hand, const HandDrives& drives,
                    const std::string& contact_time);

// Writes <actuator>.
void write_actuators(XmlText& xml, const Robot& hand, const HandDrives& drives);

}  // namespace prehend

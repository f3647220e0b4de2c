// Reader of files that state contacts directly, without a scene or a hand
// (docs/reference/contacts-file.md).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sim/quality/forces.h"
#include "sim/quality/task.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// What such a file says. Points are in metres, in one frame that all of the file shares.
struct ContactsFile {
  std::vector<Contact> contacts;  // n contacts: position [m], unit normal into the object, friction
  WrenchFrame frame;              // torque origin [m] and torque scale [1/m]; default: origin and 1
  std::optional<Task> task;       // wrenches to be resisted, for the measure task_resistance
  std::vector<Contact> surface;   // contacts all over the object, for object_wrench_ratio
  // Limits of the joint torques [Nm], and the Jacobian (3n x joints) and spin (n x joints) that map
  // contact forces to joint torques.
  std::optional<HandTorques> hand;
  std::optional<Wrench> external;  // wrench on the object that the contacts are to balance: force
                                   // [N], torque [Nm] times the torque scale
};

// Reads a file. Throws InputError that names the file, the field and the value when it cannot be
// read, has a field that is unknown, or a value that is not allowed.
ContactsFile load_contacts(const std::filesystem::path& file);
// As load_contacts, of a file that was parsed already.
ContactsFile read_contacts(const JsonFile& file);

}  // namespace prehend

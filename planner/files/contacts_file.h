// A file of contacts to be judged without a scene (docs/contacts-file.md).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sim/quality/forces.h"
#include "sim/quality/measures.h"

namespace prehend {

struct ContactsFile {
  std::vector<Contact> contacts;
  WrenchFrame frame;
  std::optional<Task> task;
  std::vector<Contact> surface;
  std::optional<HandTorques> hand;
  std::optional<Wrench> external;  // to be balanced, torque scaled
};

// Throws InputError that names the file, the field and the value.
ContactsFile load_contacts(const std::filesystem::path& file);

}  // namespace prehend

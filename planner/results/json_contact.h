// A contact in grasp files and in contacts files.
#pragma once

#include <optional>
#include <string>

#include "sim/base/json/json_fields.h"
#include "sim/quality/contact_map.h"

namespace prehend {

// "position", "normal", "friction", "model", "torsion", of suction cups "moment" and
// "vacuum" (docs/reference/contacts-file.md). Where
// they are read: throws InputError that names file and field for values that no contact has, see
// check_contact, and where friction or torsion are missing that the model needs.
void contact_fields(auto& fields, auto& contact) {
  for (const char* name : {"position", "normal"}) fields.needs(name);
  fields("position", contact.position);
  fields("normal", contact.normal);
  fields("friction", contact.friction);
  fields("model", contact.model);
  fields("torsion", contact.torsion);
  // Only of suction cups.
  std::optional<double> moment;
  std::optional<double> vacuum;
  if constexpr (!kReads<decltype(fields)>) {
    if (contact.model == ContactModel::suction) {
      moment = contact.moment;
      vacuum = contact.vacuum;
    }
  }
  fields("moment", moment);
  fields("vacuum", vacuum);
  if constexpr (kReads<decltype(fields)>) {
    contact.moment = moment.value_or(0.0);
    contact.vacuum = vacuum.value_or(0.0);
    const JsonField& field = fields.field();
    if (contact.model != ContactModel::frictionless && !field.has("friction")) {
      field.fail("needs friction");
    }
    if (contact.model == ContactModel::soft_finger && !field.has("torsion")) {
      field.fail("a soft_finger needs torsion");
    }
    for (const char* name : {"torsion", "moment", "vacuum"}) {
      if (contact.model != ContactModel::suction || field.has(name)) continue;
      field.fail(std::string("a suction cup needs ") + name);
    }
    try {
      check_contact(contact);
    } catch (const InputError& error) {
      field.fail(error);
    }
  }
}

}  // namespace prehend

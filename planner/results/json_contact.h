// A contact in grasp files and in contacts files.
#pragma once

#include "sim/base/json/json_fields.h"
#include "sim/quality/contact_map.h"

namespace prehend {

// "position", "normal", "friction", "model" and "torsion" (docs/reference/contacts-file.md). Where
// they are read: throws InputError that names file and field for values that no contact has, see
// check_contact, and where friction or torsion are missing that the model needs.
void contact_fields(auto& fields, auto& contact) {
  for (const char* name : {"position", "normal"}) fields.needs(name);
  fields("position", contact.position);
  fields("normal", contact.normal);
  fields("friction", contact.friction);
  fields("model", contact.model);
  fields("torsion", contact.torsion);
  if constexpr (kReads<decltype(fields)>) {
    const JsonField& field = fields.field();
    if (contact.model != ContactModel::frictionless && !field.has("friction")) {
      field.fail("needs friction");
    }
    if (contact.model == ContactModel::soft_finger && !field.has("torsion")) {
      field.fail("a soft_finger needs torsion");
    }
    try {
      check_contact(contact);
    } catch (const InputError& error) {
      field.fail(error);
    }
  }
}

}  // namespace prehend

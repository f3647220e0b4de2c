// Trials as sequences of bytes, to test that two trials are equal in every bit of every number, as
// for different numbers of threads.
#pragma once

#include <cstring>
#include <vector>

#include "sim/trial/trial.h"

namespace prehend::test {

// Appends `size` bytes at `data`.
inline void append_bytes(std::vector<unsigned char>& bytes, const void* data, std::size_t size) {
  const std::size_t at = bytes.size();
  bytes.resize(at + size);
  if (size > 0) std::memcpy(bytes.data() + at, data, size);
}

// All fields of the trial except its run times and those that only an arm sets.
inline std::vector<unsigned char> bytes_of(const Trial& trial) {
  std::vector<unsigned char> bytes;
  const int link = trial.blocked ? static_cast<int>(trial.blocked->link) : -1;
  const int body = trial.blocked ? static_cast<int>(index(trial.blocked->body)) : -1;
  for (const int value : {static_cast<int>(trial.outcome), link, body, trial.back_offs,
                          static_cast<int>(trial.epsilon.status)}) {
    append_bytes(bytes, &value, sizeof(value));
  }
  append_bytes(bytes, trial.X_OH.data(), 16 * sizeof(double));
  append_bytes(bytes, trial.overlap_shift.data(), 3 * sizeof(double));
  append_bytes(bytes, &trial.travel, sizeof(double));
  append_bytes(bytes, trial.pushed.data(), 3 * sizeof(double));
  append_bytes(bytes, &trial.turned, sizeof(double));
  append_bytes(bytes, &trial.slid, sizeof(double));
  append_bytes(bytes, trial.dofs.data(), trial.dofs.size() * sizeof(double));
  append_bytes(bytes, trial.joints.data(), trial.joints.size() * sizeof(double));
  for (const GraspContact& contact : trial.contacts) {
    append_bytes(bytes, &contact.link, sizeof(LinkId));
    append_bytes(bytes, contact.point.position.data(), 3 * sizeof(double));
    append_bytes(bytes, contact.point.normal.data(), 3 * sizeof(double));
    append_bytes(bytes, &contact.point.friction, sizeof(double));
    append_bytes(bytes, &contact.point.model, sizeof(ContactModel));
    append_bytes(bytes, &contact.point.torsion, sizeof(double));
    append_bytes(bytes, &contact.gap, sizeof(double));
  }
  append_bytes(bytes, &trial.epsilon.lower, sizeof(double));
  append_bytes(bytes, &trial.epsilon.upper, sizeof(double));
  append_bytes(bytes, trial.epsilon.weakest.data(), 6 * sizeof(double));
  return bytes;
}

}  // namespace prehend::test

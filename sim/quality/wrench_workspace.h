// contact_wrenches in memory that is used again and again.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/quality/wrench.h"

namespace prehend {

// Buffers of contact_wrenches, to allocate less; one for each thread.
struct WrenchWorkspace {
  std::vector<Wrench> columns;
  std::array<Eigen::Matrix3Xd, kAll<ContactModel>.size()> corners;  // unit_corners of each model
};

// The columns of wrench.h, in the workspace: valid until its next use.
Eigen::Map<const Wrenches> contact_wrenches(std::span<const Contact> contacts,
                                            const WrenchFrame& frame, int edges,
                                            WrenchWorkspace& workspace);

// As unit_corners of wrench.h; `corners` is resized where it has to be.
void unit_corners(ContactModel model, int edges, Eigen::Matrix3Xd& corners);

}  // namespace prehend

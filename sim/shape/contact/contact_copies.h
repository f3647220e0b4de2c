// Contacts that were found several times, by neighbouring pairs of triangles.
#pragma once

#include <vector>

#include "sim/shape/contact/surface_contact.h"

namespace prehend {

// Contacts with the same normal that are nearer to each other than this part of the threshold are
// one. Small, so that merging does not move the corners of a region noticeably.
inline constexpr double kSamePlace = 0.01;

// Copies to `firsts`, in order, the contacts that are no copies of one that is copied before them:
// nearer to it than kSamePlace of the threshold, with the same normal (up to twice the
// angular tolerance, since each of two normals may be off by that). `firsts` is replaced. Time
// about n log n.
void first_copies(const std::vector<SurfaceContact>& contacts, const ContactOptions& options,
                  ContactCopies& workspace, std::vector<SurfaceContact>& firsts);

}  // namespace prehend

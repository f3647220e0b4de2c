// How contacts are made of what gives way.
#pragma once

#include <array>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/base/settings.h"
#include "sim/soft/pad.h"

namespace prehend {

// What links that give way make contact by.
enum class ContactKind {
  hard,  // points with Coulomb friction
  soft,  // and a soft finger for each patch of an elastic foundation (soft_patch.h)
  fem,   // the patch of a pad of finite elements (sim/soft); links without a pad as in `soft`
};
constexpr auto enum_names(ContactKind /*of*/) {
  return std::to_array<std::string_view>({"hard", "soft", "fem"});
}

// What stands for the patch of a pad in the wrench space.
enum class PadPatchModel {
  // Soft fingers as small as an element, at the rim of the patch and where it bears most: the
  // pressure
  // may move within the patch.
  nodes,
  // One soft finger at the centre of pressure, with the fitted torsion.
  limit_surface,
};
constexpr auto enum_names(PadPatchModel /*of*/) {
  return std::to_array<std::string_view>({"nodes", "limit_surface"});
}

struct PadContactOptions {
  static constexpr AboutSettings kAbout{"PadContactOptions",
                                        "Contacts of pads made of finite elements."};
  PadPatchModel patch = PadPatchModel::nodes;
  double load = 10.0;
  PadOptions elements;
};

template <SettingsOf<PadContactOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [patch, load, elements] = options;
  visit("patch", patch,
        "What stands for the patch of a pad: points at its rim, or one soft finger.");
  visit("load", load, kEffortAbove0, "N", "With which a pad presses where joints state no effort.");
  visit("elements", elements, "How pads are divided.");
}

}  // namespace prehend

// What other grasp planners take for comparable work, measured elsewhere.
#pragma once

#include <span>

namespace prehend::bench {

struct PeerFigure {
  const char* peer;
  const char* what;
  const char* figure;
  const char* source;
  // The entry of ours that compares best (name_of); empty where none does.
  const char* ours;
};

std::span<const PeerFigure> peer_figures();

}  // namespace prehend::bench

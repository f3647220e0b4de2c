#include "sim/soft/pad_cache.h"

namespace prehend {

PadCache::PadCache(ProximityMesh link, PadShape shape)
    : link_(std::move(link)), shape_(std::move(shape)) {
  check_pad(link_, shape_, {});
}

std::shared_ptr<const Pad> PadCache::get(const PadOptions& options) const {
  const std::scoped_lock lock(mutex_);
  for (const auto& [made_with, pad] : made_) {
    if (made_with == options) return pad;
  }
  made_.emplace_back(options, std::make_shared<const Pad>(make_pad(link_, shape_, options)));
  return made_.back().second;
}

}  // namespace prehend

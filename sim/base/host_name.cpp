#include "sim/base/host_name.h"

#include <array>
#include <unistd.h>

namespace prehend {

std::string host_name() {
  std::array<char, 256> name{};
  // A longer name is cut without a zero at its end; the last byte stays one.
  if (::gethostname(name.data(), name.size() - 1) != 0) return {};
  return name.data();
}

}  // namespace prehend

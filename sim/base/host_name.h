// The name of this machine.
#pragma once

#include <string>

namespace prehend {

// As gethostname(2) gives it; empty where it fails.
std::string host_name();

}  // namespace prehend

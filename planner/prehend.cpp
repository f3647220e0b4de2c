#include "planner/prehend.h"

namespace prehend {

const char* version() { return PREHEND_VERSION; }

}  // namespace prehend

#include "planner/live/serve/few_heaps.h"

#include <malloc.h>

namespace prehend {

void use_few_heaps() { ::mallopt(M_ARENA_MAX, 2); }

}  // namespace prehend

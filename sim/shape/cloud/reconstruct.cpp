#include "sim/shape/cloud/reconstruct.h"

#include "sim/base/input_error.h"

namespace prehend {

Reconstruction reconstruct(const std::vector<DepthView>& /*views*/,
                           const ReconstructOptions& /*options*/, const RunContext& context) {
  context.cancellation.check();
  throw InputError({.field = "views", .problem = "there is no object in what was seen"});
}

}  // namespace prehend

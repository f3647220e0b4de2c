// Things cut out of views.
#pragma once

#include "sim/shape/cloud/object_view.h"
#include "sim/shape/cloud/prepare_views.h"

namespace prehend {

// The cutouts of a thing, of the views that show it, with its readings smoothed. Readings that have
// no surface around them are dropped where `drop_outliers`.
std::vector<ObjectView> cut_out(const PreparedViews& prepared, int cluster, bool drop_outliers,
                                const RunContext& context);

}  // namespace prehend

// A cloud of points as what cameras would have seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/shape/cloud/depth_view.h"
#include "sim/shape/cloud/files/point_cloud.h"

namespace prehend {

// What is said of a cloud beside its file.
struct CloudPlace {
  double metres_per_unit = 1.0;
  std::optional<Vector3> viewpoint = {};  // where the camera stood, frame F [m]
  Pose X_WF = Pose::Identity();           // of the cloud's frame
};

// Views of the points, each of which is in one of them or hidden by a nearer one.
//
// - Rows of an organised cloud that a pinhole camera explains (to 0.3 pixels) stay its image.
// - Else, from the viewpoint that is stated, or that of the file, or the origin, one image, or up
//   to six where the points lie all around.
// - Points with normals that no viewpoint is known of, or most of which face away from it, are seen
//   by several cameras around them, each by those that it faces.
//
// Made-up images have about one pixel for each one and a half points. Adds to `notes` what was
// assumed. Throws InputError: where fewer than 10 points are readings (finite, not at the
// viewpoint), one is beyond 1e6 m, or distances are not those of a camera (require_plausible).
std::vector<DepthView> views_of_cloud(const PointCloud& cloud, const CloudPlace& place,
                                      std::vector<std::string>& notes);

}  // namespace prehend

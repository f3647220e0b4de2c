// Checks of what is said to be seen by a depth camera.
#pragma once

#include <vector>

#include "sim/shape/cloud/depth_view.h"

namespace prehend {

// Throws InputError that names the field: for focal lengths that are not above 0, and an axis far
// outside the image.
void check_camera(const DepthCamera& camera);

// Throws InputError that asks for the unit where no reading [m] is within 50 m, or the middle one
// is beyond 20 m or nearer than 5 mm; and for fewer than 10 readings. The list is reordered.
void require_plausible(std::vector<float>& distances);

// The view with this image, as in DepthView. What is not finite or not above 0 is no reading.
// Throws InputError of these two checks, the first under "camera", and for another number of pixels
// than the camera has.
DepthView checked_view(const DepthCamera& camera, std::vector<float> depth);

}  // namespace prehend

// Convex hulls by quickhull, in the six dimensions of wrenches and in three.
#pragma once

#include "sim/quality/point_hull.h"
#include "sim/quality/start_simplex.h"

namespace prehend {

// The hull of the columns of `wrenches`, of which some are the corners of `start` (not flat).
// Several times faster than point_hull, which knows any dimension.
//
// The result is either solid, and proved as in proved_volume.h, or `failed`, which says nothing
// about the wrenches: point_hull is then to be asked. That happens where they are thinner than
// about 1e-6 of their size. Most facets in one plane have equal normals and offsets, bit by bit.
// A facet between near-duplicates, too thin to have a plane of its own, has some plane that leaves
// all columns on one side.
// Deterministic, but where more than six columns are in one plane, the facets there depend on the
// order of the columns.
//
// Source: Barber, Dobkin and Huhdanpaa, "The quickhull algorithm for convex hulls", 1996.
PointHull quickhull(const Wrenches& wrenches, const StartSimplex& start);

// The same of points in space. Points less than about 1e-11 of the largest coordinate above a facet
// count as inside. `solid` where the facets are closed and no corner is above any of them, else
// `failed`.
PointHull quickhull(const Eigen::Matrix3Xd& points);

}  // namespace prehend

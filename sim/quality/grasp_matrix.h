// The linear map from contact forces to the wrench on the object, and what its singular values say.
#pragma once

#include <span>

#include <Eigen/Core>

#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"

namespace prehend {

// 6 x k: the columns of each contact's map that its model transmits, 1 for a frictionless contact,
// 3 for a point, 4 for a soft finger, 6 for a suction cup. Source: Murray, Li and Sastry, "A
// Mathematical Introduction to Robotic Manipulation", 1994, section 5.2. Throws as check_contacts.
Eigen::MatrixXd grasp_matrix(std::span<const Contact> contacts, const WrenchFrame& frame);

// Smallest of the six singular values of a grasp matrix (0 with fewer than six columns): how far
// the grasp is from losing a direction. Source: Li and Sastry 1988.
double smallest_singular_value(const Eigen::MatrixXd& grasp_matrix);

// Smallest over largest singular value, 0 to 1. Source: Kim, Oh, Yi and Suh 2001.
double isotropy(const Eigen::MatrixXd& grasp_matrix);

// sqrt(det(J J')) of a hand's Jacobian (rows: velocities at the contacts, columns: joints), or of
// J' J where it has more rows than columns. Source: Yoshikawa 1985. Throws InputError for entries
// outside their range (ranges.h), and where no double is as large as the result.
double manipulability(const Eigen::MatrixXd& jacobian);

}  // namespace prehend

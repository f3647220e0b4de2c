// The impulses of one time step: rigid bodies and robots whose contacts must not move apart from
// Coulomb's law.
//
// Unknown are the velocities v at the end of the step and one impulse p a contact, with
//
//   M (v - v_free) = sum of J' p            (momentum)
//   p in K,   w + mu |w_t| n in K*,   p . (w + mu |w_t| n) = 0,   w = J v + offset
//
// K is the friction cone |p_t| <= mu p_n and K* its dual. This is Signorini's condition with
// Coulomb friction, written with one cone (de Saxce and Feng 1998): the contact opens without an
// impulse, or sticks with one inside the cone, or slides with one on its rim, against the motion.
// The offset along the normal is gap / h: what is left of the gap may close in the step.
#pragma once

#include <limits>
#include <vector>

#include <Eigen/Core>

#include "sim/motion/friction_cone.h"

namespace prehend {

// The part of a condition's Jacobian that belongs to some of the velocities: those from `first` on.
// It is kept as its transpose, whose columns are the rows of the condition: J' p and J' D J are
// then sums of columns. A row that the condition does not have is 0.
struct JacobianBlock {
  int first = 0;
  Eigen::Matrix<double, Eigen::Dynamic, 4> transposed;
};

// A condition on velocities, with the impulse that holds it up: of a contact, or of a joint.
//
// A contact has three or four rows: the relative velocity along the normal, then along two
// tangents, then the rate of spin about the normal times the radius that turns its moment into a
// force. Its impulse lies in the friction cone.
//
// A joint has one row, and the impulse lies in an interval: from 0 on for a limit, between -f and f
// for dry friction, a clutch or a drive that gives way at f. While it is inside, w = 0; with a
// compliance, w = -compliance * impulse, which is a spring with a damper, or a controller.
struct ContactCondition {
  std::vector<JacobianBlock> blocks;       // no velocity twice
  double friction = 0.0;                   // mu >= 0 of a contact
  int rows = 3;                            // 3 or 4 of a contact, 1 of a joint
  ConeVector offset = ConeVector::Zero();  // added to J v: w = J v + offset
  // Added as well, where the conditions can be met with it: what takes a contact back to where it
  // should be. Fingers that jam an object may have no velocities that do so.
  ConeVector correction = ConeVector::Zero();
  double lower = 0.0;  // of the impulse of a joint [N s, N m s]
  double upper = std::numeric_limits<double>::infinity();
  double compliance = 0.0;  // >= 0, of a joint [velocity per impulse]
};

// Velocities of an island, a group of bodies that touch each other.
struct ContactProblem {
  // The mass matrix, block-diagonal: one block a body or robot, positive definite.
  struct Mass {
    int first = 0;
    Eigen::MatrixXd matrix;
  };
  std::vector<Mass> masses;  // in the order of the velocities, none left out
  Eigen::VectorXd free;      // v without any contact
  std::vector<ContactCondition> contacts;
};

struct ContactSolverOptions {
  // Violation of the law, relative to the velocities that occur, at which the search ends (> 0),
  // and up to which a search that rounding stalls counts as solved.
  double tolerance = 1e-9;
  double acceptable = 1e-5;
  int max_rounds = 30;  // steps of the multipliers (>= 1)
  int max_newton = 30;  // steps within each (>= 1)
};

// How a solution ended.
enum class ContactOutcome {
  solved,
  not_converged,  // the best velocities found, their violation is stated
};

struct ContactSolution {
  ContactOutcome outcome = ContactOutcome::solved;
  Eigen::VectorXd velocity;
  std::vector<Eigen::Vector4d> impulses;  // of each contact, in the order of its rows; unused: 0
  bool corrected = true;                  // the corrections of contacts are met
  double violation = 0.0;                 // of the law, relative as in the options
  double stiffness = std::numeric_limits<double>::infinity();  // for the next warm start
  int newton_steps = 0;
  int pivots = 0;
};

// Where the search begins: with the velocities and impulses of the step before. Empty: not known.
struct WarmStart {
  Eigen::VectorXd velocity = {};
  std::vector<Eigen::Vector4d> impulses = {};
  // How stiff contacts may be from which cones began to converge at once. Contacts that jam have
  // to begin softer than others, step after step.
  double stiffness = std::numeric_limits<double>::infinity();
};

}  // namespace prehend

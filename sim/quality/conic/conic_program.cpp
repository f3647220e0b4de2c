#include "sim/quality/conic/conic_program.h"

#include <algorithm>
#include <string>

#include "sim/base/input_error.h"
#include "sim/quality/conic/conic_presolve.h"
#include "sim/quality/conic/interior_point.h"

// The program is solved in three layers, each of which makes the next one's work well defined:
//
//   1. Equilibration scales rows and columns to entries of the order of one, so that relative
//      thresholds for dependence mean the same for every row.
//   2. Reduction leaves out dependent rows of A and directions of x that no constraint sees, with
//      which the linear systems of the interior point method would be singular. It may already find
//      that the program is infeasible.
//   3. The interior point method solves what is left.
//
// The result is taken back through the layers in reverse order. Residuals and gap are then computed
// from the given program, so that they include the rounding of all layers.
namespace prehend {
namespace {

void check(const ConicProgram& p) {
  require(p.cone.orthant >= 0, {.field = "cone", .problem = "an orthant of negative size"});
  for (const int rows : p.cone.second_order) {
    require(rows > 0, {.field = "cone", .problem = "a second-order cone without rows"});
  }
  require(p.A.rows() == p.b.size() && (p.A.rows() == 0 || p.A.cols() == p.c.size()),
          {.field = "A", .problem = "its shape is not that of b and c"});
  require(p.G.rows() == p.h.size() && (p.G.rows() == 0 || p.G.cols() == p.c.size()),
          {.field = "G", .problem = "its shape is not that of h and c"});
  require(p.cone.rows() == p.h.size(),
          {.field = "cone", .problem = "it has not as many rows as h"});
  require(
      p.c.allFinite() && p.A.allFinite() && p.b.allFinite() && p.G.allFinite() && p.h.allFinite(),
      {.field = "conic program", .problem = "a value is not finite"});
}

void check(const ConicOptions& options) {
  require(options.tolerance > 0.0 && options.acceptable > 0.0 &&
              options.infeasible_tolerance > 0.0 && options.max_iterations > 0,
          {.field = "conic options", .problem = "must be positive"});
}

// Values, residuals and gap in the units of the program as it was given. A certificate of dual
// infeasibility is a direction of x: it fulfils the equations without b and h. One of primal
// infeasibility fulfils the dual equations without c. The equations that a certificate is not about
// have the residual 0.
void measure(const ConicProgram& p, ConicSolution& solution) {
  const bool homogeneous = solution.status == ConicStatus::dual_infeasible;
  const bool no_objective = solution.status == ConicStatus::primal_infeasible;
  Eigen::VectorXd equations = p.A * solution.x;
  Eigen::VectorXd cone = p.G * solution.x + solution.s;
  if (!homogeneous) {
    equations -= p.b;
    cone -= p.h;
  }
  Eigen::VectorXd dual = p.A.transpose() * solution.y + p.G.transpose() * solution.z;
  if (!no_objective) dual += p.c;
  solution.primal_value = p.c.dot(solution.x);
  solution.dual_value = -p.b.dot(solution.y) - p.h.dot(solution.z);
  solution.primal_residual =
      no_objective ? 0.0 : std::max(largest_entry(equations), largest_entry(cone));
  solution.dual_residual = homogeneous ? 0.0 : largest_entry(dual);
  solution.gap = solution.s.dot(solution.z);
}

// A certificate is a direction of any length. The scaling of the program has changed its value (b'y
// + h'z, or c'x), which is made -1 again.
void normalise(const ConicProgram& p, ConicSolution& solution) {
  if (solution.status == ConicStatus::primal_infeasible) {
    const double size = -p.b.dot(solution.y) - p.h.dot(solution.z);
    solution.y /= size;
    solution.z /= size;
  } else if (solution.status == ConicStatus::dual_infeasible) {
    const double size = -p.c.dot(solution.x);
    solution.x /= size;
    solution.s /= size;
  }
}

// Gives matrices without rows the number of columns that products with x need: callers may pass
// them in any shape.
ConicProgram shaped(const ConicProgram& program) {
  ConicProgram p = program;
  if (p.A.rows() == 0) p.A.resize(0, p.c.size());
  if (p.G.rows() == 0) p.G.resize(0, p.c.size());
  return p;
}

}  // namespace

ConicSolution solve(const ConicProgram& program, const ConicOptions& options) {
  check(program);
  check(options);
  const ConicProgram p = shaped(program);
  const Equilibration equilibration(p);
  const Reduction reduction(equilibration.scaled());
  ConicSolution solution = reduction.solution();
  if (!reduction.decided()) {
    solution = interior_point(reduction.reduced(), options);
    reduction.restore(solution);
  }
  equilibration.restore(solution);
  normalise(p, solution);
  measure(p, solution);
  return solution;
}

}  // namespace prehend

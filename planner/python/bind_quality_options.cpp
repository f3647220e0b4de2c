#include "planner/python/options_class.h"
#include "sim/quality/quality.h"

namespace prehend::python {

void bind_quality_options(py::module_& core) {
  const EnumNames<FrictionCone> cones = {{"exact", FrictionCone::exact},
                                         {"pyramid", FrictionCone::pyramid}};
  OptionsClass<WrenchSpaceOptions>(core, "WrenchSpaceOptions",
                                   "The set of wrenches that contacts can exert (Ferrari and Canny "
                                   "1992).")
      .choice("norm", &WrenchSpaceOptions::norm,
              {{"l1", WrenchNorm::l1}, {"linf", WrenchNorm::linf}},
              R"(What is unit: "l1", the sum of all normal forces, or "linf", each of them.)")
      .choice("cone", &WrenchSpaceOptions::cone, cones,
              R"("pyramid" with so many edges, or the "exact" friction cone.)")
      .number("edges", &WrenchSpaceOptions::edges, {.lower = 3.0, .upper = 1024.0},
              "Of a pyramid (3 to 1024).")
      .choice("force", &WrenchSpaceOptions::force,
              {{"at_most", UnitForce::at_most}, {"exactly", UnitForce::exactly}},
              R"(Whether forces may stay below the unit: "at_most" or "exactly".)");
  OptionsClass<EpsilonOptions>(core, "EpsilonOptions", "How closely epsilon is bracketed.")
      .number("relative_tolerance", &EpsilonOptions::relative_tolerance, kAtLeast0,
              "Of upper - lower.")
      .number("cutoff", &EpsilonOptions::cutoff, kAtLeast0,
              "Stop as soon as the upper bound is below this.")
      .number("max_facets", &EpsilonOptions::max_facets, kAtLeast1, "Facets made before giving up.")
      .number("descent_steps", &EpsilonOptions::descent_steps, kAtLeast0,
              "Steps downhill on the support function; they pay on smooth sets.");
  OptionsClass<SetHullOptions>(core, "SetHullOptions", "How closely the volume is bracketed.")
      .number("relative_tolerance", &SetHullOptions::relative_tolerance, kAbove0,
              "A facet is final when the set reaches beyond it by at most this part of its size.")
      .number("max_points", &SetHullOptions::max_points, kAtLeast1,
              "Points after which no more are asked for.");
  OptionsClass<NoiseOptions>(core, "NoiseOptions",
                             "Normal distributions of what is uncertain, by their standard "
                             "deviations; lengths are parts of r = 1 / torque_scale.")
      .number("pose_position", &NoiseOptions::pose_position,
              "The object against the hand, moved [r].")
      .number("pose_angle", &NoiseOptions::pose_angle, "And turned [rad].")
      .number("contact_position", &NoiseOptions::contact_position, "Each contact by itself [r].")
      .number("normal_angle", &NoiseOptions::normal_angle, "Its normal [rad].")
      .number("friction", &NoiseOptions::friction, "Of the logarithm of its friction coefficient.")
      .number("samples", &NoiseOptions::samples, "So many (>= 1).")
      .number("seed", &NoiseOptions::seed, kAtLeast0, "Of the samples.");
  OptionsClass<ForceOptions>(core, "ForceOptions", "Which contact forces balance a wrench.")
      .choice("measure", &ForceOptions::measure,
              {{"largest_normal", ForceMeasure::largest_normal},
               {"sum_of_normals", ForceMeasure::sum_of_normals}},
              "What is made as small as it can be: \"largest_normal\" (each contact has its own "
              "actuator) or \"sum_of_normals\" (all share one).")
      .choice("cone", &ForceOptions::cone, cones, R"("exact" or "pyramid".)")
      .number("edges", &ForceOptions::edges, {.lower = 3.0, .upper = 1024.0},
              "Of a pyramid (3 to 1024).")
      .number("residual_tolerance", &ForceOptions::residual_tolerance, kAbove0,
              "Of the wrench left over, relative to the wrench.")
      .number("gap_tolerance", &ForceOptions::gap_tolerance, kAbove0, "Of the measure, relative.");
}

}  // namespace prehend::python

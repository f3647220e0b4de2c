// The origin of a grasp as text for tables and reports.
#pragma once

#include <string>

namespace prehend {

struct Candidate;
struct CollisionNames;
struct CompiledScene;
struct LoadCase;
struct PlanResult;
struct Robustness;
struct ScoredGrasp;
struct Trial;

// Primitive and rule that a grasp was proposed by: "cylinder 1 (cylinder side, thumb across)";
// "given" for a grasp that the caller gave.
std::string origin_text(const ScoredGrasp& grasp, const PlanResult& result);

// Name of the preshape with which the hand approached; empty for a candidate without one.
std::string preshape_name(const CompiledScene& scene, const Candidate& candidate);

// The same for people, with the strategy by which the hand closes unless it closes all at once:
// "spread_0, gentle"; "-" for neither.
std::string opening_text(const CompiledScene& scene, const Candidate& candidate);

// How many times the object's weight the hand holds: "3.2", "any" where the weight loads no drive
// whose effort is known, "0" where no forces balance it.
std::string load_factor_text(const LoadCase& load_case);

// How a grasp fails with the object farther off the weakest way than it may be: "the hand closes
// beside it". Empty where no way that was tried is weak.
std::string weakness_text(const Robustness& robustness);

// What moved until the grasp held: "the hand gave way by 1.2 mm; the object was pushed by 4 mm,
// turned by 12 degrees, slid by 3 mm". Parts below 0.05 mm or 0.05 degrees are left out; empty
// where none is left.
std::string moved_text(const Trial& trial);

// How a grasp ends on an object that is free to move while the hand closes: "epsilon 0.2134, moved
// 8 mm" there, or what became of it: "pushed_away".
std::string free_text(const Trial& free);

// Which link met what: "left_finger met the object"; of a trial, also how deep it was in it at the
// start, where that was measured: "left_finger met the object, 3.1 mm deep". Empty without a
// collision.
std::string collision_text(const CollisionNames& collision_of);
std::string collision_text(const CompiledScene& scene, const Trial& trial);

}  // namespace prehend

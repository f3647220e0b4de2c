// Grasps at the ends of what numbers can say: epsilon_l1 beside exact arithmetic, as Markdown.
//   extremes ORACLE.json   the tables of tests/sim/quality/oracle/extremes.md
//   extremes columns       the wrenches, for tests/sim/quality/oracle/exact_hull
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "sim/base/formatted.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/extreme_grasps.h"
#include "tests/support/refused_grasps.h"

namespace {

using nlohmann::json;
using prehend::EpsilonBracket;
using prehend::EpsilonStatus;
using prehend::Wrenches;
using prehend::test::ExtremeGrasp;

// The full hull of more wrenches than this takes minutes.
constexpr Eigen::Index kMaxForHull = 160;

const char* name_of(EpsilonStatus status) {
  switch (status) {
    case EpsilonStatus::converged:
      return "converged";
    case EpsilonStatus::no_force_closure:
      return "no force closure";
    case EpsilonStatus::below_cutoff:
      return "below cutoff";
    case EpsilonStatus::limit:
      return "limit";
    case EpsilonStatus::stalled:
      return "stalled";
  }
  return "";
}

std::string number(double value) { return value == 0.0 ? "0" : prehend::formatted("%.12g", value); }

std::string relative(double error, double value) {
  return error == 0.0 ? "0" : prehend::formatted("%.0e", error / value);
}

double number_at(const json& oracle, const char* field) {
  return std::stod(oracle.at(field).get<std::string>());
}

// Whether force closure was found, and where exact arithmetic says otherwise, why.
std::string closure(const EpsilonBracket& bracket, const json& oracle, const Wrenches& wrenches) {
  const bool exact = oracle.at("force_closure").get<bool>();
  if (bracket.force_closure() == exact) return exact ? "yes" : "no";
  const double part = number_at(oracle, "epsilon") / wrenches.cwiseAbs().maxCoeff();
  return std::string(bracket.force_closure() ? "yes" : "no") +
         prehend::formatted(", exact: %s, by %.0e of the size", exact ? "yes" : "no", part);
}

// The larger difference of the bracket's ends from the exact value, relative to that.
std::string difference(const EpsilonBracket& bracket, const json& oracle) {
  const double low = number_at(oracle, "epsilon");
  if (!bracket.force_closure()) return "";
  if (low != number_at(oracle, "upper")) return "bounds only";
  const double error = std::max(std::abs(bracket.lower - low), std::abs(bracket.upper - low));
  return relative(error, low);
}

std::string exact_value(const json& oracle) {
  const double low = number_at(oracle, "epsilon");
  const double high = number_at(oracle, "upper");
  return low == high ? number(low) : prehend::formatted("%.4g to %.4g", low, high);
}

// What the full hull says: its difference from the exact value.
std::string hull_column(const Wrenches& wrenches, const json& oracle) {
  if (wrenches.cols() > kMaxForHull) return "";
  const prehend::WrenchHull hull = prehend::wrench_hull(wrenches);
  if (hull.status == prehend::HullStatus::flat) return "flat";
  if (!hull.force_closure()) return "no force closure";
  const double exact = number_at(oracle, "epsilon");
  return relative(std::abs(hull.min_offset - exact), exact);
}

void print_row(const ExtremeGrasp& grasp, const json& oracle) {
  const Wrenches wrenches = contact_wrenches(grasp.contacts, grasp.frame, grasp.edges);
  const EpsilonBracket bracket = prehend::epsilon_l1(wrenches);
  const std::string lower = number(bracket.lower);
  const std::string upper = number(bracket.upper);
  std::printf("| %s | %td | %s | %s | %s | %s | %s | %s | %s |\n", grasp.name.c_str(),
              wrenches.cols(), name_of(bracket.status), lower.c_str(), upper.c_str(),
              exact_value(oracle).c_str(), closure(bracket, oracle, wrenches).c_str(),
              difference(bracket, oracle).c_str(), hull_column(wrenches, oracle).c_str());
}

void print_tables(const std::string& oracle_file) {
  std::ifstream stream(oracle_file);
  if (!stream) throw std::runtime_error(oracle_file + ": cannot be read");
  std::map<std::string, json> oracle;
  for (const json& entry : json::parse(stream)) oracle[entry.at("name")] = entry;
  std::printf(
      "| grasp | wrenches | status | lower | upper | exact | force closure | difference | hull |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const ExtremeGrasp& grasp : prehend::test::extreme_grasps()) {
    print_row(grasp, oracle.at(grasp.name));
  }
  std::printf("\n| refused | message |\n|---|---|\n");
  for (const prehend::test::RefusedGrasp& grasp : prehend::test::refused_grasps()) {
    std::printf("| %s | `%s` |\n", grasp.name.c_str(), refusal(grasp).c_str());
  }
}

void print_columns() {
  for (const ExtremeGrasp& grasp : prehend::test::extreme_grasps()) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, grasp.frame, grasp.edges);
    std::printf("%s\n%td\n", grasp.name.c_str(), wrenches.cols());
    for (Eigen::Index j = 0; j < wrenches.cols(); ++j) {
      for (int i = 0; i < 6; ++i) std::printf("%a%c", wrenches(i, j), i < 5 ? ' ' : '\n');
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("asks for the oracle's file, or the word columns");
    const std::string what = argv[1];
    what == "columns" ? print_columns() : print_tables(what);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "extremes: %s\n", error.what());
    return 2;
  }
}

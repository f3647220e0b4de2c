#include "benchmarks/soak/tally.h"

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <sstream>

namespace prehend::soak {
namespace {

// The message with each number as "#", so that equal refusals are counted together.
std::string without_numbers(const std::string& message) {
  std::string text;
  for (const char c : message) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (digit && !text.empty() && text.back() == '#') continue;
    text += digit ? '#' : c;
  }
  return text;
}

}  // namespace

void Tally::add(std::uint64_t number, const CaseFindings& findings) {
  ++cases_;
  failed_ += !findings.faults.empty();
  without_grasp_ += findings.grasps == 0 && findings.refused.empty();
  refused_ += !findings.refused.empty();
  if (!findings.refused.empty()) ++refusals_[without_numbers(findings.refused)];
  for (const test::Fault& fault : findings.faults) ++kinds_[fault.kind];
  sum_.grasps += findings.grasps;
  sum_.other_trials += findings.other_trials;
  sum_.contacts += findings.contacts;
  sum_.paths += findings.paths;
  sum_.postures += findings.postures;
  sum_.epsilons += findings.epsilons;
  sum_.twice += findings.twice;
  sum_.epsilon = std::max(sum_.epsilon, findings.epsilon);
  sum_.penetration = std::max(sum_.penetration, findings.penetration);
  seconds_ += findings.seconds;
  if (findings.seconds > sum_.seconds) slowest_ = number;
  if (findings.megabytes > sum_.megabytes) largest_ = number;
  sum_.seconds = std::max(sum_.seconds, findings.seconds);
  sum_.megabytes = std::max(sum_.megabytes, findings.megabytes);
}

std::string Tally::line() const {
  std::ostringstream text;
  text << cases_ << " cases, " << failed_ << " failed, " << sum_.grasps << " grasps, " << sum_.paths
       << " paths";
  return text.str();
}

std::string Tally::table() const {
  std::ostringstream text;
  const auto row = [&](const char* name) -> std::ostream& {
    return text << std::left << std::setw(38) << name;
  };
  row("cases") << cases_ << "\n";
  row("  refused as invalid input") << refused_ << "\n";
  row("  without a grasp") << without_grasp_ << "\n";
  row("  compared on one and two threads") << sum_.twice << "\n";
  row("grasps judged") << sum_.grasps << "\n";
  row("other trials judged") << sum_.other_trials << "\n";
  row("contacts judged") << sum_.contacts << "\n";
  row("paths judged") << sum_.paths << ", in " << sum_.postures << " postures\n";
  row("epsilons compared") << sum_.epsilons << "\n";
  row("  largest relative difference") << sum_.epsilon << "\n";
  row("deepest penetration") << 1e6 * sum_.penetration << " um\n";
  row("processor time of the library") << seconds_ << " s\n";
  row("  longest") << sum_.seconds << " s, case " << slowest_ << "\n";
  row("most memory") << sum_.megabytes << " MB, case " << largest_ << "\n";
  row("cases that failed") << failed_ << "\n";
  for (const auto& [kind, count] : kinds_) row(("  faults: " + kind).c_str()) << count << "\n";
  for (const auto& [message, count] : refusals_) {
    text << "refused " << count << " times: " << message << "\n";
  }
  return text.str();
}

}  // namespace prehend::soak

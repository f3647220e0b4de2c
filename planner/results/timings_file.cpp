#include "planner/results/timings_file.h"

#include <nlohmann/json.hpp>

namespace prehend {

std::string timings_json(const std::vector<StageTime>& times, const TrialSeconds& trials,
                         int threads) {
  nlohmann::ordered_json json{{"threads", threads}, {"stages", nlohmann::ordered_json::array()}};
  double total = 0.0;
  for (const StageTime& time : times) {
    json["stages"].push_back({{"name", name_of(time.stage)}, {"seconds", time.seconds}});
    total += time.seconds;
  }
  json["total"] = total;
  json["trials_on_all_threads"] = {
      {"reach", trials.reach}, {"approach", trials.approach}, {"close", trials.close}};
  return json.dump(1) + "\n";
}

}  // namespace prehend

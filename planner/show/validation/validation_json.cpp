#include <nlohmann/json.hpp>

#include "planner/show/validation/validation_text.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json or_null(const std::optional<Interval>& interval) {
  return interval ? Json{interval->lower, interval->upper} : Json();
}

Json calibration_json(const Calibration& calibration) {
  Json bins = Json::array();
  for (const ReliabilityBin& bin : calibration.bins) {
    bins.push_back({{"from", bin.from},
                    {"to", bin.to},
                    {"count", bin.count},
                    {"lifted", bin.lifted},
                    {"predicted", bin.count > 0 ? Json(bin.predicted) : Json()},
                    {"observed", bin.count > 0 ? Json(bin.share()) : Json()},
                    {"interval", {bin.observed.lower, bin.observed.upper}}});
  }
  return {{"expected_error", calibration.expected_error},
          {"brier", calibration.brier},
          {"brier_of_base_rate", calibration.brier_of_base_rate},
          {"bins", bins}};
}

Json score_json(const ScoreFigures& figures) {
  Json json{{"name", figures.score.name},
            {"title", figures.score.title},
            {"auc", or_null(figures.auc.value)},
            {"interval", or_null(figures.auc.interval)},
            {"over_epsilon", or_null(figures.over_epsilon.value)},
            {"over_epsilon_interval", or_null(figures.over_epsilon.interval)}};
  if (figures.calibration) json["calibration"] = calibration_json(*figures.calibration);
  json["roc"] = Json::array();
  for (const RocPoint& point : figures.roc) json["roc"].push_back({point.failed, point.lifted});
  return json;
}

Json parts_json(const std::vector<ValidationPart>& parts, const std::vector<ScoreFigures>& scores) {
  Json list = Json::array();
  for (const ValidationPart& part : parts) {
    Json auc = Json::object();
    for (std::size_t s = 0; s < scores.size(); ++s) {
      auc[std::string(scores[s].score.name)] = or_null(part.auc[s]);
    }
    list.push_back(
        {{"name", part.name}, {"lifted", part.lifted}, {"failed", part.failed}, {"auc", auc}});
  }
  return list;
}

Json frames_json(const FrameCheck& frames) {
  Json places = Json::object();
  for (const ObjectPlace place : kAll<ObjectPlace>) {
    places[std::string(name_of(place))] = frames.places[static_cast<std::size_t>(place)];
  }
  Json json{{"grasps", frames.grasps},
            {"object", places},
            {"in_obstacles", frames.in_obstacles},
            {"words", frame_text(frames)},
            {"suspicion", nullptr}};
  if (frames.suspicion) {
    json["suspicion"] = {{"change", frames.suspicion->words},
                         {"question", frames.suspicion->question},
                         {"between", frames.suspicion->between}};
  }
  return json;
}

Json settings_json(const ValidationReport& report) {
  return {{"seed", report.bootstrap.seed},
          {"samples", report.samples},
          {"resamples", report.bootstrap.resamples},
          {"level", report.bootstrap.level},
          {"groups", name_of(report.bootstrap.grouping)}};
}

}  // namespace

std::string validation_json(const ValidationReport& report) {
  Json outcomes = Json::object();
  for (const Outcome outcome : kAll<Outcome>) {
    const int count = report.outcomes[outcome];
    if (count > 0) outcomes[std::string(name_of(outcome))] = count;
  }
  const Json json{{"format", "prehend truth report 1"},
                  {"file", report.name},
                  {"settings", settings_json(report)},
                  {"lifted", report.lifted},
                  {"failed", report.failed},
                  {"groups_drawn", report.groups},
                  {"resamples_of_one_outcome", report.undefined},
                  {"frames", frames_json(report.frames)},
                  {"outcomes", outcomes},
                  {"scores",
                   [&] {
                     Json list = Json::array();
                     for (const ScoreFigures& figures : report.scores) {
                       list.push_back(score_json(figures));
                     }
                     return list;
                   }()},
                  {"objects", parts_json(report.objects, report.scores)},
                  {"sessions", parts_json(report.sessions, report.scores)}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace prehend

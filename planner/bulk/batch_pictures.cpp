#include "planner/bulk/batch_pictures.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "planner/bulk/content_key.h"
#include "planner/bulk/part_worker.h"
#include "planner/show/best_viewpoint.h"
#include "planner/show/grasp_picture.h"
#include "planner/show/posed_grasp.h"
#include "sim/base/formatted.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

constexpr int kPictureWidth = 480;
constexpr int kPictureHeight = 380;

// A number from 0 to 2^64 - 1 that the text determines.
std::uint64_t lot_of(const std::string& text) {
  const std::string digits = ContentKey().add(std::string_view(text)).name();
  std::uint64_t lot = 0;
  std::from_chars(digits.data(), digits.data() + 16, lot, 16);
  return lot;
}

std::string title_of(const Batch& batch, const ChosenGrasp& chosen) {
  const std::string name = part_name(batch, part_at(batch, chosen.part));
  if (chosen.grasp.outcome == Outcome::stable) {
    return formatted("%s: epsilon %.3f", name.c_str(), chosen.grasp.epsilon.lower);
  }
  std::string outcome(name_of(chosen.grasp.outcome));
  std::replace(outcome.begin(), outcome.end(), '_', ' ');
  return name + ": " + outcome;
}

}  // namespace

void GraspLottery::add(std::size_t part, const std::string& key, const GraspSet& set, bool stable) {
  const auto takes_part = [&](const GraspSetEntry& grasp) {
    return (grasp.outcome == Outcome::stable) == stable;
  };
  const auto count =
      static_cast<std::uint64_t>(std::count_if(set.grasps.begin(), set.grasps.end(), takes_part));
  if (count == 0) return;
  const std::uint64_t lot = lot_of(key + (stable ? " stable" : " other"));
  if (chosen_.size() >= places_ && lot > chosen_.back().lot) return;
  std::uint64_t left = lot % count;
  for (const GraspSetEntry& grasp : set.grasps) {
    if (!takes_part(grasp) || left-- > 0) continue;
    add(ChosenGrasp{lot, part, grasp});
    return;
  }
}

void GraspLottery::add(const GraspLottery& other) {
  for (const ChosenGrasp& grasp : other.chosen_) add(grasp);
}

void GraspLottery::add(ChosenGrasp grasp) {
  const auto place = std::upper_bound(chosen_.begin(), chosen_.end(), grasp,
                                      [](const ChosenGrasp& a, const ChosenGrasp& b) {
                                        return std::pair(a.lot, a.part) < std::pair(b.lot, b.part);
                                      });
  chosen_.insert(place, std::move(grasp));
  if (chosen_.size() > places_) chosen_.pop_back();
}

BatchPicture batch_picture(const Batch& batch, const BatchInputs& inputs, const ChosenGrasp& chosen,
                           const RunContext& context) {
  PartWorker worker;
  const CompiledScene scene =
      compile(worker.scene(batch, inputs, part_at(batch, chosen.part)), context);
  PosedGrasp posed;
  posed.X_OH = chosen.grasp.X_OH;
  posed.joints = chosen.grasp.joints;
  for (const GraspSetContact& contact : chosen.grasp.contacts) {
    GraspContact touched;
    touched.link = LinkId{contact.link};
    touched.point.position = contact.p_O.cast<double>();
    touched.point.normal = contact.n_O.cast<double>().normalized();
    touched.point.friction = scene.links[index(touched.link)].friction;
    posed.contacts.push_back(touched);
  }
  BatchPicture picture;
  picture.title = title_of(batch, chosen);
  picture.image = grasp_picture(scene, posed, best_viewpoint(scene, posed, context),
                                {kPictureWidth, kPictureHeight}, context);
  return picture;
}

}  // namespace prehend

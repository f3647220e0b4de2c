#include "planner/live/protocol/command.h"
#include "sim/scene/json_primitive.h"

// The command that tells which shapes the object is taken for.
namespace prehend {
namespace {

ProtocolJson distances_json(const SurfaceDistances& distances) {
  return {{"median", distances.median},
          {"percentile_95", distances.percentile_95},
          {"largest", distances.largest}};
}

ProtocolJson primitives_of(const CommandScope& scope, const JsonField& /*request*/) {
  const ObjectPrimitives& found = scope.session.primitives();
  const std::size_t solids = found.solids ? found.solids->primitives.size() : 0;
  ProtocolJson json{{"surface", scope.session.state().world->surfaces().object},
                    {"distances", nullptr},
                    {"primitives", ProtocolJson::array()}};
  if (found.solids) json["distances"] = distances_json(found.solids->distances);
  for (std::size_t k = 0; k < found.all.size(); ++k) {
    ProtocolJson one = primitive_to_json(found.all[k]);
    one["share"] = k < solids ? ProtocolJson(found.solids->share[k]) : ProtocolJson();
    one["distances"] = k < solids ? distances_json(found.solids->distances_of[k]) : ProtocolJson();
    json["primitives"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

std::vector<Command> primitive_commands() {
  return {{"primitives",
           CommandKind::query,
           "The shapes that grasps are made for.",
           {},
           "`primitives` as in a scene file, each with its `share` of the surface and the "
           "`distances` (`median`, `percentile_95`, `largest` [m]) of what is nearest to it (null "
           "where stated, and of rims and bars); `distances` of the whole `surface`",
           primitives_of}};
}

}  // namespace prehend

// Carries out the parts of a batch.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planner/bulk/batch_inputs.h"
#include "planner/bulk/batch_part.h"
#include "planner/results/datasets/grasp_set.h"
#include "sim/base/run_context.h"
#include "sim/shape/files/mesh_file.h"

namespace prehend {

struct CompiledScene;

// What a thread needs for parts, one after the other. It keeps the mesh and the primitives of the
// last object, so that neighbouring parts share them; that changes no result.
class PartWorker {
 public:
  // The name of the part's result (part_key). The object's file is read unless it was the last one.
  // Throws InputError for a file that cannot be read.
  std::string key(const Batch& batch, const BatchInputs& inputs, const BatchPart& part);

  // Plans the part: every candidate that was tried, in the order of the search. Throws InputError
  // where the object cannot be planned for, and Cancelled.
  GraspSet run(const Batch& batch, const BatchInputs& inputs, const BatchPart& part,
               const RunContext& context);

  // The scene of the part, as `run` makes it. Throws InputError.
  Scene scene(const Batch& batch, const BatchInputs& inputs, const BatchPart& part);

 private:
  struct Mesh {
    std::size_t object = 0;
    TriangleMesh mesh;                 // frame O, unscaled [m]
    std::string unit;                  // in which its file was read
    std::vector<MeshPart> parts = {};  // that it names
  };
  struct Key {
    std::size_t object = 0;
    std::string key;
  };
  // Of the last object at one scale, by setting and seed.
  struct Primitives {
    std::size_t object = 0;
    std::size_t scale = 0;
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Primitive>> of;
  };

  const Mesh& mesh(const BatchObject& object, std::size_t number);
  const std::vector<Primitive>& primitives(const CompiledScene& scene, const PlanOptions& options,
                                           const BatchPart& part, const RunContext& context);

  std::optional<Mesh> mesh_;
  std::optional<Key> key_;
  std::optional<Primitives> primitives_;
};

}  // namespace prehend

// Reader of files of executed grasps (docs/reference/truth-file.md).
#pragma once

#include <string>
#include <vector>

#include "planner/show/validation/labels.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/candidate.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// What was grasped, with which hand and among what.
struct ExecutedObject {
  std::string name;  // in the file
  CompiledScene scene;
};

// Executions of one grasp that ended the same way.
struct Execution {
  Candidate grasp;
  Label label;  // `object` is an index into Truth::objects, `session` into Truth::sessions
};

struct ExecutedGrasps {
  std::vector<ExecutedObject> objects;
  std::vector<std::string> sessions;  // in the order of their first executions
  std::vector<Execution> executions;

  std::vector<Label> labels() const;
};

// Throws InputError that names the file, the field and the value, also for unknown fields, for
// executions of objects that the file does not list, and where all executions have the same
// outcome, from which nothing can be learnt. Throws Cancelled.
ExecutedGrasps read_executed_grasps(const JsonFile& file, const RunContext& context = {});

// The same with the objects of the file given: only its executions are read.
ExecutedGrasps read_executions(const JsonFile& file, std::vector<ExecutedObject> objects);

}  // namespace prehend

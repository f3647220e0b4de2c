#include "sim/manipulation/test_procedure_file.h"

#include "sim/base/data_library.h"
#include "sim/base/json/json_fields.h"

namespace prehend {
namespace {

constexpr double kLongestPhase = 1000.0;  // [s]

DataLibrary library() { return {"protocols", ".json"}; }

// A number that must be above 0.
void positive(FieldReader& fields, std::string_view name, double& value) {
  fields(name, value);
  if (fields.field().has(name)) fields.require(name, value > 0.0, "must be above 0");
}

void positive(FieldReader& fields, std::string_view name, std::optional<double>& value) {
  if (!fields.allow(name)) return;
  positive(fields, name, value.emplace());
}

void not_negative(FieldReader& fields, std::string_view name, double& value) {
  fields(name, value);
  if (fields.field().has(name)) fields.require(name, value >= 0.0, "must not be negative");
}

void read_limits(FieldReader& fields, PhaseLimits& limits) {
  positive(fields, "moved", limits.moved);
  positive(fields, "turned", limits.turned);
  positive(fields, "dropped", limits.dropped);
  positive(fields, "least_rise", limits.least_rise);
  positive(fields, "least_fall", limits.least_fall);
  fields("loses_contact", limits.loses_contact);
}

void read_motion(FieldReader& fields, ProcedurePhase& phase) {
  const bool lifts = phase.kind == PhaseKind::lift;
  const bool repeats = phase.kind == PhaseKind::circle || phase.kind == PhaseKind::swing ||
                       phase.kind == PhaseKind::turn;
  if (lifts) {
    fields.needs("height");
    positive(fields, "height", phase.height);
    not_negative(fields, "height_in_edges", phase.height_in_edges);
  }
  if (phase.kind == PhaseKind::approach) {
    fields.needs("distance");
    positive(fields, "distance", phase.distance);
  }
  if (!repeats) return;
  for (const char* name : {"amplitude", "frequency"}) fields.needs(name);
  positive(fields, "amplitude", phase.amplitude);
  positive(fields, "frequency", phase.frequency);
  if (phase.kind == PhaseKind::circle) return;
  fields.needs("axis");
  if (fields.allow("axis")) phase.axis = fields.field()["axis"].direction();
}

void read_phase(FieldReader& fields, ProcedurePhase& phase) {
  for (const char* name : {"kind", "duration"}) fields.needs(name);
  fields("kind", phase.kind);
  positive(fields, "duration", phase.duration);
  fields.require("duration", phase.duration <= kLongestPhase, "must be at most 1000 s");
  fields("pull", phase.pull);
  fields("pull_grows", phase.pull_grows);
  fields("gravity", phase.gravity);
  fields("frame", phase.frame);
  read_motion(fields, phase);
  fields.object("fails", [&](FieldReader& inner) { read_limits(inner, phase.fails); });
}

void read_phases(FieldReader& fields, std::string_view name, std::vector<ProcedurePhase>& phases) {
  fields.objects(name, phases,
                 [](FieldReader& inner, ProcedurePhase& phase) { read_phase(inner, phase); });
}

void read_tests(FieldReader& fields, std::vector<ProcedureTest>& tests) {
  fields.needs("tests");
  fields.objects("tests", tests, [](FieldReader& inner, ProcedureTest& test) {
    for (const char* name : {"name", "phases"}) inner.needs(name);
    inner("name", test.name);
    read_phases(inner, "phases", test.phases);
    inner.require("phases", !test.phases.empty(), "must not be empty");
  });
  fields.require("tests", !tests.empty(), "must not be empty");
}

void read_object(FieldReader& fields, ProcedureObject& object) {
  positive(fields, "mass", object.mass);
  positive(fields, "density", object.density);
  if (object.density) fields.require("density", !object.mass, "not together with mass");
}

TestProcedure read(const JsonFile& file) {
  TestProcedure procedure;
  FieldReader fields(file.root());
  fields.needs("name");
  fields("name", procedure.name);
  fields("source", procedure.source);
  fields("step", procedure.step);
  if (fields.field().has("step")) {
    fields.require("step", kSteps.contains(procedure.step), kSteps.words().c_str());
  }
  fields.object("object", [&](FieldReader& inner) { read_object(inner, procedure.object); });
  if (fields.allow("friction")) not_negative(fields, "friction", procedure.friction.emplace());
  if (fields.allow("torsion")) not_negative(fields, "torsion", procedure.torsion.emplace());
  fields("gravity", procedure.gravity);
  fields("on_support", procedure.on_support);
  read_phases(fields, "prepare", procedure.prepare);
  read_tests(fields, procedure.tests);
  fields.finish();
  return procedure;
}

}  // namespace

TestProcedure read_test_procedure(const std::filesystem::path& file) {
  return read(JsonFile(file));
}

TestProcedure parse_test_procedure(const std::string& text, const std::string& name) {
  return read(JsonFile(name, text));
}

std::vector<std::string> library_test_procedure_names() { return library().names(); }

std::filesystem::path find_test_procedure(const std::string& name_or_file) {
  return library().find(name_or_file, "protocol");
}

}  // namespace prehend

#include "planner/main/other_programs.h"
#include "planner/main/program.h"

int main(int argc, char** argv) {
  return prehend::run_program(argc, argv, [&](CLI::App& app, prehend::CommandRequest& request) {
    prehend::start_other_program(argc, argv);
    prehend::add_plan(app, request);
    prehend::add_evaluate(app, request);
    prehend::add_path(app, request);
    prehend::add_together(app, request);
    prehend::add_simulate(app, request);
    prehend::add_render(app, request);
    prehend::add_inspect(app, request);
    prehend::add_quality(app, request);
    prehend::add_convert(app, request);
    prehend::add_other_commands(app);
  });
}

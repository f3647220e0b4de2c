#include "planner/main/bulk/bulk_commands.h"
#include "planner/main/program.h"

namespace {

void add_commands(CLI::App& app, prehend::CommandRequest& request) {
  prehend::add_batch(app, request);
  prehend::add_learn(app, request);
  prehend::add_validate(app, request);
  prehend::add_design(app, request);
}

}  // namespace

int main(int argc, char** argv) { return prehend::run_program(argc, argv, add_commands); }

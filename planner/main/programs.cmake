# The program prehend, and those that it starts for commands that few need (other_programs.h). The
# target programs builds all of them.
file(GLOB command_sources CONFIGURE_DEPENDS planner/main/*.cpp)
list(REMOVE_ITEM command_sources ${PROJECT_SOURCE_DIR}/planner/main/main.cpp)
add_library(prehend_commands STATIC ${command_sources})
target_link_libraries(prehend_commands PUBLIC
  prehend_report prehend_exports prehend_datasets CLI11::CLI11)
target_compile_definitions(prehend_commands PRIVATE PREHEND_VERSION="${PROJECT_VERSION}")
add_executable(prehend planner/main/main.cpp)
target_link_libraries(prehend PRIVATE prehend_commands)

set(prehend_programs prehend)
function(prehend_other_program name folder)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE prehend_commands ${ARGN})
  target_compile_definitions(${name} PRIVATE PREHEND_VERSION="${PROJECT_VERSION}")
  set(prehend_programs ${prehend_programs} ${name} PARENT_SCOPE)
endfunction()
prehend_other_program(prehend-live planner/main/live prehend_protocol prehend_serve prehend_studio)
prehend_other_program(prehend-bulk planner/main/bulk
  prehend_batch prehend_cluster prehend_design prehend_train prehend_truth)
add_custom_target(programs DEPENDS ${prehend_programs})

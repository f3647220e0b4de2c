file(GLOB program_sources CONFIGURE_DEPENDS planner/main/*.cpp)
add_executable(prehend ${program_sources})
target_link_libraries(prehend PRIVATE prehend_report prehend_truth prehend_exports prehend_protocol
  prehend_serve prehend_studio prehend_batch prehend_cluster prehend_datasets prehend_train CLI11::CLI11)
target_compile_definitions(prehend PRIVATE PREHEND_VERSION="${PROJECT_VERSION}")

# The program with all that it starts.
set(prehend_programs prehend)
add_custom_target(programs DEPENDS ${prehend_programs})

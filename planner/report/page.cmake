# The report's page as one source file: page.html with its style, its scripts and three.js put in.
set(page_dir ${CMAKE_CURRENT_LIST_DIR}/page)
file(GLOB page_parts CONFIGURE_DEPENDS ${page_dir}/*)
set(three_scripts ${THREE_JS_DIR}/build/three.min.js
  ${THREE_JS_DIR}/examples/js/controls/OrbitControls.js)
set(page_source ${PROJECT_BINARY_DIR}/report_page.cpp)
add_custom_command(OUTPUT ${page_source}
  COMMAND ${CMAKE_COMMAND} -D PAGE_DIR=${page_dir} "-DTHREE_SCRIPTS=${three_scripts}"
    -D OUTPUT=${page_source} -P ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  DEPENDS ${page_parts} ${three_scripts} ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  VERBATIM)
target_sources(prehend_report PRIVATE ${page_source})
# So that checks of the sources do without it.
set_source_files_properties(${page_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# The page is one string literal of a megabyte, which clang -Wpedantic finds too long.
set_source_files_properties(${page_source} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)

# Puts a page into a library: its page.html with its style, its scripts, those that all pages share
# and three.js put in, as the text that a function named FUNCTION of namespace prehend returns.
#
#   prehend_embed_page(LIBRARY FOLDER FUNCTION CONTROL...)
#
# The controls are those scripts of three.js beside its core that the page uses.
set(prehend_shared_page ${CMAKE_CURRENT_LIST_DIR})

function(prehend_embed_page library folder function)
  set(page_dir ${PROJECT_SOURCE_DIR}/${folder})
  file(GLOB page_parts CONFIGURE_DEPENDS ${page_dir}/* ${prehend_shared_page}/*.js)
  set(three_scripts ${THREE_JS_DIR}/build/three.min.js)
  foreach(control IN LISTS ARGN)
    list(APPEND three_scripts ${THREE_JS_DIR}/examples/js/controls/${control}.js)
  endforeach()
  set(page_source ${PROJECT_BINARY_DIR}/${function}.cpp)
  add_custom_command(OUTPUT ${page_source}
    COMMAND ${CMAKE_COMMAND} -D PAGE_DIR=${page_dir} -D SHARED_DIR=${prehend_shared_page}
      "-DTHREE_SCRIPTS=${three_scripts}" -D FUNCTION=${function} -D OUTPUT=${page_source}
      -P ${prehend_shared_page}/embed_page.cmake
    DEPENDS ${page_parts} ${three_scripts} ${prehend_shared_page}/embed_page.cmake
    VERBATIM)
  target_sources(${library} PRIVATE ${page_source})
  # So that checks of the sources do without it.
  set_source_files_properties(${page_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  # The page is one string literal of a megabyte, which clang -Wpedantic finds too long.
  set_source_files_properties(${page_source} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
endfunction()

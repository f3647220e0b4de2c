# Installs the package, moves it, and uses it in projects of their own: the README's example with the
# component `quality` alone, that of docs/how-to/cpp.md and a program that uses every part with all of it.
cmake_minimum_required(VERSION 3.25)
set(examples ${SOURCE}/tests/package)
set(folder ${BUILD}/package_test)
file(REMOVE_RECURSE ${folder})

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# An example is shown as it is compiled.
function(expect_shown document language file)
  file(READ ${SOURCE}/${document} shown)
  file(READ ${file} text)
  string(FIND "${shown}" "```${language}\n${text}```\n" at)
  if(at EQUAL -1)
    message(SEND_ERROR "${document} does not show ${file} as it is")
  endif()
endfunction()

# Installed, then moved: no file may depend on where it was installed.
function(install_moved prefix)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/before ${ARGN})
  file(RENAME ${folder}/before ${prefix})
endfunction()

function(build_example name prefix)
  run(${CMAKE_COMMAND} -S ${examples}/${name} -B ${folder}/${name} -G ${GENERATOR}
    -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=Release ${ARGN}
    "-D CMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
  run(${CMAKE_COMMAND} --build ${folder}/${name})
endfunction()

# Nothing of the source tree, of the build folder or of our own warnings may reach a user.
function(expect_no_source_paths prefix)
  file(GLOB_RECURSE installed ${prefix}/*)
  foreach(file IN LISTS installed)
    # Binaries as well: what is text in them.
    file(STRINGS ${file} naming REGEX "${SOURCE}/|${BUILD}|${folder}")
    if(naming)
      message(SEND_ERROR "${file} names the source tree: ${naming}")
    endif()
  endforeach()
  file(GLOB_RECURSE exported ${prefix}/*.cmake)
  foreach(file IN LISTS exported)
    file(STRINGS ${file} warnings REGEX "-Werror|-Wall")
    if(warnings)
      message(SEND_ERROR "${file} names warnings")
    endif()
  endforeach()
endfunction()

# A contents page lists what it includes, and no other file.
function(expect_table_of_contents prefix page)
  file(STRINGS ${prefix}/include/prehend/${page} includes REGEX "^#include <prehend/")
  file(STRINGS ${prefix}/include/prehend/${page} table REGEX "^//   [a-z_]+\\.h ")
  list(TRANSFORM includes REPLACE "^.*/([a-z_]+\\.h)>$" "\\1")
  list(TRANSFORM table REPLACE "^//   ([a-z_]+\\.h) .*$" "\\1")
  list(REMOVE_ITEM includes eigen_alignment.h)
  list(SORT includes)
  list(SORT table)
  if(NOT includes STREQUAL table)
    message(SEND_ERROR "${page} includes ${includes}\nbut lists ${table}")
  endif()
endfunction()

# Eigen and the standard library are all that a user's compiler has to find. Fills `headers`.
function(expect_no_other_headers prefix)
  file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*.h)
  foreach(header IN LISTS headers)
    file(STRINGS ${prefix}/include/${header} includes REGEX "^ *#include ")
    foreach(line IN LISTS includes)
      if(NOT line MATCHES "^#include <(prehend/[a-z_/]+\\.h|Eigen/[A-Z][a-z]+|[a-z_]+)>$")
        message(SEND_ERROR "${header}: ${line}")
      endif()
    endforeach()
  endforeach()
  set(headers ${headers} PARENT_SCOPE)
endfunction()

function(expect_same one other)
  file(READ ${one} first)
  file(READ ${other} second)
  if(NOT first STREQUAL second)
    message(SEND_ERROR "${one} and ${other} differ")
  endif()
endfunction()

# --- prehend::quality ---------------------------------------------------------------------------------
set(prefix ${folder}/quality_only)
expect_shown(docs/how-to/cpp.md cpp ${examples}/quality/main.cpp)
expect_shown(docs/how-to/cpp.md cmake ${examples}/quality/CMakeLists.txt)
install_moved(${prefix} --component quality)
if(EXISTS ${prefix}/bin OR EXISTS ${prefix}/share/prehend)
  message(SEND_ERROR "the component quality installs more than that")
endif()
expect_no_source_paths(${prefix})
expect_no_other_headers(${prefix})
expect_table_of_contents(${prefix} quality.h)
build_example(quality ${prefix})
run(${folder}/quality/hold)
message("${output}")

# Three contacts with friction 0.5 bear a third of 3 N each: they press with 2 N.
string(REGEX MATCH "epsilon from (0\\.[0-9]+) to (0\\.[0-9]+)\nlargest normal force ([0-9.]+) N\n" found
  "${output}")
if(NOT found OR CMAKE_MATCH_1 GREATER CMAKE_MATCH_2 OR CMAKE_MATCH_1 EQUAL 0
    OR CMAKE_MATCH_3 LESS 1.9999 OR CMAKE_MATCH_3 GREATER 2.0001)
  message(SEND_ERROR "the example's output is not what was expected")
endif()

# --- prehend::prehend ---------------------------------------------------------------------------------
set(prefix ${folder}/everything)
expect_shown(docs/how-to/cpp.md cpp ${examples}/library/main.cpp)
expect_shown(docs/how-to/cpp.md cmake ${examples}/library/CMakeLists.txt)
install_moved(${prefix})
expect_no_source_paths(${prefix})
expect_no_other_headers(${prefix})
foreach(page prehend.h simulation.h contacts.h)
  expect_table_of_contents(${prefix} ${page})
endforeach()
build_example(library ${prefix})
run(${CMAKE_COMMAND} -E chdir ${folder}/library ${folder}/library/grasps)
message("${output}")
if(NOT output MATCHES "^epsilon 0\\.[0-9]+, [0-9]+ contacts, hand at "
    OR NOT output MATCHES " met (flour|rice)\n" OR NOT EXISTS ${folder}/library/report.html)
  message(SEND_ERROR "the example's output is not what was expected")
endif()

list(JOIN headers "\\;" headers)
build_example(all ${prefix} "-D HEADERS=${headers}")
file(MAKE_DIRECTORY ${folder}/written)
run(${folder}/all/all_parts ${folder}/written)
foreach(name report.html grasps.csv path_1.csv grasps_isaac.yaml grasps_moveit.yaml grasp_1.glb)
  if(NOT EXISTS ${folder}/written/${name})
    message(SEND_ERROR "${name} was not written")
  endif()
endforeach()

# The library and the program that is installed with it say the same.
run(${prefix}/bin/prehend plan mug --no-report --out ${folder}/program)
expect_same(${folder}/program/grasps.json ${folder}/written/grasps.json)

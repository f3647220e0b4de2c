# The includes of sim, primitives and planner follow the libraries of CMakeLists.txt: a file includes
# headers of its own folder and of those folders whose libraries its own links to, directly or through
# others.
#   cmake -DSOURCE=... -DROOMS=... -P folders_test.cmake
# ROOMS: a file with one line a library, "FOLDER: FOLDER FOLDER ...", the folder of the library and
# those of all libraries that it links to. Folders that this build leaves out have no line but their
# name among those of LEFT_OUT.
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${ROOMS} rooms)
set(folders)
foreach(room IN LISTS rooms)
  string(REGEX MATCH "^([^:]+): *(.*)$" ignored "${room}")
  list(APPEND folders ${CMAKE_MATCH_1})
  string(REPLACE " " ";" below_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
endforeach()

set(wrong 0)
set(seen 0)
file(GLOB_RECURSE files RELATIVE ${SOURCE}
  ${SOURCE}/sim/*.h ${SOURCE}/sim/*.cpp ${SOURCE}/primitives/*.h ${SOURCE}/primitives/*.cpp
  ${SOURCE}/planner/*.h ${SOURCE}/planner/*.cpp)
foreach(file IN LISTS files)
  get_filename_component(folder ${file} DIRECTORY)
  if(folder IN_LIST LEFT_OUT)
    continue()
  endif()
  if(NOT folder IN_LIST folders)
    message(SEND_ERROR "${file}: no library has this folder")
    math(EXPR wrong "${wrong} + 1")
    continue()
  endif()
  file(STRINGS ${SOURCE}/${file} includes REGEX "^#include \"(sim|primitives|planner)/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)/[^/]*\".*$" "\\1" other "${include}")
    math(EXPR seen "${seen} + 1")
    if(NOT other STREQUAL folder AND NOT other IN_LIST below_${folder})
      message(SEND_ERROR "${file}: the library of ${folder} does not link to that of ${other}: ${include}")
      math(EXPR wrong "${wrong} + 1")
    endif()
  endforeach()
endforeach()
if(seen EQUAL 0)
  message(FATAL_ERROR "no include was found in ${SOURCE}")
endif()
if(wrong GREATER 0)
  message(FATAL_ERROR "${wrong} includes of ${seen} break the folders of CMakeLists.txt")
endif()

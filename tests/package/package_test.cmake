# Installs the package, builds the README's example against it and runs that.
cmake_minimum_required(VERSION 3.25)
set(example ${SOURCE}/tests/package/consumer)
set(folder ${BUILD}/package_test)
set(prefix ${folder}/installed)
file(REMOVE_RECURSE ${folder})

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${status}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_in_readme language file)
  file(READ ${SOURCE}/README.md readme)
  file(READ ${file} text)
  string(FIND "${readme}" "```${language}\n${text}```\n" at)
  if(at EQUAL -1)
    message(SEND_ERROR "README.md does not show ${file} as it is")
  endif()
endfunction()
expect_in_readme(cpp ${example}/main.cpp)
expect_in_readme(cmake ${example}/CMakeLists.txt)

run(${CMAKE_COMMAND} --install ${BUILD} --component quality --prefix ${prefix})

# Nothing of the source tree or of our own warnings may reach a user.
file(GLOB_RECURSE exported ${prefix}/*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  string(FIND "${text}" "${SOURCE}" at)
  if(NOT at EQUAL -1 OR text MATCHES "-Werror|-Wall")
    message(SEND_ERROR "${file} names the source tree or warnings")
  endif()
endforeach()

# quality.h is the table of contents of what is installed.
file(GLOB headers RELATIVE ${prefix}/include/prehend ${prefix}/include/prehend/sim/quality/*.h)
list(REMOVE_ITEM headers sim/quality/quality.h)
file(READ ${prefix}/include/prehend/sim/quality/quality.h umbrella)
foreach(header IN LISTS headers)
  string(FIND "${umbrella}" "#include \"${header}\"" included)
  cmake_path(GET header FILENAME name)
  string(FIND "${umbrella}" "//   ${name} " listed)
  if(included EQUAL -1 OR listed EQUAL -1)
    message(SEND_ERROR "quality.h neither lists and includes ${header}, nor does package.cmake name "
      "it as internal")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${example} -B ${folder}/build -G ${GENERATOR}
  -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=Release
  "-D CMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror")
run(${CMAKE_COMMAND} --build ${folder}/build)
run(${folder}/build/hold)
message("${output}")

# Three contacts with friction 0.5 bear a third of 3 N each: they press with 2 N.
string(REGEX MATCH "epsilon from (0\\.[0-9]+) to (0\\.[0-9]+)\nlargest normal force ([0-9.]+) N\n" found
  "${output}")
if(NOT found OR CMAKE_MATCH_1 GREATER CMAKE_MATCH_2 OR CMAKE_MATCH_1 EQUAL 0
    OR CMAKE_MATCH_3 LESS 1.9999 OR CMAKE_MATCH_3 GREATER 2.0001)
  message(SEND_ERROR "the example's output is not what was expected")
endif()

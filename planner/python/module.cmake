# The Python package prehend: the extension module prehend._core beside the files in prehend/. In the
# build folder it stands in python/, so that PYTHONPATH=build/release/python is enough to import it.
# Only the targets prehend_python and all build it; without pybind11 there is no such target.
set(PREHEND_PYTHON /usr/bin/python3 CACHE FILEPATH
  "The Python that the module is for: the system's, whose NumPy it uses, not the first on the PATH")
if(PREHEND_SANITIZE)  # Python itself would have to be built for them
  return()
endif()
if(EXISTS ${PREHEND_PYTHON})
  set(Python3_EXECUTABLE ${PREHEND_PYTHON})
  find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
endif()
if(Python3_FOUND)
  find_package(pybind11 2.10 QUIET)
endif()
if(NOT pybind11_FOUND)
  return()
endif()

file(GLOB python_sources CONFIGURE_DEPENDS planner/python/*.cpp)
# NO_EXTRAS: no link-time optimisation, which takes long and would treat the planner's code, all in
# libraries that are compiled already, as it is anyway.
pybind11_add_module(prehend_python MODULE NO_EXTRAS ${python_sources})
target_link_libraries(prehend_python PRIVATE prehend_report prehend_exports prehend_truth)
target_compile_features(prehend_python PRIVATE cxx_std_20)
target_compile_definitions(prehend_python PRIVATE PREHEND_VERSION="${PROJECT_VERSION}")
target_precompile_headers(prehend_python PRIVATE
  <pybind11/pybind11.h> <pybind11/numpy.h> <pybind11/stl.h> <Eigen/Geometry>)
# As in prehend_library.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
  target_compile_options(prehend_python PRIVATE
    -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
endif()
# The planner inside keeps to itself: another extension may bring another version of it.
target_link_options(prehend_python PRIVATE LINKER:--exclude-libs,ALL)

# What is Python already is linked to, not copied: changes need no build.
set(python_package ${PROJECT_BINARY_DIR}/python/prehend)
set_target_properties(prehend_python PROPERTIES
  OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${python_package})
file(GLOB python_files CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/planner/python
  planner/python/prehend/*.py planner/python/prehend/*.pyi planner/python/prehend/py.typed)
# The stub has the classes of options, which are made from their declarations in C++.
set(python_stub planner/python/prehend/_core.pyi)
list(REMOVE_ITEM python_files prehend/_core.pyi)
file(MAKE_DIRECTORY ${python_package})
# Links of an earlier configuration to files that are gone since.
file(GLOB earlier_links ${python_package}/*.py ${python_package}/py.typed)
if(earlier_links)
  file(REMOVE ${earlier_links})
endif()
file(RELATIVE_PATH python_folder ${python_package} ${PROJECT_SOURCE_DIR}/planner/python/prehend)
foreach(file IN LISTS python_files)
  cmake_path(GET file FILENAME name)
  file(CREATE_LINK ${python_folder}/${name} ${python_package}/${name} SYMBOLIC)
endforeach()

set_property(TARGET prehend_python APPEND PROPERTY LINK_DEPENDS
  ${PROJECT_SOURCE_DIR}/planner/python/write_stub.py ${PROJECT_SOURCE_DIR}/${python_stub})
add_custom_command(TARGET prehend_python POST_BUILD VERBATIM
  COMMAND ${PREHEND_PYTHON} -B ${PROJECT_SOURCE_DIR}/planner/python/write_stub.py
    ${PROJECT_SOURCE_DIR}/${python_stub} ${python_package}/_core.pyi)

# Debian's Python looks there below /usr/local, the default prefix.
set(PREHEND_PYTHON_DIR lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages
  CACHE STRING "Where the Python package is installed, relative to the prefix")
list(TRANSFORM python_files PREPEND planner/python/)
function(prehend_install_python component folder)
  install(TARGETS prehend_python LIBRARY DESTINATION ${folder}/prehend
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${python_files} ${python_package}/_core.pyi DESTINATION ${folder}/prehend
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()
prehend_install_python(python ${PREHEND_PYTHON_DIR})
# Where Debian's packages of Python have their files, below /usr.
prehend_install_python(python_of_debian lib/python3/dist-packages)
# What is found by name. The component prehend (package/package.cmake) installs the same files.
include(GNUInstallDirs)
install(DIRECTORY robots benchmarks/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/prehend
  COMPONENT python EXCLUDE_FROM_ALL)

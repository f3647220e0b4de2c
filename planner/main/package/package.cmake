# Installs prehend as the CMake package `prehend`, in two components:
#   quality   the target prehend::quality: sim/quality with what is below it, static libraries. Needs
#             Eigen and qhull only, and nothing else has to be built
#   prehend   the target prehend::prehend: all rooms as one shared library; the program, robots and
#             scenes
# cmake --install build/release [--component quality] --prefix FOLDER. The folder can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# All rooms in one library: their objects, not what a linker would take from their archives. The
# program is linked to the rooms themselves, so that it runs alone.
get_property(rooms GLOBAL PROPERTY prehend_rooms)
list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
add_library(prehend_shared SHARED planner/prehend.cpp ${objects})
set_target_properties(prehend_shared PROPERTIES OUTPUT_NAME prehend EXPORT_NAME prehend
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_definitions(prehend_shared PRIVATE PREHEND_VERSION="${PROJECT_VERSION}")
target_compile_features(prehend_shared PUBLIC cxx_std_20)
target_include_directories(prehend_shared INTERFACE $<INSTALL_INTERFACE:include>)
# The rooms again, for the libraries that they stand on.
target_link_libraries(prehend_shared PRIVATE ${rooms} PUBLIC Eigen3::Eigen)
# The library calls its own functions directly, as its files were compiled to expect.
target_link_options(prehend_shared PRIVATE LINKER:-Bsymbolic-functions LINKER:--no-undefined)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/prehend)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/prehendConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)

# Headers: the contents pages (the arguments behind `component`), what they include, and what these
# include.
function(prehend_install_headers component)
  install(CODE "
    set(source [[${PROJECT_SOURCE_DIR}]])
    set(pages ${ARGN})
    set(written [[${PROJECT_BINARY_DIR}/installed_headers/${component}]])
    set(destination [[include]])" COMPONENT ${component})
  install(SCRIPT planner/main/package/install_headers.cmake COMPONENT ${component})
endfunction()

function(prehend_install_component component)
  install(EXPORT prehend_${component} NAMESPACE prehend:: FILE prehend-${component}.cmake
    DESTINATION ${package_folder} COMPONENT ${component})
  install(FILES planner/main/package/prehendConfig.cmake ${PROJECT_BINARY_DIR}/prehendConfigVersion.cmake
    DESTINATION ${package_folder} COMPONENT ${component})
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT ${component})
endfunction()

foreach(room base conic quality)
  set_target_properties(prehend_${room} PROPERTIES EXPORT_NAME ${room})
  install(TARGETS prehend_${room} EXPORT prehend_quality COMPONENT quality)
endforeach()
prehend_install_headers(quality sim/quality/quality.h)
prehend_install_component(quality)

install(TARGETS prehend_shared EXPORT prehend_prehend COMPONENT prehend)
install(TARGETS ${prehend_programs} COMPONENT prehend)
install(FILES planner/main/package/prehend.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT prehend)
install(FILES planner/main/package/completion.bash RENAME prehend
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT prehend)
install(DIRECTORY robots DESTINATION ${CMAKE_INSTALL_DATADIR}/prehend COMPONENT prehend)
install(DIRECTORY benchmarks/scenes benchmarks/protocols DESTINATION ${CMAKE_INSTALL_DATADIR}/prehend COMPONENT prehend)
prehend_install_headers(prehend planner/prehend.h planner/simulation.h planner/contacts.h)
prehend_install_component(prehend)

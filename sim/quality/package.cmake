# Installs sim/quality, with sim/conic and sim/base below it, as the CMake package `prehend`:
#   cmake --install build/release --component quality --prefix FOLDER
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/prehend)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/prehendConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)

set_target_properties(prehend_base PROPERTIES EXPORT_NAME base)
set_target_properties(prehend_conic PROPERTIES EXPORT_NAME conic)
set_target_properties(prehend_quality PROPERTIES EXPORT_NAME quality)
install(TARGETS prehend_base prehend_conic prehend_quality EXPORT prehend COMPONENT quality)
install(EXPORT prehend NAMESPACE prehend:: FILE prehendTargets.cmake
  DESTINATION ${package_folder} COMPONENT quality)
install(FILES sim/quality/prehendConfig.cmake ${PROJECT_BINARY_DIR}/prehendConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT quality)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT quality)

# What is not named here is public, and quality.h includes it.
set(internal_headers
  cone_scaling conic_presolve interior_point kkt_system
  expanding_polytope force_program hyperplane start_simplex wrench_size)
list(JOIN internal_headers "|" internal_headers)
install(DIRECTORY sim/base sim/conic sim/quality DESTINATION include/prehend/sim
  COMPONENT quality
  FILES_MATCHING PATTERN "*.h" REGEX "/(${internal_headers})\\.h$" EXCLUDE)

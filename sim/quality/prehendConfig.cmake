include(CMakeFindDependencyMacro)
find_dependency(Eigen3 CONFIG)
find_dependency(Qhull CONFIG)
include(${CMAKE_CURRENT_LIST_DIR}/prehendTargets.cmake)

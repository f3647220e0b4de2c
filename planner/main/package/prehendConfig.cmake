# find_package(prehend REQUIRED [COMPONENTS quality prehend]); without components, those that are
# installed.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 CONFIG)

if(NOT prehend_FIND_COMPONENTS)
  foreach(component quality prehend)
    if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/prehend-${component}.cmake)
      list(APPEND prehend_FIND_COMPONENTS ${component})
    endif()
  endforeach()
endif()
if("quality" IN_LIST prehend_FIND_COMPONENTS)
  find_dependency(Qhull CONFIG)
endif()
foreach(component IN LISTS prehend_FIND_COMPONENTS)
  include(${CMAKE_CURRENT_LIST_DIR}/prehend-${component}.cmake
    OPTIONAL RESULT_VARIABLE prehend_${component}_FOUND)
  if(NOT prehend_${component}_FOUND)
    set(prehend_FOUND FALSE)
    set(prehend_NOT_FOUND_MESSAGE "the component ${component} is not installed here")
  endif()
endforeach()

# The Debian package: all components and the Python module in one (./run package, or cpack in the
# build folder once the targets programs, prehend_shared, prehend_quality and prehend_python are built).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL prehend quality)
if(TARGET prehend_python)
  list(APPEND CPACK_COMPONENTS_ALL python_of_debian)
endif()
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_NAME prehend)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The authors of prehend <prehend@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Depends: what the binaries are linked to. The headers need Eigen, the static library of the quality
# measures qhull, the Python module NumPy and the Python that it was compiled for.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libqhull-dev, bash-completion")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
include(CPack)

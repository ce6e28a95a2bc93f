# Installation of the tool, the libraries and the public headers, and the Debian package.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY PERCUSS_LAYERS)
# Programs link percuss::percuss, which links the libraries of the layers.
set_target_properties(percuss_api PROPERTIES EXPORT_NAME percuss)
target_include_directories(percuss_api PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS ${layers} EXPORT percussTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/percuss DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/percuss)
install(EXPORT percussTargets NAMESPACE percuss:: DESTINATION ${package_dir})
configure_package_config_file(cmake/percussConfig.cmake.in ${PROJECT_BINARY_DIR}/percussConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/percussConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/percussConfig.cmake ${PROJECT_BINARY_DIR}/percussConfigVersion.cmake
        DESTINATION ${package_dir})

# Debian looks for the licence in a file called copyright.
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES third_party/uplot/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright.uplot)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "*.json")

# The package percuss depends on the run-time libraries of the tool, and suggests the packages that are needed to link
# percuss. A build with PERCUSS_PYTHON also makes the package python3-percuss, for every Python 3 of Debian.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME percuss)
set(CPACK_PACKAGE_CONTACT "percuss maintainers <percuss@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME percuss)
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-percuss)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}: Python module")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS libportaudio2) # loaded when a sound card is used
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS
    "libfftw3-dev, libgsl-dev, libtbb-dev, libfmt-dev, libhdf5-dev, libmatio-dev, libsndfile1-dev, libseccomp-dev, libssl-dev, zlib1g-dev, pkg-config")
include(CPack)

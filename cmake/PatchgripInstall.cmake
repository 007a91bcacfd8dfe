# Install tree with find_package(patchgrip), and the Debian package that `cpack -G DEB` makes of it.
include(CMakePackageConfigHelpers)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/patchgrip)
configure_package_config_file(cmake/patchgripConfig.cmake.in ${PROJECT_BINARY_DIR}/patchgripConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/patchgripConfigVersion.cmake COMPATIBILITY SameMinorVersion)

install(FILES ${PROJECT_BINARY_DIR}/patchgripConfig.cmake ${PROJECT_BINARY_DIR}/patchgripConfigVersion.cmake
        DESTINATION ${config_dir})
install(EXPORT patchgripTargets NAMESPACE patchgrip:: DESTINATION ${config_dir})
install(FILES ${PATCHGRIP_GENERATED_DIR}/patchgrip/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/patchgrip)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY data/scenes data/materials DESTINATION ${CMAKE_INSTALL_DATADIR}/patchgrip)

if(NOT PROJECT_IS_TOP_LEVEL)
  return() # the package is that of the project above
endif()
set(CPACK_PACKAGE_CONTACT "patchgrip maintainers <patchgrip@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libboost-dev, libcgal-dev, libeigen3-dev, libfftw3-dev, pkgconf")
set(CPACK_STRIP_FILES ON)
include(CPack)

# Makes the Debian package of BUILD_DIR, looks into it, unpacks it and runs the program from there.
set(work ${BUILD_DIR}/tests/install/package)
file(REMOVE_RECURSE ${work})

execute_process(COMMAND ${CPACK} -G DEB --config ${BUILD_DIR}/CPackConfig.cmake -B ${work} OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package ${work}/*.deb)

execute_process(COMMAND dpkg-deb --field ${package} OUTPUT_VARIABLE control COMMAND_ERROR_IS_FATAL ANY)
set(depends "Depends: [^\n]*")
foreach(field "Package: patchgrip" "Version: ${VERSION}" "${depends}libc6" "${depends}libcgal-dev" "${depends}libfftw3-dev" "${depends}libtoml")
  if(NOT control MATCHES "${field}")
    message(FATAL_ERROR "${package} lacks the field '${field}':\n${control}")
  endif()
endforeach()

execute_process(COMMAND dpkg-deb --extract ${package} ${work}/unpacked COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files RELATIVE ${work}/unpacked ${work}/unpacked/*)
foreach(file bin/patchgrip include/patchgrip/version.h include/patchgrip/contact/material.h
             include/patchgrip/friction/hertz_disc.h lib.*/libpatchgrip_friction.a lib.*/cmake/patchgrip/patchgripConfig.cmake
             share/doc/patchgrip/copyright share/patchgrip/materials/.*.toml share/patchgrip/scenes/.*.toml)
  if(NOT "${files}" MATCHES "usr/${file}")
    message(FATAL_ERROR "${package} lacks usr/${file}:\n${files}")
  endif()
endforeach()

execute_process(COMMAND ${work}/unpacked/usr/bin/patchgrip --version OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed MATCHES "${VERSION}")
  message(FATAL_ERROR "patchgrip --version printed '${printed}'")
endif()

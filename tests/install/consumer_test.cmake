# Installs BUILD_DIR into an empty prefix, then configures, builds and runs a consumer that knows nothing but the
# prefix.
set(work ${BUILD_DIR}/tests/install/consumer)
file(REMOVE_RECURSE ${work})

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${work}/prefix OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE exported ${work}/prefix/*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  if(text MATCHES "${SOURCE_DIR}/(contact|friction|grasp|dynamics|build)")
    message(FATAL_ERROR "${file} points into the source tree")
  endif()
endforeach()

execute_process(
  COMMAND ${CMAKE_COMMAND} -G Ninja -S ${SOURCE_DIR}/tests/install/consumer -B ${work}/build
          -DCMAKE_PREFIX_PATH=${work}/prefix -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_FLAGS=${CXX_FLAGS}
          -DCMAKE_CXX_COMPILER=${CXX_COMPILER} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${work}/build COMMAND_ERROR_IS_FATAL ANY)

function(expect program text)
  execute_process(COMMAND ${work}/build/${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  if(NOT printed MATCHES "^${text}$")
    message(FATAL_ERROR "${program} printed something else than expected:\n${printed}")
  endif()
endfunction()

# mu F_N f(1/sqrt 2) / sqrt 2 and mu F_N m(1/sqrt 2), from the polynomials of the Hertz disc.
set(error "[0-9.e-]+")
expect(grip "force \\(-0\\.618501, 0\\.618501\\) N \\+- ${error}\nmoment -0\\.000839394 N m \\+- ${error}\n")
expect(gauge "friction must hold 5\\.24863 N, else it slips about \\(-0\\.00391836, 0\\.00384843\\) m\n")
expect(press "contact radius 0\\.00195743 m\n")
expect(polygon "area radius 0\\.56419 m\n")

# A project that takes patchgrip as a folder gets its libraries, and neither the program nor anything that serves it.
set(work ${BUILD_DIR}/tests/install/subproject)
file(REMOVE_RECURSE ${work})

execute_process(
  COMMAND ${CMAKE_COMMAND} -G Ninja -S ${SOURCE_DIR}/tests/install/subproject -B ${work} -DPATCHGRIP=${SOURCE_DIR}
          -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_BUILD_TYPE=Release OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${work} --target help OUTPUT_VARIABLE targets COMMAND_ERROR_IS_FATAL ANY)
foreach(target contact friction)
  if(NOT targets MATCHES "\n *libpatchgrip_${target}.a: ")
    message(FATAL_ERROR "no libpatchgrip_${target}.a:\n${targets}")
  endif()
endforeach()
foreach(target test_ figure patchgrip_cli tidy package gauge_fit)
  if(targets MATCHES "[/\n ]${target}")
    message(FATAL_ERROR "a target ${target} is in the way of a project above:\n${targets}")
  endif()
endforeach()

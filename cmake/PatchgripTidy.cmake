# Target `tidy`: clang-tidy with the checks of .clang-tidy over every source that this build compiles. Clang does not
# read the precompiled headers of another compiler: it gets the commands without them.
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
mark_as_advanced(RUN_CLANG_TIDY)
if(RUN_CLANG_TIDY)
  set(commands ${PROJECT_BINARY_DIR}/tidy)
  add_custom_target(
    tidy
    COMMAND ${CMAKE_COMMAND} -E make_directory ${commands}
    COMMAND sed "s/-Winvalid-pch -include [^ ]*cmake_pch.hxx//" ${PROJECT_BINARY_DIR}/compile_commands.json >
            ${commands}/compile_commands.json
    COMMAND ${RUN_CLANG_TIDY} -quiet -extra-arg=-Wno-unknown-warning-option -p ${commands}
            "${PROJECT_SOURCE_DIR}/(contact|friction|grasp|dynamics|cli|bench|tests)/"
    USES_TERMINAL VERBATIM)
endif()

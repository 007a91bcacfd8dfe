# Target `tidy`: clang-tidy with the checks of .clang-tidy over every source that this build compiles.
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
mark_as_advanced(RUN_CLANG_TIDY)
if(RUN_CLANG_TIDY)
  add_custom_target(
    tidy
    COMMAND ${RUN_CLANG_TIDY} -quiet -extra-arg=-Wno-unknown-warning-option -p ${PROJECT_BINARY_DIR}
            "${PROJECT_SOURCE_DIR}/(contact|friction|cli|bench|tests)/"
    USES_TERMINAL)
endif()

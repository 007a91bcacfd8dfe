# One folder, one target, one namespace. The functions here make targets that are alike.
#
#   patchgrip_library(<folder> SOURCES ... HEADERS ... [CGAL_SOURCES ...] [PUBLIC libs...] [PRIVATE libs...] [INTERNAL])
#   patchgrip_library(<name> FOLDER <folder> ...)    an optional part of a folder, with what only it needs
#   patchgrip_program(<name> SOURCES ... [LIBS libs...] [INSTALL])
#   patchgrip_test(<folder>/<name> [SOURCES <name>.cc ...] [LIBS libs...] [TIMEOUT seconds])
#
# Headers are included as <patchgrip/folder/header.h> before and after installation: include/patchgrip in the build tree
# is a symbolic link to the source tree. An INTERNAL library is not installed: it is there for a program and its tests.

set(PATCHGRIP_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
set(PATCHGRIP_GENERATED_DIR ${PROJECT_BINARY_DIR}/include-generated)
file(MAKE_DIRECTORY ${PATCHGRIP_INCLUDE_DIR})
file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${PATCHGRIP_INCLUDE_DIR}/patchgrip SYMBOLIC)
configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${PATCHGRIP_GENERATED_DIR}/patchgrip/version.h @ONLY)

if(PROJECT_IS_TOP_LEVEL)
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  set(CMAKE_VERIFY_INTERFACE_HEADER_SETS ON)
  find_program(CCACHE ccache)
  mark_as_advanced(CCACHE)
  if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
  endif()
  if(CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)  # a launcher keeps whole objects, but none that were made with them
  endif()
endif()

set(PATCHGRIP_TEST_SEED 1 CACHE STRING "Seed of the property tests; empty draws a new one in every run")

add_library(patchgrip_flags INTERFACE)
target_compile_features(patchgrip_flags INTERFACE cxx_std_20)
target_compile_options(
  patchgrip_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                            $<$<CONFIG:Release>:-fno-math-errno;-fno-trapping-math>)

# Tests try the library as it is built for users; their own code need not be fast, and compiles in half the time.
add_library(patchgrip_test_flags INTERFACE)
target_compile_options(patchgrip_test_flags INTERFACE $<$<CONFIG:Release>:-Og>)
target_link_libraries(patchgrip_test_flags INTERFACE patchgrip_flags)

function(patchgrip_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "INTERNAL" "FOLDER" "SOURCES;HEADERS;CGAL_SOURCES;PUBLIC;PRIVATE")
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${name})
  endif()
  set(target patchgrip_${name})
  add_library(${target} STATIC ${arg_SOURCES})
  add_library(patchgrip::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)

  list(TRANSFORM arg_HEADERS PREPEND ${PATCHGRIP_INCLUDE_DIR}/patchgrip/${arg_FOLDER}/)
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PATCHGRIP_INCLUDE_DIR} FILES ${arg_HEADERS})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PATCHGRIP_GENERATED_DIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(
    ${target}
    PUBLIC ${arg_PUBLIC}
    PRIVATE $<BUILD_INTERFACE:patchgrip_flags> ${arg_PRIVATE})

  # CGAL asks for -frounding-math: only the files that include it are compiled so; users of the library just link GMP
  # and MPFR.
  if(arg_CGAL_SOURCES)
    add_library(${target}_cgal OBJECT ${arg_CGAL_SOURCES})
    set_target_properties(${target}_cgal PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
    target_include_directories(${target}_cgal PRIVATE ${PATCHGRIP_INCLUDE_DIR} ${PATCHGRIP_GENERATED_DIR})
    target_link_libraries(${target}_cgal PRIVATE patchgrip_flags CGAL::CGAL ${arg_PUBLIC} ${arg_PRIVATE})
    # False alarms inlined from CGAL's headers.
    target_compile_options(${target}_cgal PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_cgal>)
    target_link_libraries(${target} INTERFACE $<LINK_ONLY:CGAL::CGAL>)
  endif()

  if(NOT arg_INTERNAL)
    install(
      TARGETS ${target}
      EXPORT patchgripTargets
      ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
      FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
endfunction()

function(patchgrip_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "INSTALL" "" "SOURCES;LIBS")
  add_executable(${name} ${arg_SOURCES})
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  target_link_libraries(${name} PRIVATE patchgrip_flags ${arg_LIBS})
  if(arg_INSTALL)
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endfunction()

function(patchgrip_test path)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "SOURCES;LIBS")
  cmake_path(GET path PARENT_PATH folder)
  cmake_path(GET path FILENAME name)
  if(NOT arg_SOURCES)
    set(arg_SOURCES ${name}.cc)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  set(target test_${folder}_${name})
  add_executable(${target} ${arg_SOURCES})
  set_target_properties(
    ${target}
    PROPERTIES CXX_EXTENSIONS OFF
               OUTPUT_NAME ${name}
               RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/${folder})
  target_compile_definitions(${target} PRIVATE PATCHGRIP_DATA_DIR="${PROJECT_SOURCE_DIR}/data")
  if(TARGET patchgrip::${folder})
    list(PREPEND arg_LIBS patchgrip::${folder})
  endif()
  target_link_libraries(${target} PRIVATE patchgrip_test_flags ${arg_LIBS} rapidcheck GTest::gmock GTest::gtest_main)
  target_precompile_headers(${target} REUSE_FROM test_headers)
  set(environment)
  if(PATCHGRIP_TEST_SEED)
    set(environment ENVIRONMENT RC_PARAMS=seed=${PATCHGRIP_TEST_SEED})
  endif()
  gtest_discover_tests(
    ${target}
    TEST_PREFIX ${folder}.
    DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS ${folder} ${environment})
endfunction()

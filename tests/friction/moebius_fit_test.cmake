# The coefficients in the tree are what the fit writes, spaces and line breaks apart.
#   cmake -DPROGRAM=.../moebius_fit -DHEADER=.../moebius_coefficients.h -P moebius_fit_test.cmake
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE written COMMAND_ERROR_IS_FATAL ANY)
file(READ ${HEADER} kept)
string(REGEX REPLACE "[ \n]+" "" written "${written}")
string(REGEX REPLACE "[ \n]+" "" kept "${kept}")
if(NOT written STREQUAL kept)
  message(FATAL_ERROR "${HEADER} differs from the output of ${PROGRAM}: redirect the one to the other")
endif()

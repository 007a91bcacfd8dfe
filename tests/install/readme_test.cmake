# The C++ that README.md shows is the consumer that consumer_test.cmake compiles and runs.
file(READ ${SOURCE_DIR}/README.md readme)
file(READ ${SOURCE_DIR}/tests/install/consumer/main.cc code)
string(FIND "${readme}" "```cpp\n${code}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "README.md does not quote tests/install/consumer/main.cc, to the letter, in a block of its own (```cpp)")
endif()

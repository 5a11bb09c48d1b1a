# GoogleTest costs a second in every test source; all test programs share one precompiled copy of it.
include(GoogleTest)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/test_headers.cpp CONTENT "")
add_library(breakshot_test_headers OBJECT ${CMAKE_BINARY_DIR}/test_headers.cpp)
target_link_libraries(breakshot_test_headers PRIVATE breakshot_flags GTest::gtest)
target_precompile_headers(breakshot_test_headers PRIVATE <gtest/gtest.h> <algorithm> <optional>
                          <string> <variant> <vector>)

# breakshot_test(<room> [libraries...]): every *_test.cpp of the folder in one GoogleTest program.
function(breakshot_test room)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    breakshot_test_program(${room} "${sources}" ${ARGN})
  endif()
endfunction()

function(breakshot_test_program room sources)
  add_executable(${room}_test ${sources})
  target_link_libraries(${room}_test PRIVATE breakshot_flags ${ARGN} GTest::gtest GTest::gtest_main)
  target_precompile_headers(${room}_test REUSE_FROM breakshot_test_headers)
  gtest_discover_tests(${room}_test DISCOVERY_MODE PRE_TEST PROPERTIES
    TIMEOUT 600 LABELS ${room}
    ENVIRONMENT LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/leaks.supp:print_suppressions=0)
endfunction()

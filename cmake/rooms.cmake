# A room is a folder of sources and one library target breakshot_<room>; generated sources do without
# these warnings. What is switched off for g++ is what version 12 claims wrongly when it optimises: of
# every `"literal" + std::string` (PR 105651) and of every std::variant that is moved.
add_library(breakshot_flags INTERFACE)
target_include_directories(breakshot_flags INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(breakshot_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow;-Wno-maybe-uninitialized>"
  $<$<BOOL:${BREAKSHOT_WERROR}>:-Werror>)

# breakshot_room(<room> [rooms and libraries it is allowed to use...])
function(breakshot_room room)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(breakshot_${room} STATIC ${sources})
    target_link_libraries(breakshot_${room} PUBLIC breakshot_flags ${ARGN})
  else()
    add_library(breakshot_${room} INTERFACE)
    target_link_libraries(breakshot_${room} INTERFACE breakshot_flags ${ARGN})
  endif()
endfunction()

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

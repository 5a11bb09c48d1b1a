# A room is a folder of sources and one library target breakshot_<room>; generated sources do without
# these warnings. g++ 12 sees overlapping copies in every `"literal" + std::string` (PR 105651).
add_library(breakshot_flags INTERFACE)
target_include_directories(breakshot_flags INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(breakshot_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                       -Wconversion -Wno-sign-conversion
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
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

# breakshot_test(<room> [libraries...]): every *_test.cpp of the folder in one GoogleTest program.
function(breakshot_test room)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_executable(${room}_test ${sources})
    target_link_libraries(${room}_test PRIVATE breakshot_flags ${ARGN} GTest::gtest GTest::gtest_main)
    gtest_discover_tests(${room}_test DISCOVERY_MODE PRE_TEST
                         PROPERTIES TIMEOUT 600 LABELS ${room})
  endif()
endfunction()
include(GoogleTest)

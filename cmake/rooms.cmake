# A room is a folder of sources and one library target breakshot_<room>; generated sources do without
# these warnings. What is switched off for g++ is what version 12 claims wrongly when it optimises: of
# every `"literal" + std::string` (PR 105651) and of every std::variant that is moved.
add_library(breakshot_flags INTERFACE)
target_include_directories(breakshot_flags INTERFACE ${BREAKSHOT_ROOT})
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

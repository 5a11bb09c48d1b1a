# What every target is compiled with, whatever its room.

# The determinism contract, for the whole project: the same bits need the same rounding in every
# build type and from every compiler, so no product and sum may be contracted into one rounding.
# Neither -ffast-math nor -march=native may ever stand here.
add_compile_options(-ffp-contract=off)

# ccache is used where it is installed and missed nowhere. A precompiled header hides its macros and
# its time from ccache, which would refuse such files without these two allowances.
find_program(BREAKSHOT_CCACHE ccache)
if(BREAKSHOT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros ${BREAKSHOT_CCACHE})
endif()

# What every target is compiled with, whatever its room.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH BREAKSHOT_ROOT)

# The determinism contract, for the whole project: the same bits need the same rounding in every
# build type and from every compiler, so no product and sum may be contracted into one rounding.
# (That sqrt sets no errno and that no exception is trapped changes no bit: it lets sqrt be an
# instruction and comparisons be selections.) Neither -ffast-math nor -march=native may ever stand here.
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math)

# ccache is used where it is installed and missed nowhere. Paths below the source tree count as relative
# ones, so that a second clone or worktree finds what the first has compiled; and a precompiled header
# is refused by ccache without the allowances for its macros and its time.
find_program(BREAKSHOT_CCACHE ccache)
if(BREAKSHOT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_BASEDIR=${BREAKSHOT_ROOT} CCACHE_NOHASHDIR=true
      CCACHE_SLOPPINESS=pch_defines,time_macros ${BREAKSHOT_CCACHE})
endif()

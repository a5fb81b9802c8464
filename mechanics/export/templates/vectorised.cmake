# Says which functions of many states the compiler has vectorised, after each build of the library:
#
#   cmake -DSOURCE=NAME_batch.c -DREPORT=FILE -P vectorised.cmake
#
# REPORT is what gcc (-fopt-info-vec-optimized) or clang (optimisation records) wrote when it compiled
# SOURCE: both name the lines of the loops that they vectorised.
get_filename_component(file "${SOURCE}" NAME)
if(NOT EXISTS "${REPORT}")
  message(WARNING "${file}: the compiler does not tell whether it vectorised the loops over states")
  return()
endif()
file(READ "${REPORT}" report)
file(READ "${SOURCE}" text)
# Lines become a list: what would group or split its elements goes.
string(REGEX REPLACE "[][;\\]" "_" text "${text}")
string(REPLACE "\n" ";" lines "${text}")
set(number 0)
set(function "")
set(fast)
set(slow)
foreach(line IN LISTS lines)
  math(EXPR number "${number} + 1")
  if(line MATCHES "^static inline int ([a-zA-Z0-9_]+)_lanes\\(")
    set(function "${CMAKE_MATCH_1}")
  elseif(function AND line MATCHES "^    for \\(size_t ")
    if(report MATCHES ":${number}:[0-9]+: optimized: +loop vectorized"
        OR report MATCHES "Passed\nPass: +loop-vectorize\nName: +Vectorized\nDebugLoc: +[^}]*Line: ${number},")
      list(APPEND fast ${function})
    else()
      list(APPEND slow ${function})
    endif()
    set(function "")
  endif()
endforeach()
if(fast)
  string(REPLACE ";" ", " words "${fast}")
  message(STATUS "${file}: vectorised ${words}")
endif()
if(slow)
  string(REPLACE ";" ", " words "${slow}")
  message(STATUS "${file}: NOT vectorised: ${words}. They are right, and slow: choose a processor, as with "
    "-D@MACRO@_FLAGS=-march=x86-64-v3, or the one that builds them, with -D@MACRO@_NATIVE=ON.")
endif()

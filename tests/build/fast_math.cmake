# Each option that gives up IEEE arithmetic is refused with our sentence, and so is an older C++; else the file is accepted.
include(${SETTINGS}/compiler.cmake)
include(${SETTINGS}/common.cmake)
list(TRANSFORM include_folders PREPEND -I)
set(sentence "Tumble[^\n]*compile with(out -ffast-math| -std=c\\+\\+20)")
file(WRITE ${SETTINGS}/fast_math.cpp "#include <tumble/real.hpp>\n")

foreach(option -O2 -std=c++17 -ffast-math -Ofast -ffinite-math-only)
  execute_process(COMMAND ${compile} ${option} ${include_folders} -E -o ${SETTINGS}/fast_math.ii ${SETTINGS}/fast_math.cpp
    RESULT_VARIABLE result ERROR_VARIABLE error)
  if(option STREQUAL -O2 AND NOT result EQUAL 0)
    message(FATAL_ERROR "error: <tumble/real.hpp> is refused even with ${option}:\n${error}")
  elseif(NOT option STREQUAL -O2 AND (result EQUAL 0 OR NOT error MATCHES "${sentence}"))
    message(FATAL_ERROR "error: ${option} is not refused with our sentence:\n${error}")
  endif()
endforeach()

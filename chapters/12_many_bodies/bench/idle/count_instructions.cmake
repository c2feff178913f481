# An effect that no body calls for costs nothing: a world that has such effects runs exactly as many instructions in a step
# as one that never heard of them. valgrind counts them.
# cmake -DVALGRIND=... -DPROGRAM=... -DSCRATCH=... -P count_instructions.cmake
file(MAKE_DIRECTORY ${SCRATCH})

function(count kind)
  execute_process(
    COMMAND ${VALGRIND} --tool=callgrind --toggle-collect=*steps_that_are_counted*
      --callgrind-out-file=${SCRATCH}/${kind}.callgrind ${PROGRAM} ${kind}
    ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR NOT said MATCHES "Collected : ([0-9]+)")
    message(FATAL_ERROR "error: valgrind could not count: ${said}")
  endif()
  set(${kind} ${CMAKE_MATCH_1} PARENT_SCOPE)
  message(STATUS "100 steps of the world \"${kind}\": ${CMAKE_MATCH_1} instructions")
endfunction()
count(never)
count(idle)
count(needed)

if(never EQUAL 0 OR NOT needed GREATER never)
  message(FATAL_ERROR "error: the count misses the step: ${never} instructions without gravity, ${needed} with it")
endif()
if(NOT idle EQUAL never)
  message(FATAL_ERROR "error: effects that nobody needs cost ${idle} - ${never} instructions in 100 steps")
endif()

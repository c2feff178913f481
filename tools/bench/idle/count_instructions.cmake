# A step pays for what acts, and for nothing else; valgrind counts the instructions.
# An effect that no body calls for costs nothing: a world that has such effects runs exactly as many instructions in a step
# as one that never heard of them.
# So does a body at rest, guard and memory for taking back included: 204,800 boxes at rest take as many instructions a step as
# one, and twelve that fall and tumble as many behind 204,800 at rest as behind 1024.
# So does a checkpoint, and the way back to it. No step of 200 takes more than twice as many as the median one, and 100,000 bodies load in linear time.
# cmake -DVALGRIND=... -DPROGRAM=... -DSCRATCH=... -P count_instructions.cmake
file(MAKE_DIRECTORY ${SCRATCH})

function(count kind)
  execute_process(
    COMMAND ${VALGRIND} --tool=callgrind --toggle-collect=*that_are_counted*
      --callgrind-out-file=${SCRATCH}/${kind}.callgrind ${PROGRAM} ${kind}
    ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR NOT said MATCHES "Collected : ([0-9]+)")
    message(FATAL_ERROR "error: valgrind could not count: ${said}")
  endif()
  set(${kind} ${CMAKE_MATCH_1} PARENT_SCOPE)
  message(STATUS "\"${kind}\": ${CMAKE_MATCH_1} instructions")
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

foreach(kind IN ITEMS one many few few_of_many packs_one packs_many packs_few packs_few_of_many)
  count(${kind})
endforeach()
foreach(keeping IN ITEMS "" packs_)
  if(NOT ${keeping}many EQUAL ${keeping}one)
    message(FATAL_ERROR "error: 204,800 boxes at rest cost ${${keeping}many} instructions in 100 steps, and one ${${keeping}one}")
  endif()
  if(NOT ${keeping}few GREATER ${keeping}one)
    message(FATAL_ERROR "error: the count misses twelve boxes that fall and tumble")
  endif()
  if(NOT ${keeping}few_of_many EQUAL ${keeping}few)
    message(FATAL_ERROR "error: twelve boxes that fall cost ${${keeping}few_of_many} instructions behind 204,800 at rest, and "
      "${${keeping}few} behind 1024")
  endif()
endforeach()

# A change touches what it concerns. It may differ a little where a name lies in the table of names and what the allocator does.
count(changes_of_few)
count(changes_of_many)
math(EXPR most "${changes_of_few} * 5 / 4")
if(changes_of_few EQUAL 0 OR changes_of_many GREATER most)
  message(FATAL_ERROR "error: changes cost ${changes_of_many} instructions among 20,480 bodies, and ${changes_of_few} among 1024")
endif()

# A way back costs what may have moved.
count(checkpoints_of_few)
count(checkpoints_of_many)
math(EXPR most "${checkpoints_of_few} * 5 / 4")
if(checkpoints_of_few EQUAL 0 OR checkpoints_of_many GREATER most)
  message(FATAL_ERROR "error: checkpoints cost ${checkpoints_of_many} instructions behind 204,800 bodies at rest, and ${checkpoints_of_few} behind 1024")
endif()

# Each step by itself: valgrind writes a file after each, with its count.
foreach(kind IN ITEMS each packs_each)
  file(GLOB old ${SCRATCH}/${kind}.callgrind*)
  if(old)
    file(REMOVE ${old})
  endif()
  execute_process(
    COMMAND ${VALGRIND} --tool=callgrind --toggle-collect=*that_are_counted* --dump-after=*count_is_written_down*
      --callgrind-out-file=${SCRATCH}/${kind}.callgrind ${PROGRAM} ${kind}
    ERROR_VARIABLE said RESULT_VARIABLE result)
  file(GLOB dumps ${SCRATCH}/${kind}.callgrind.*)
  set(counts "")
  foreach(dump IN LISTS dumps)
    file(STRINGS ${dump} total REGEX "^(totals|summary): [0-9]+")
    string(REGEX REPLACE "^[a-z]+: ([0-9]+).*" "\\1" total "${total}")
    list(APPEND counts ${total})
  endforeach()
  list(LENGTH counts steps)
  if(NOT result EQUAL 0 OR NOT steps EQUAL 200)
    message(FATAL_ERROR "error: ${steps} steps were counted, not 200: ${said}")
  endif()
  list(SORT counts COMPARE NATURAL)
  list(GET counts 0 least)
  list(GET counts 100 median)
  list(GET counts 199 most)
  message(STATUS "\"${kind}\": from ${least} to ${most} instructions a step, ${median} in the median one")
  math(EXPR twice "2 * ${median}")
  if(least EQUAL 0 OR most GREATER twice)
    message(FATAL_ERROR "error: a step takes ${most} instructions, more than twice the ${median} of the median one")
  endif()
endforeach()

# Ten times as many bodies. Their names are a letter longer, and the table of names and the arrays grow by doubling, which falls on
# one scene sooner than on the other: a twentieth for all that.
foreach(keeping IN ITEMS "" packs_)
  count(${keeping}load_few)
  count(${keeping}load_many)
  math(EXPR most "${${keeping}load_few} * 21 / 2")
  if(${keeping}load_few EQUAL 0 OR ${keeping}load_many GREATER most)
    message(FATAL_ERROR "error: to load 100,000 bodies takes ${${keeping}load_many} instructions, and 10,000 ${${keeping}load_few}")
  endif()
endforeach()

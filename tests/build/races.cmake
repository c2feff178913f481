# Two threads step the same world, or ask it, and no two of their accesses to memory meet: ThreadSanitizer watches each.
include(${SETTINGS}/compiler.cmake)
include(${SETTINGS}/12_many_bodies.cmake)
list(REMOVE_DUPLICATES include_folders)
list(REMOVE_ITEM include_folders ${system_folders})
list(REMOVE_DUPLICATES options)
list(TRANSFORM include_folders PREPEND -I)
list(TRANSFORM system_folders PREPEND -isystem)
set(watched -O1 -g1 -fsanitize=thread -pthread)

file(WRITE ${SETTINGS}/empty.cpp "int main() {}\n")
execute_process(COMMAND ${compile} ${watched} ${SETTINGS}/empty.cpp -o ${SETTINGS}/empty
  RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
if(NOT result EQUAL 0)
  message("Skipped, for this compiler has no ThreadSanitizer")
  return()
endif()
execute_process(COMMAND ${compile} ${watched} ${options} ${include_folders} ${system_folders} ${SOURCE}/tests/build/races.cpp
  -o ${SETTINGS}/races RESULT_VARIABLE result ERROR_VARIABLE error)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "error: tests/build/races.cpp does not compile:\n${error}")
endif()
# It places its shadow memory at fixed addresses, which a system that shuffles them far may have taken.
find_program(setarch setarch)
if(setarch)
  execute_process(COMMAND ${setarch} -R ${SETTINGS}/empty RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(result EQUAL 0) # a container may forbid it
    set(unshuffled ${setarch} -R)
  endif()
endif()
execute_process(COMMAND ${unshuffled} ${SETTINGS}/races RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT result EQUAL 0 OR NOT output MATCHES "^stepped and asked")
  message(FATAL_ERROR "error: threads meet:\n${error}")
endif()

# Builds and runs a project that uses Tumble in one of the WAYs: package, folder or fetch.
set(folder ${SCRATCH}/consumer_by_${WAY})
file(REMOVE_RECURSE ${folder})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${folder} -G ${GENERATOR}
    -DWAY=${WAY} -DSTRICT=${STRICT} -DTUMBLE_SOURCE=${SOURCE} -DCMAKE_PREFIX_PATH=${SCRATCH}/moved
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -DCMAKE_DISABLE_FIND_PACKAGE_doctest=ON -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON
    -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${folder}/consumer COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${folder}/brick OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "    1.5       0 1.76353 m\n") # 3/2, and 1 + 4/2 - 9.81 n (n + 1)/2 h^2
  message(FATAL_ERROR "error: the brick printed '${output}' and not where n = 120 steps of h = 1/240 s bring a throw")
endif()

# The README shows what was compiled, but for the lines round it.
file(READ ${SOURCE}/README.md readme)
file(STRINGS ${SOURCE}/chapters/11_world/brick_demo.cpp lines REGEX "^(#include <tumble|  )")
foreach(line IN LISTS lines)
  string(STRIP "${line}" line)
  string(FIND "${readme}" "\n    ${line}\n" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "error: README.md doesn't hold this line of brick_demo.cpp: ${line}")
  endif()
endforeach()

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
execute_process(COMMAND ${folder}/consumer OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "3 m/s\n")
  message(FATAL_ERROR "error: the consumer printed '${output}' and not '3 m/s'")
endif()

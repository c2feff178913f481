# cmake -D source= -D folder= -D generator= -D compiler= -P make_tiny_book.cmake
# The real build and the real tools, around one tiny chapter: a project in ${folder}, built in ${folder}/build.
cmake_path(GET CMAKE_CURRENT_LIST_FILE PARENT_PATH here)
file(REMOVE_RECURSE ${folder}/cmake ${folder}/common ${folder}/book)  # of an earlier run, which may have had more files
file(COPY ${source}/CMakeLists.txt ${source}/cmake ${source}/common ${source}/book DESTINATION ${folder}
  PATTERN pages EXCLUDE)
file(COPY ${source}/exercises/CMakeLists.txt ${source}/exercises/tools DESTINATION ${folder}/exercises)
file(COPY ${here}/tiny/ DESTINATION ${folder})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${folder} -B ${folder}/build -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_BUILD_TYPE=Release -D TUMBLE_BOOK_FOLDER=${folder}/book_made
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/build --parallel 2 --target book COMMAND_ERROR_IS_FATAL ANY)

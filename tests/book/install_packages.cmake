# cmake -D npm= -D source= -D folder= -P install_packages.cmake
# The locked npm packages of the browser tests, in the build tree; again only when the lock file has changed.
file(SHA256 ${source}/package-lock.json wanted)
if(EXISTS ${folder}/installed)
  file(READ ${folder}/installed installed)
endif()
if("${installed}" STREQUAL "${wanted}")
  return()
endif()
file(COPY ${source}/package.json ${source}/package-lock.json DESTINATION ${folder})
execute_process(COMMAND ${npm} ci --prefer-offline --no-audit --no-fund --ignore-scripts
  WORKING_DIRECTORY ${folder} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "npm could not install the packages of the browser tests into ${folder}; the first time it needs a network")
endif()
file(WRITE ${folder}/installed ${wanted})

# A chapter is one floor of the tower: a header-only library whose folder is its include root and which links
# the floor below. Nothing links the floor above, so an include that reaches upward does not compile.

set_property(GLOBAL PROPERTY TUMBLE_FLOORS "")

# tumble_add_floor(NAME [ABOVE FLOOR]): the library target tumble_NAME, known to users as tumble::NAME.
function(tumble_add_floor name)
  cmake_parse_arguments(PARSE_ARGV 1 floor "" "ABOVE" "")
  add_library(tumble_${name} INTERFACE)
  add_library(tumble::${name} ALIAS tumble_${name})
  set_target_properties(tumble_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(tumble_${name} INTERFACE
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:include>)
  if(floor_ABOVE)
    target_link_libraries(tumble_${name} INTERFACE tumble_${floor_ABOVE})
  endif()
  set_property(GLOBAL APPEND PROPERTY TUMBLE_FLOORS ${name})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_HEADER_FOLDERS ${CMAKE_CURRENT_SOURCE_DIR}/tumble)
endfunction()

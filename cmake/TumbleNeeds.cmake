# tumble_missing(RESULT NEED...): each NEED is VARIABLE:PACKAGE, and RESULT becomes the list of the packages whose variable is
# not set or says that nothing was found.
function(tumble_missing result)
  set(missing "")
  foreach(need IN LISTS ARGN)
    string(REPLACE ":" ";" need ${need})
    list(GET need 0 variable)
    list(GET need 1 package)
    if(NOT ${variable})
      list(APPEND missing ${package})
    endif()
  endforeach()
  set(${result} "${missing}" PARENT_SCOPE)
endfunction()

# What the course adds to the library: checks, programs, figures and costs. Each runs during the build of the book and
# leaves what it found in results/CHAPTER, where the book picks it up:
#   checks.xml         the verdict of every check, in doctest's XML
#   PROGRAM.txt        what a program printed
#   PROGRAM.failed     what it expected in vain, if it did; empty where it crashed
#   PROGRAM.values.tsv the numbers that the prose quotes, and any TABLE.tsv
#   FIGURE.svg         what gnuplot drew from those tables
#   COST.json          what Google Benchmark measured
#   FIGURE.live.json   the first picture of a figure that one can touch, in numbers; FIGURE.live.js draws it, and FIGURE.wasm
#                      computes the others

set(TUMBLE_RESULTS ${PROJECT_BINARY_DIR}/results)
set(TUMBLE_QUIET ${PROJECT_BINARY_DIR}/quiet)
option(TUMBLE_NATIVE "Use every instruction this machine has" OFF)
set(TUMBLE_BOOK_FOLDER ${PROJECT_BINARY_DIR}/html CACHE PATH "Where the book is written")

option(TUMBLE_FULL "Let the programs that measure take their full sets: an hour instead of a minute" OFF)
set(TUMBLE_MEASURED "" CACHE PATH "What tools/measure.py has made of the long programs' results; without it they are run here")

find_package(doctest REQUIRED)
find_package(benchmark QUIET)
find_program(TUMBLE_GNUPLOT gnuplot)

find_program(TUMBLE_CCACHE ccache)
if(TUMBLE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # A precompiled header changes its time stamp; ccache must be told to look at the content alone, and since its bytes are
  # others each time that it is made, at the checksum beside it (tumble_precompile()). And a second checkout shall find what
  # the first has compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime
    CCACHE_PCH_EXTSUM=yes CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=yes ${TUMBLE_CCACHE})
  # CMake would say the same behind -Xclang, where ccache doesn't see that a word is a path.
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -include-pch <PCH_FILE>)
  endif()
endif()

add_library(tumble_flags INTERFACE)
# -Wno-psabi: a pack wider than a register is passed otherwise by a program for a machine with wider ones. Ours are each
# compiled for one machine.
target_compile_options(tumble_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-psabi
  $<$<BOOL:${TUMBLE_WARNINGS_AS_ERRORS}>:-Werror>
  $<$<BOOL:${TUMBLE_NATIVE}>:-march=native>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 takes "literal" + std::string for an overlong copy (GCC bug 105651, mended in 13), and registers that
  # AVX-512 leaves undefined on purpose for forgotten ones (GCC bug 105593).
  target_compile_options(tumble_flags INTERFACE -Wno-stringop-overflow -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(TUMBLE_NATIVE AND CMAKE_CXX_COMPILER_ID STREQUAL Clang AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 18)
  # Of a processor that has AVX10.1 clang first reports the narrower kind, and then complains that it can't be had
  # beside AVX-512 (llvm-project 132542).
  target_compile_options(tumble_flags INTERFACE -Wno-invalid-feature-combination)
endif()
if(CMAKE_CXX_COMPILER_LAUNCHER)
  target_compile_options(tumble_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
endif()
# g++ collects its own garbage while it compiles, a tenth of the time of our files. Most of them need less than half a
# gigabyte and are done before it begins. The largest, which compile several kinds of World, stay below one and a half.
target_compile_options(tumble_flags INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-expand=100 --param=ggc-min-heapsize=450000>)
if(TUMBLE_SANITIZE)
  # A test of every reference for null, and of its object's size, would say again what the address sanitizer says, and
  # take half as long again to compile.
  target_compile_options(tumble_flags INTERFACE -fsanitize=${TUMBLE_SANITIZE} -fno-sanitize=null,object-size,vptr
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(tumble_flags INTERFACE -fsanitize=${TUMBLE_SANITIZE})
endif()

# Checks are compiled for a quick verdict (-Og: a seventh less to compile than -O1), with every assertion of Eigen's on;
# programs for speed.
add_library(tumble_check_flags INTERFACE)
if(TUMBLE_SANITIZE)
  target_compile_options(tumble_check_flags INTERFACE -UNDEBUG)
else()
  # At -Og clang 21 overwrites a number in a register that it needs again (llvm-project 191800): seen in a call of
  # EmbeddedSteps::first_step(), on a processor with AVX-512.
  set(quick -Og)
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 20)
    set(quick -O2)
  endif()
  target_compile_options(tumble_check_flags INTERFACE ${quick} -UNDEBUG -g0)
endif()
target_link_libraries(tumble_check_flags INTERFACE tumble_flags tumble_common doctest::doctest)
add_library(tumble_program_flags INTERFACE)
target_link_libraries(tumble_program_flags INTERFACE tumble_flags tumble_common)

# One precompiled header for each of the two flag sets. The file with doctest's main stays out of it: a header that was
# compiled without doctest's implementation cannot supply it.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/empty.cpp CONTENT "")
set(headers_for_check <doctest/doctest.h> <Eigen/Core> <Eigen/Geometry> <Eigen/Eigenvalues> <string> <vector> <array> <random>)
set(headers_for_program <Eigen/Core> <Eigen/Geometry> <cstdio> <fstream> <string> <vector> <array> <random>)
function(tumble_precompile name use)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/empty.cpp)
  target_compile_options(${name} PRIVATE ${ARGN})
  target_link_libraries(${name} PUBLIC tumble_${use}_flags)
  target_precompile_headers(${name} PRIVATE ${headers_for_${use}})
  # What is in it: headers of packages alone. Of an object ccache hashes the compiler and the flags as well.
  foreach(extension gch pch)  # as g++ and clang call it; clang's holds the names of folders
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/cmake_pch.hxx.${extension}.sum
      CONTENT "${headers_for_${use}} ${Eigen3_VERSION} ${doctest_VERSION} ${CMAKE_CXX_COMPILER_VERSION}")
  endforeach()
endfunction()
tumble_precompile(tumble_check_headers check)
tumble_precompile(tumble_program_headers program)

# With the sanitizers clang takes half as long for -O0 as for -O1, and what it makes runs a fifteenth as fast. So -O1 is for
# the chapters' checks and the programs that compute for more than a tenth of a second, and for libraries.
set(TUMBLE_BUSY exact scene_reader bench 03_inertia 07_orientation 08_tumbling 11_world 12_many_bodies 13_accuracy
  particle_cloud tiny_turns_demo rules_demo clock_demo plan_demo packs_demo hard_cases_demo accuracy_demo random_tops_demo
  slow_bodies_demo long_run_demo)
if(TUMBLE_SANITIZE)
  tumble_precompile(tumble_idle_check_headers check -O0)
  tumble_precompile(tumble_idle_program_headers program -O0)
endif()

# tumble_use_precompiled(TARGET check|program NAME): the precompiled header for a file of that chapter's checks, or for that
# program.
function(tumble_use_precompiled target use name)
  if(TUMBLE_SANITIZE AND NOT name IN_LIST TUMBLE_BUSY)
    target_compile_options(${target} PRIVATE -O0)
    target_precompile_headers(${target} REUSE_FROM tumble_idle_${use}_headers)
  else()
    target_precompile_headers(${target} REUSE_FROM tumble_${use}_headers)
  endif()
endfunction()
add_library(tumble_check_main OBJECT ${PROJECT_SOURCE_DIR}/common/support/check_main.cpp)
target_link_libraries(tumble_check_main PUBLIC tumble_check_flags)

add_custom_target(results)  # everything that the book quotes
add_custom_target(all_checks)  # everything that a test with the label "checks" runs

add_custom_target(slow_programs)  # what only slow tests run

# tumble_chapter_target(SUFFIX CHAPTER): the custom target SUFFIX_CHAPTER, made once.
function(tumble_chapter_target suffix chapter)
  if(NOT TARGET ${suffix}_${chapter})
    add_custom_target(${suffix}_${chapter})
  endif()
endfunction()

# tumble_add_result(CHAPTER TARGET): what the chapter's pages wait for.
function(tumble_add_result chapter target)
  tumble_chapter_target(results ${chapter})
  add_dependencies(results_${chapter} ${target})
  add_dependencies(results ${target})
endfunction()

# tumble_add_tool(NAME CHAPTER): the pages in this folder stand in the book behind those of CHAPTER, and what they quote lies in
# results/NAME. The functions below take NAME for a chapter.
function(tumble_add_tool name chapter)
  set_property(GLOBAL APPEND PROPERTY TUMBLE_TOOLS ${name})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_TOOLS_CHAPTERS ${chapter})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_TOOLS_FOLDERS ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()

# tumble_label(TEST LABEL CHAPTER): what the book runs and shows is labelled in_book too: whoever has made the book knows its
# verdict already.
function(tumble_label test label chapter)
  if(chapter MATCHES "^[0-9][0-9]_")
    list(APPEND label in_book)
  endif()
  set_tests_properties(${test} PROPERTIES LABELS "${label}")
endfunction()

# tumble_add_checks(CHAPTER FILE...): one program with the chapter's checks, one CTest, one checks.xml. Five files are compiled as
# one, which spares what each would parse and instantiate anew; so no two files of a chapter may give one name to two things.
# For whoever works on one header, NAME_checks.cpp alone makes a program too, CHAPTER.NAME, built only when asked for; with
# sanitizers, which take more memory, the chapter's program is made of those.
function(tumble_add_checks chapter)
  set(program ${chapter}_checks)
  add_executable(${program})
  target_link_libraries(${program} PRIVATE tumble_check_main)
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/checks)
  foreach(file IN LISTS ARGN)
    string(REGEX REPLACE "^.*/|_checks\\.cpp$" "" name ${file})
    add_library(checks_${chapter}_${name} OBJECT EXCLUDE_FROM_ALL ${file})
    target_link_libraries(checks_${chapter}_${name} PUBLIC tumble_${chapter} tumble_check_flags)
    tumble_link_compiled(checks_${chapter}_${name} PUBLIC)
    tumble_use_precompiled(checks_${chapter}_${name} check ${chapter})
    add_executable(${chapter}.${name} EXCLUDE_FROM_ALL)
    target_link_libraries(${chapter}.${name} PRIVATE tumble_check_main checks_${chapter}_${name})
    set_target_properties(${chapter}.${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/checks)
    if(TUMBLE_SANITIZE)
      target_link_libraries(${program} PRIVATE checks_${chapter}_${name})
    else()
      target_link_libraries(${program} PRIVATE $<TARGET_PROPERTY:checks_${chapter}_${name},LINK_LIBRARIES>)
    endif()
  endforeach()
  # CMake's own unity builds name the files by their whole paths, with which no other checkout would find them in the cache.
  set(files ${ARGN})
  while(files AND NOT TUMBLE_SANITIZE)
    list(SUBLIST files 0 5 five)
    list(REMOVE_ITEM files ${five})
    list(GET five 0 first)
    get_filename_component(first ${first} NAME_WE)
    list(TRANSFORM five REPLACE "^.+$" "#include <\\0>\n")
    string(CONCAT five ${five})
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/together/${first}.cpp CONTENT "${five}" @ONLY)
    target_sources(${program} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/together/${first}.cpp)
  endwhile()
  if(NOT TUMBLE_SANITIZE)
    target_include_directories(${program} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    tumble_use_precompiled(${program} check ${chapter})
  endif()
  add_dependencies(all_checks ${program})
  add_test(NAME checks.${chapter} COMMAND ${program})
  tumble_label(checks.${chapter} checks ${chapter})

  set(result ${TUMBLE_RESULTS}/${chapter}/checks.xml)
  # A failed check must reach the page, so it does not stop the build here: the book prints it in red and says so.
  add_custom_command(OUTPUT ${result}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${TUMBLE_RESULTS}/${chapter}
    COMMAND $<TARGET_FILE:${program}> --reporters=xml --out=${result} || ${CMAKE_COMMAND} -E true
    DEPENDS ${program} COMMENT "Checking ${chapter}" VERBATIM)
  add_custom_target(checks_result_${chapter} DEPENDS ${result})
  tumble_add_result(${chapter} checks_result_${chapter})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RESULT_FILES ${result})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RUNS ${result})
endfunction()

# tumble_compile_once(NAME LIBRARY... FILES FILE... [DEFINES MACRO] [CHECKS] [EVERYWHERE]): a library of what many files
# would otherwise compile each for itself, on top of the given libraries. Whatever links it sees the MACRO. It is compiled as
# programs are, for checks and programs alike, or as CHECKS are. EVERYWHERE: all checks and programs from here on link it,
# but for those that measure time, which are compiled from the headers alone, as a user's program is.
function(tumble_compile_once name)
  cmake_parse_arguments(PARSE_ARGV 1 once "CHECKS;EVERYWHERE" "DEFINES" "FILES")
  set(use program)
  if(once_CHECKS)
    set(use check)
  endif()
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${once_FILES})
  target_link_libraries(${name} PUBLIC ${once_UNPARSED_ARGUMENTS} PRIVATE tumble_${use}_flags)
  tumble_link_compiled(${name} PRIVATE)
  target_compile_definitions(${name} PUBLIC ${once_DEFINES})
  target_precompile_headers(${name} REUSE_FROM tumble_${use}_headers)
  if(once_EVERYWHERE)
    set_property(GLOBAL APPEND PROPERTY TUMBLE_COMPILED_ONCE ${name})
  endif()
endfunction()

# tumble_link_compiled(TARGET PUBLIC|PRIVATE): links what is compiled once for all.
function(tumble_link_compiled target how)
  get_property(libraries GLOBAL PROPERTY TUMBLE_COMPILED_ONCE)
  target_link_libraries(${target} ${how} ${libraries})
endfunction()

# tumble_add_program(CHAPTER NAME [LONG] [IN_ITEMS] [MEASURES]): compiles NAME.cpp; it is run with the results folder as
# its one argument. A LONG one finds TUMBLE_FULL in its environment when it shall take its time; one IN_ITEMS uses
# <support/items.hpp>. One that MEASURES time is run alone, after everything else.
function(tumble_add_program chapter name)
  set(run_in_full "")
  set(measured "")
  if("LONG" IN_LIST ARGN)
    tumble_long_program(${chapter} ${name} measured ${ARGN})
    if(TUMBLE_FULL)
      set(run_in_full ${CMAKE_COMMAND} -E env TUMBLE_FULL=1)
    endif()
  endif()
  set(quiet "")
  if("MEASURES" IN_LIST ARGN)
    set(quiet ${TUMBLE_QUIET}/${name})
  endif()
  add_executable(${name} ${name}.cpp)
  target_link_libraries(${name} PRIVATE tumble_${chapter} tumble_program_flags)
  if(NOT "MEASURES" IN_LIST ARGN)
    tumble_link_compiled(${name} PRIVATE)
  endif()
  tumble_use_precompiled(${name} program ${name})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/programs/${chapter})
  tumble_chapter_target(programs ${chapter})
  add_dependencies(programs_${chapter} ${name})
  add_test(NAME programs.${name} COMMAND ${name} ${PROJECT_BINARY_DIR}/scratch/${name})
  tumble_label(programs.${name} programs ${chapter})

  set(folder ${TUMBLE_RESULTS}/${chapter})
  if(NOT measured)
    # What a program expected in vain must reach the page too; the book prints it in red.
    add_custom_command(OUTPUT ${folder}/${name}.txt
      COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
      COMMAND ${CMAKE_COMMAND} -E rm -f ${folder}/${name}.failed
      COMMAND ${run_in_full} $<TARGET_FILE:${name}> ${folder} > ${folder}/${name}.txt 2> ${folder}/${name}.errors ||
        ${CMAKE_COMMAND} -E copy ${folder}/${name}.errors ${folder}/${name}.failed
      DEPENDS ${name} ${quiet} COMMENT "Running ${name}" VERBATIM)
  endif()
  add_custom_target(run_${name} DEPENDS ${folder}/${name}.txt)
  tumble_add_result(${chapter} run_${name})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RESULT_FILES ${folder}/${name}.txt)
  if("MEASURES" IN_LIST ARGN)
    set_property(GLOBAL APPEND PROPERTY TUMBLE_MEASUREMENTS ${folder}/${name}.txt)
  else()
    set_property(GLOBAL APPEND PROPERTY TUMBLE_RUNS ${folder}/${name}.txt)
  endif()
endfunction()

# tumble_long_program(CHAPTER NAME VARIABLE [IN_ITEMS] [MEASURES] [ARGUMENTS WORD...]): lists a program for tools/measure.py,
# which runs it with the folder for its results and those words. Where that has been done already, its results are taken
# instead of running it, and the variable is set.
function(tumble_long_program chapter name variable)
  cmake_parse_arguments(its "LONG;IN_ITEMS;MEASURES" "" "ARGUMENTS" ${ARGN})
  list(TRANSFORM its_ARGUMENTS REPLACE "(.+)" "\"\\1\"")
  list(JOIN its_ARGUMENTS ", " words)
  foreach(flag IN ITEMS IN_ITEMS MEASURES)
    if(its_${flag})
      set(${flag} true)
    else()
      set(${flag} false)
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY TUMBLE_LONG_PROGRAMS "{\"name\": \"${name}\", \"chapter\": \"${chapter}\", \
\"program\": \"$<TARGET_FILE:${name}>\", \"arguments\": [${words}], \"items\": ${IN_ITEMS}, \"measures\": ${MEASURES}}")
  set_property(GLOBAL APPEND PROPERTY TUMBLE_LONG_TARGETS ${name})
  if(TUMBLE_MEASURED)
    set(folder ${TUMBLE_RESULTS}/${chapter})
    add_custom_command(OUTPUT ${folder}/${name}.txt
      COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
      COMMAND ${CMAKE_COMMAND} -E rm -f ${folder}/${name}.failed
      COMMAND ${CMAKE_COMMAND} -E copy_directory ${TUMBLE_MEASURED}/${name} ${folder}
      COMMAND ${CMAKE_COMMAND} -E touch ${folder}/${name}.txt
      DEPENDS ${TUMBLE_MEASURED}/${name}/${name}.txt COMMENT "Taking what ${name} has measured" VERBATIM)
    set(${variable} TRUE PARENT_SCOPE)
  endif()
endfunction()

# tumble_list_long_programs(): called when all chapters are known, it writes long_programs.json. The target long_programs
# compiles them.
function(tumble_list_long_programs)
  get_property(programs GLOBAL PROPERTY TUMBLE_LONG_PROGRAMS)
  get_property(targets GLOBAL PROPERTY TUMBLE_LONG_TARGETS)
  list(JOIN programs ",\n  " programs)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/long_programs.json CONTENT "{\"compiler\": \"${CMAKE_CXX_COMPILER_ID} \
${CMAKE_CXX_COMPILER_VERSION}\", \"programs\": [\n  ${programs}]}\n")
  add_custom_target(long_programs)
  if(targets) # a course of a few chapters may have none
    add_dependencies(long_programs ${targets})
  endif()
endfunction()

# tumble_measure_alone(): called when all chapters are known, it makes what MEASURES time wait for every other run, and
# for each other. The file that stands for this never changes: what is measured is not measured again for a new result
# of somebody else.
function(tumble_measure_alone)
  get_property(before GLOBAL PROPERTY TUMBLE_RUNS)
  get_property(measurements GLOBAL PROPERTY TUMBLE_MEASUREMENTS)
  foreach(measurement IN LISTS measurements)
    get_filename_component(name ${measurement} NAME_WE)
    add_custom_command(OUTPUT ${TUMBLE_QUIET}/${name}
      COMMAND ${CMAKE_COMMAND} -E copy_if_different ${PROJECT_BINARY_DIR}/empty.cpp ${TUMBLE_QUIET}/${name}
      DEPENDS ${before} COMMENT "" VERBATIM)
    add_custom_target(quiet_for_${name} DEPENDS ${TUMBLE_QUIET}/${name})
    add_dependencies(run_${name} quiet_for_${name})
    list(APPEND before ${measurement})
  endforeach()
endfunction()

# tumble_add_figure(CHAPTER NAME PROGRAM): gnuplot draws NAME.gp from the tables that PROGRAM wrote.
function(tumble_add_figure chapter name program)
  if(NOT TUMBLE_GNUPLOT)
    return()
  endif()
  set(folder ${TUMBLE_RESULTS}/${chapter})
  set(style ${PROJECT_SOURCE_DIR}/book/theme/figure.gp)
  add_custom_command(OUTPUT ${folder}/${name}.svg
    COMMAND ${TUMBLE_GNUPLOT} -e "name='${name}'" ${style} ${CMAKE_CURRENT_SOURCE_DIR}/${name}.gp
    WORKING_DIRECTORY ${folder}
    DEPENDS ${folder}/${program}.txt ${style} ${name}.gp COMMENT "Drawing ${name}" VERBATIM)
  add_custom_target(figure_${chapter}_${name} DEPENDS ${folder}/${name}.svg)
  tumble_add_result(${chapter} figure_${chapter}_${name})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RESULT_FILES ${folder}/${name}.svg)
endfunction()

# tumble_add_cost(CHAPTER NAME): what the chapter's functions cost, measured by Google Benchmark where it is installed.
function(tumble_add_cost chapter name)
  if(NOT benchmark_FOUND OR TUMBLE_SANITIZE)  # what a sanitizer costs is no cost of ours
    return()
  endif()
  add_executable(${name} ${name}.cpp)
  target_link_libraries(${name} PRIVATE tumble_${chapter} tumble_program_flags benchmark::benchmark_main)
  target_precompile_headers(${name} REUSE_FROM tumble_program_headers)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/costs/${chapter})
  set(folder ${TUMBLE_RESULTS}/${chapter})
  add_custom_command(OUTPUT ${folder}/${name}.json
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND $<TARGET_FILE:${name}> --benchmark_min_time=0.05 --benchmark_repetitions=5
      --benchmark_enable_random_interleaving=true
      --benchmark_report_aggregates_only=true --benchmark_out=${folder}/${name}.json > ${folder}/${name}.log 2>&1
    DEPENDS ${name} COMMENT "Measuring ${name}" VERBATIM)
  add_custom_target(measure_${name} DEPENDS ${folder}/${name}.json)
  tumble_add_result(${chapter} measure_${name})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RESULT_FILES ${folder}/${name}.json)
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RUNS ${folder}/${name}.json)
endfunction()

# What compiles for WebAssembly: any clang++ with Debian's wasi-libc, libc++-dev-wasm32, libclang-rt-dev-wasm32 and lld.
# Looked for again in every configuration until it is found. Optimising a module as a whole makes the largest one smaller by a
# sixth; that takes a lld of clang's own version.
set(TUMBLE_WASM_FLAGS --target=wasm32-wasi -std=c++20 -fexceptions)
function(tumble_find_wasm_compiler)
  if(TUMBLE_WASM_COMPILER AND DEFINED TUMBLE_WASM_WHOLE)
    return()
  endif()
  find_program(TUMBLE_CLANG NAMES clang++ clang++-22 clang++-21 clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++-15
    clang++-14)
  if(TUMBLE_CLANG)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/wasm/tried.cpp CONTENT "#include <charconv>
#include <vector>
int main() { char text[32]; return std::to_chars(text, text + 32, std::vector(3, 0.1)[1]).ptr - text; }\n")
    foreach(whole IN ITEMS -flto "")
      execute_process(COMMAND ${TUMBLE_CLANG} ${TUMBLE_WASM_FLAGS} -fno-exceptions ${whole} tried.cpp -o tried.wasm
        WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/wasm RESULT_VARIABLE status OUTPUT_QUIET ERROR_FILE tried.log)
      if(status EQUAL 0)
        set(TUMBLE_WASM_COMPILER ${TUMBLE_CLANG} CACHE FILEPATH "The clang++ that compiles live figures")
        set(TUMBLE_WASM_WHOLE "${whole}" CACHE STRING "The flag with which it optimises a module as a whole, if it can")
        return()
      endif()
    endforeach()
  endif()
  message(STATUS "No clang++ here compiles for WebAssembly, so no figure of the book moves by hand; see README.md for the packages")
endfunction()
tumble_find_wasm_compiler()

# tumble_compile_for_wasm(OBJECT SOURCE TARGET): SOURCE with the flags and the folders of TARGET, which runs here.
function(tumble_compile_for_wasm object source target)
  # The system's own folder comes with WebAssembly's headers in front, and would hide them here.
  set(folders $<FILTER:$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>,EXCLUDE,^/usr/include$>)
  set(definitions $<TARGET_PROPERTY:tumble_common,INTERFACE_COMPILE_DEFINITIONS>)
  add_custom_command(OUTPUT ${object}
    COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${TUMBLE_WASM_COMPILER} ${TUMBLE_WASM_FLAGS} ${TUMBLE_WASM_WHOLE} -Os -DNDEBUG -ffp-contract=off
      -fno-math-errno "-D$<JOIN:${definitions},;-D>" "$<$<BOOL:${folders}>:-isystem;$<JOIN:${folders},;-isystem;>>"
      -MD -MF ${object}.d -MT ${object} -c ${source} -o ${object}
    DEPENDS ${source} DEPFILE ${object}.d COMMAND_EXPAND_LISTS COMMENT "Compiling ${object}" VERBATIM)
endfunction()

# tumble_add_live(CHAPTER NAME [AFTER SCRIPT...] [LINKS LIBRARY...]): the figure that NAME_live.cpp computes and NAME_live.js
# draws, with the scripts before it. It is compiled twice from the same lines: as a program, whose numbers make the still
# picture, and as a module, whose numbers are equal to the bit.
function(tumble_add_live chapter name)
  cmake_parse_arguments(its "" "" "AFTER;LINKS" ${ARGN})
  set(program live_${name})
  if(NOT TARGET live_program)
    add_library(live_program OBJECT ${PROJECT_SOURCE_DIR}/common/support/live/live_program.cpp)
    target_link_libraries(live_program PUBLIC tumble_program_flags)
    target_precompile_headers(live_program REUSE_FROM tumble_program_headers)
  endif()
  add_executable(${program} ${name}_live.cpp)
  if(TARGET tumble_${chapter})
    list(PREPEND its_LINKS tumble_${chapter})
  endif()
  target_link_libraries(${program} PRIVATE live_program ${its_LINKS})
  target_precompile_headers(${program} REUSE_FROM tumble_program_headers)
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/live)
  set(folder ${TUMBLE_RESULTS}/${chapter})
  add_custom_command(OUTPUT ${folder}/${name}.live.json
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND $<TARGET_FILE:${program}> > ${folder}/${name}.live.json
    DEPENDS ${program} COMMENT "Computing the still picture of ${name}" VERBATIM)
  list(TRANSFORM its_AFTER PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set(scripts ${its_AFTER} ${CMAKE_CURRENT_SOURCE_DIR}/${name}_live.js)
  add_custom_command(OUTPUT ${folder}/${name}.live.js
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
    COMMAND ${CMAKE_COMMAND} -E cat ${scripts} > ${folder}/${name}.live.js
    DEPENDS ${scripts} COMMENT "" VERBATIM)
  set(made ${folder}/${name}.live.json ${folder}/${name}.live.js)
  if(TUMBLE_WASM_COMPILER)
    set(objects ${PROJECT_BINARY_DIR}/wasm)
    if(NOT TARGET live_module)
      tumble_compile_for_wasm(${objects}/live_module.o ${PROJECT_SOURCE_DIR}/common/support/live/live_module.cpp ${program})
      add_custom_target(live_module DEPENDS ${objects}/live_module.o)
    endif()
    tumble_compile_for_wasm(${objects}/${name}.o ${CMAKE_CURRENT_SOURCE_DIR}/${name}_live.cpp ${program})
    add_custom_command(OUTPUT ${folder}/${name}.wasm
      COMMAND ${TUMBLE_WASM_COMPILER} --target=wasm32-wasi -mexec-model=reactor ${TUMBLE_WASM_WHOLE}
        -Wl,--strip-all,--stack-first,--lto-O2,-z,stack-size=1048576
        ${objects}/${name}.o ${objects}/live_module.o -o ${folder}/${name}.wasm
      DEPENDS ${objects}/${name}.o live_module ${objects}/live_module.o COMMENT "Linking ${name} for WebAssembly" VERBATIM)
    list(APPEND made ${folder}/${name}.wasm)
  endif()
  add_custom_target(live_figure_${name} DEPENDS ${made})
  tumble_add_result(${chapter} live_figure_${name})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_RESULT_FILES ${made})
  set_property(GLOBAL APPEND PROPERTY TUMBLE_LIVE_FIGURES ${chapter}/${name})
endfunction()

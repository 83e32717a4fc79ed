# The flags that every target of Hitos is compiled with, and one function per kind of target.
add_library(hitos_options INTERFACE)
target_compile_options(hitos_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Woverloaded-virtual -Wold-style-cast -Wcast-qual -Wdouble-promotion
  # gcc 12 sees overlaps in std::string concatenation that are not there (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # The same bits on every machine: no contraction into fused multiply-add.
  -ffp-contract=off)
if(HITOS_WERROR)
  target_compile_options(hitos_options INTERFACE -Werror)
endif()
if(HITOS_SANITIZE)
  target_compile_options(hitos_options INTERFACE
    -fsanitize=${HITOS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(hitos_options INTERFACE -fsanitize=${HITOS_SANITIZE})
endif()

# hitos_layer(NAME source...): the static library hitos_NAME, with include/ as its public face.
function(hitos_layer name)
  add_library(hitos_${name} STATIC ${ARGN})
  add_library(hitos::${name} ALIAS hitos_${name})
  target_include_directories(hitos_${name}
    PUBLIC ${PROJECT_SOURCE_DIR}/include
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(hitos_${name} PRIVATE hitos_options)
endfunction()

# hitos_program(NAME source...): the executable NAME in build/<preset>/bin.
function(hitos_program name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE hitos_options)
endfunction()

# hitos_test(NAME LIBS lib... SOURCES source...): a GoogleTest program whose cases ctest knows.
function(hitos_test name)
  cmake_parse_arguments(ARG "" "" "LIBS;SOURCES" ${ARGN})
  hitos_program(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    HITOS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    HITOS_SHARED_DIR="${HITOS_SHARED_DIR}"
    HITOS_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} GTest::gmock GTest::gtest_main)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300)
endfunction()

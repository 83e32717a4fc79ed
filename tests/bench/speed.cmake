# The program of tests/bench/speed. It is also built inside a release that is older than it: configured
# there with CMAKE_PROJECT_INCLUDE=speed.cmake and HITOS_BASELINE=ON, and added after everything else.
if(NOT COMMAND hitos_program)
  cmake_language(EVAL CODE "cmake_language(DEFER CALL include [[${CMAKE_CURRENT_LIST_FILE}]])")
  return()
endif()

find_package(fmt REQUIRED)
set(speed_folder ${CMAKE_CURRENT_LIST_DIR})
hitos_program(bench_speed
  ${speed_folder}/speed.cpp
  ${speed_folder}/speed_fields.cpp
  ${speed_folder}/speed_measure.cpp
  ${speed_folder}/speed_memory.cpp
  ${speed_folder}/speed_stages.cpp
  ${speed_folder}/speed_tours.cpp)
set_target_properties(bench_speed PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
# Both builds read the configurations, worlds and logs of this one.
cmake_path(SET speed_root NORMALIZE ${speed_folder}/../..)
target_compile_definitions(bench_speed PRIVATE
  HITOS_SOURCE_DIR="${speed_root}" HITOS_SHARED_DIR="${HITOS_SHARED_DIR}"
  $<$<BOOL:${HITOS_BASELINE}>:HITOS_BASELINE>)
target_link_libraries(bench_speed PRIVATE hitos::services hitos::simulation fmt::fmt)

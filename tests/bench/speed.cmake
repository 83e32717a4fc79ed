# SPDX-License-Identifier: GPL-3.0-or-later
# The program of tests/bench/speed. It is also built inside a release that is older than it:
# configured there with CMAKE_PROJECT_INCLUDE=speed.cmake and HITOS_BASELINE=ON, and added after
# everything else.
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
get_filename_component(speed_root ${speed_folder}/../.. ABSOLUTE)
target_compile_definitions(bench_speed PRIVATE
  HITOS_SOURCE_DIR="${speed_root}" HITOS_SHARED_DIR="${HITOS_SHARED_DIR}"
  $<$<BOOL:${HITOS_BASELINE}>:HITOS_BASELINE>)
target_link_libraries(bench_speed PRIVATE hitos::services hitos::simulation fmt::fmt)
if(NOT HITOS_BASELINE)
  find_package(TBB REQUIRED)
  target_sources(bench_speed PRIVATE ${speed_folder}/speed_kernels.cpp)
  # It looks into the filter.
  target_include_directories(bench_speed PRIVATE ${speed_root}/src/slam)
  target_link_libraries(bench_speed PRIVATE TBB::tbb)
endif()
if(HITOS_BASELINE)
  # Headers that stand elsewhere now than they did in the release.
  foreach(moved
      base/geometry=capture/geometry
      base/random_stream=features/random_stream
      services/configuration/archivo_configuracion=services/archivo_configuracion
      services/drawing/picture_file=services/picture_file
      services/files/map_file=services/map_file
      services/files/trajectory_file=services/trajectory_file
      services/grid/grid=services/grid
      simulation/drive/simulated_tour=simulation/simulated_tour
      simulation/worlds/odometry_noise=simulation/odometry_noise)
    string(REPLACE "=" ";" moved ${moved})
    list(GET moved 0 now)
    list(GET moved 1 then)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/moved/hitos/${now}.hpp
      CONTENT "#include \"hitos/${then}.hpp\"\n")
  endforeach()
  target_include_directories(bench_speed PRIVATE ${CMAKE_BINARY_DIR}/moved)
endif()

# SPDX-License-Identifier: GPL-3.0-or-later
# hitos_describe(PROGRAM): the program writes its manual pages and completions (--describe) when all
# is built, and they are installed with it.
function(hitos_describe program)
  if(HITOS_SANITIZE OR CMAKE_CROSSCOMPILING)
    return()
  endif()
  set(folder ${CMAKE_BINARY_DIR}/manual/${program})
  set(prose ${PROJECT_SOURCE_DIR}/docs/man)
  file(GLOB pages CONFIGURE_DEPENDS ${prose}/*.md)
  # From the sources' folder, so that the worlds are found wherever the build folder lies.
  add_custom_command(OUTPUT ${folder}.stamp
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}
    COMMAND ${program} --prose ${prose} --describe ${folder}
    COMMAND sh -c "gzip -9n \"$0\"/man/*" ${folder}
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}.stamp
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    DEPENDS ${program} ${pages} VERBATIM)
  add_custom_target(manual_of_${program} ALL DEPENDS ${folder}.stamp)
  foreach(section 1 5)
    install(DIRECTORY ${folder}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section}
      COMPONENT program FILES_MATCHING PATTERN *.${section}.gz)
  endforeach()
  install(DIRECTORY ${folder}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    COMPONENT program)
  install(DIRECTORY ${folder}/fish/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
    COMPONENT program)
endfunction()

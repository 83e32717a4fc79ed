# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack` in a build folder makes the Debian packages: hitos (programs and what they need), libhitos-dev
# (headers, libraries and examples) and, where the module was built, python3-hitos. docs/packages.md.
set(packaging_folder ${CMAKE_CURRENT_LIST_DIR}/packaging)
set(release 1)

# When the changes were made: of the sources, unless SOURCE_DATE_EPOCH says another time. The same
# sources give the same packages.
find_package(Git QUIET)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  set(epoch $ENV{SOURCE_DATE_EPOCH})
elseif(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} log -1 --format=%ct WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE epoch OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT epoch)
  file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CMakeLists.txt epoch %s UTC)
endif()
set(ENV{SOURCE_DATE_EPOCH} ${epoch})
string(TIMESTAMP HITOS_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
string(TIMESTAMP HITOS_DAY "%Y-%m-%d" UTC)
unset(ENV{SOURCE_DATE_EPOCH})
configure_file(${PROJECT_SOURCE_DIR}/ui/qt/desktop/hitos.metainfo.xml.in
  ${CMAKE_BINARY_DIR}/packaging/hitos.metainfo.xml @ONLY)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hitos)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR Hitos)
set(CPACK_PACKAGE_CONTACT "Hitos maintainers <maintainers@hitos.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_BINARY_DIR}/packaging/options.cmake)
file(CONFIGURE OUTPUT ${CPACK_PROJECT_CONFIG_FILE} @ONLY CONTENT
  "if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  set(ENV{SOURCE_DATE_EPOCH} @epoch@)
endif()
find_program(shlibdeps dpkg-shlibdeps)
if(NOT shlibdeps)
  message(FATAL_ERROR \"Found no dpkg-shlibdeps, without which packages do not say what \
they need; install the package dpkg-dev\")
endif()
")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(version "${PROJECT_VERSION}-${release}")

# hitos_package(COMPONENT NAME SECTION): one package of one component, whose description is
# cmake/packaging/NAME.txt: the summary, an empty line, and the rest.
function(hitos_package component name section)
  string(TOUPPER ${component} key)
  file(READ ${packaging_folder}/${name}.txt text)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${packaging_folder}/${name}.txt)
  string(FIND "${text}" "\n\n" end)
  string(SUBSTRING "${text}" 0 ${end} summary)
  math(EXPR end "${end} + 2")
  string(SUBSTRING "${text}" ${end} -1 description)
  string(STRIP "${description}" description)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)

  set(folder ${CMAKE_BINARY_DIR}/packaging/${name})
  set(HITOS_PACKAGE ${name})
  set(HITOS_RELEASE ${release})
  configure_file(${packaging_folder}/changelog.in ${folder}/changelog.Debian @ONLY)
  add_custom_command(OUTPUT ${folder}/changelog.Debian.gz
    COMMAND gzip -9nkf changelog.Debian WORKING_DIRECTORY ${folder}
    DEPENDS ${folder}/changelog.Debian VERBATIM)
  add_custom_target(changelog_of_${name} ALL DEPENDS ${folder}/changelog.Debian.gz)
  # There is no report of a wish for the package that its first upload could close.
  file(CONFIGURE OUTPUT ${folder}/overrides CONTENT "@name@: initial-upload-closes-no-bugs\n" @ONLY)
  install(FILES ${folder}/overrides RENAME ${name} COMPONENT ${component}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides)
  install(FILES ${folder}/changelog.Debian.gz ${packaging_folder}/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endfunction()

hitos_package(program hitos science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)  # of words in pictures and figures
# What is started, not linked: plots are drawn by gnuplot, films by ffmpeg or ImageMagick; texts of
# Qt's own dialogs; icons are drawn as SVG.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, qt6-translations-l10n")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg | imagemagick, libhitos-dev")

hitos_package(library libhitos-dev libdevel)
# The libraries are static: who links them links what they are made of, and their headers include
# those of some. tests/packaging/packages compares with the CMake package.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS libbz2-dev libcairo2-dev libdxflib-dev libeigen3-dev libfmt-dev
  libfontconfig-dev libfreetype-dev liblz4-dev libopencv-core-dev libopencv-imgproc-dev librandom123-dev
  libspng-dev libsqlite3-dev libtbb-dev libtomlplusplus-dev libturbojpeg0-dev libxxhash-dev libzstd-dev
  nlohmann-json3-dev zlib1g-dev)
list(JOIN CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS ", " CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "cmake, fonts-dejavu-core, g++")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "hitos (= ${version})")

set(CPACK_COMPONENTS_ALL program library)
get_cmake_property(components COMPONENTS)
if(python IN_LIST components)
  hitos_package(python python3-hitos python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The module is made for one minor version of Python.
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~), \
python3 (<< ${Python_VERSION_MAJOR}.${next}), python3-numpy, fonts-dejavu-core")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "hitos (= ${version})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib)  # which the tutorial draws with
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${packaging_folder}/python3-hitos/postinst ${packaging_folder}/python3-hitos/prerm)
  install(DIRECTORY examples/python/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-hitos/examples
    COMPONENT python)
  list(APPEND CPACK_COMPONENTS_ALL python)
else()
  message(STATUS "cpack leaves python3-hitos out: the Python module is not built")
endif()

include(CPack)

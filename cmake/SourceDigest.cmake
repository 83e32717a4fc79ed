# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the header OUT of IN, with the digest of every source under ROOT/include and ROOT/src: programs of
# other sources must not take each other's results for their own.
file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/include/*.hpp ${ROOT}/src/*.hpp
  ${ROOT}/src/*.cpp ${ROOT}/src/*.in ${ROOT}/src/CMakeLists.txt)
list(SORT sources)
set(all "")
foreach(source ${sources})
  file(SHA256 ${ROOT}/${source} digest)
  string(APPEND all "${source} ${digest}\n")
endforeach()
string(SHA256 SOURCE_DIGEST "${all}")
string(SUBSTRING ${SOURCE_DIGEST} 0 32 SOURCE_DIGEST)
configure_file(${IN} ${OUT} @ONLY)

# Texts that name a version name that of the project; files that they name or link to are there.
# -DVERSION= of the project, -DSOURCE= its folder
cmake_minimum_required(VERSION 3.22)
set(wrong "")

function(check_version file pattern)
  file(READ ${SOURCE}/${file} text)
  if(NOT "\n${text}" MATCHES "\n${pattern}")
    message(FATAL_ERROR "${file} has no line '${pattern}'")
  endif()
  if(NOT CMAKE_MATCH_1 STREQUAL VERSION)
    message(FATAL_ERROR "${file} names version ${CMAKE_MATCH_1}; CMakeLists.txt has ${VERSION}")
  endif()
endfunction()
check_version(CITATION.cff "version: ([0-9.]+)\n")
check_version(CHANGELOG.md "## ([0-9.]+)")  # the newest stands first

# Times that README.md states are of this minor version, and name commit and machine.
file(READ ${SOURCE}/README.md text)
string(REGEX REPLACE "[\n ]+" " " text "${text}")
string(REGEX MATCHALL "burnish ([0-9]+\\.[0-9]+)\\.[0-9]+ at commit [0-9a-f]+, [^)]+\\)" measured "${text}")
if(NOT measured)
  message(FATAL_ERROR "README.md states no times with 'burnish VERSION at commit HASH, MACHINE'")
endif()
string(REGEX MATCH "^[0-9]+\\.[0-9]+" minor ${VERSION})
foreach(said IN LISTS measured)
  if(NOT said MATCHES "^burnish ${minor}\\.")
    list(APPEND wrong "README.md: '${said}' is older than ${minor}: measure it again (./test --bare --full)")
  endif()
endforeach()

# check_there(file, place, words...): each word is the path of something, seen from `place`.
macro(check_there file place)
  foreach(word IN ITEMS ${ARGN})
    string(REGEX REPLACE "/$" "" path ${place}/${word})
    file(GLOB there ${path})
    if(NOT there)
      list(APPEND wrong "${file}: there is no '${word}'")
    endif()
  endforeach()
endmacro()

# [text](path#part) in all texts.
file(GLOB_RECURSE texts RELATIVE ${SOURCE} ${SOURCE}/docs/*.md ${SOURCE}/robots/*.md ${SOURCE}/benchmarks/*.md)
set(links 0)
foreach(file IN ITEMS README.md CHANGELOG.md CONTRIBUTING.md ${texts})
  file(READ ${SOURCE}/${file} text)
  string(REGEX REPLACE "[][;]" "\r" text "${text}") # characters that lists of CMake mean something by
  string(REGEX MATCHALL "\r\\([^ )#:]+[)#]" found "${text}")
  get_filename_component(folder ${SOURCE}/${file} DIRECTORY)
  foreach(link IN LISTS found)
    string(REGEX REPLACE "^\r\\(|[)#]$" "" link "${link}")
    check_there(${file} ${folder} ${link})
    math(EXPR links "${links} + 1")
  endforeach()
endforeach()

# `path/of/a/file` in the walk-throughs of CONTRIBUTING.md.
file(READ ${SOURCE}/CONTRIBUTING.md text)
string(REGEX MATCHALL "`(src|include|apps|python|tests|docs|benchmarks|scripts|examples)/[^ `]+" found "${text}")
foreach(path IN LISTS found)
  string(SUBSTRING "${path}" 1 -1 path)
  check_there(CONTRIBUTING.md ${SOURCE} ${path})
endforeach()

list(LENGTH found paths)
if(wrong OR links LESS 50 OR paths LESS 20)
  list(JOIN wrong "\n" wrong)
  message(FATAL_ERROR "${links} links and ${paths} paths:\n${wrong}")
endif()
message(STATUS "texts: ${links} links and ${paths} paths are all good")

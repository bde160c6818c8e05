# The texts that name a version name that of the project.
# -DVERSION= of the project, -DSOURCE= its folder
cmake_minimum_required(VERSION 3.22)

function(check file pattern)
  file(READ ${SOURCE}/${file} text)
  if(NOT "\n${text}" MATCHES "\n${pattern}")
    message(FATAL_ERROR "${file} has no line '${pattern}'")
  endif()
  if(NOT CMAKE_MATCH_1 STREQUAL VERSION)
    message(FATAL_ERROR "${file} names version ${CMAKE_MATCH_1}; CMakeLists.txt has ${VERSION}")
  endif()
endfunction()

check(CITATION.cff "version: ([0-9.]+)\n")
check(CHANGELOG.md "## ([0-9.]+)")  # the newest stands first
message(STATUS "version: all good")

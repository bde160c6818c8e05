# Runs a program that prints the width of its packs, with a loader that may use different levels of the
# processor. -DPROGRAM=
cmake_minimum_required(VERSION 3.22)
set(loader /lib64/ld-linux-x86-64.so.2)
execute_process(COMMAND ${loader} --help OUTPUT_VARIABLE help)

# width_with(mask result): width of the packs if the loader may use only the levels in `mask`.
function(width_with mask result)
  execute_process(COMMAND ${loader} --glibc-hwcaps-mask "${mask}" ${PROGRAM}
    RESULT_VARIABLE failed OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(failed OR NOT out MATCHES "in packs of ([0-9]+)" OR NOT out MATCHES "batch and single agree")
    message(FATAL_ERROR "with mask '${mask}': ${out}")
  endif()
  string(REGEX MATCH "in packs of ([0-9]+)" ignored "${out}")
  set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

foreach(level_and_width ";2" "x86-64-v3;4" "x86-64-v4;8")
  list(GET level_and_width 0 level)
  list(GET level_and_width 1 width)
  if(level AND NOT help MATCHES "${level} \\(supported")
    message(STATUS "this processor does not support ${level}")
    continue()
  endif()
  width_with("${level}" found)
  if(NOT found EQUAL width)
    message(FATAL_ERROR "with mask '${level}': packs of ${found}; wanted ${width}")
  endif()
  message(STATUS "mask '${level}': packs of ${found}")
endforeach()
message(STATUS "hwcaps: all good")

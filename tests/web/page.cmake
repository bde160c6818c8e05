# Makes short runs and uses their pages in a browser: cmake -DPROGRAM=... -DNODE=... -DWEB=...
# -DWORK=... -P page.cmake. WEB is the built copy of web/. Without a browser the test is skipped.
if(DEFINED ENV{CHROMIUM})
  set(chromium $ENV{CHROMIUM})
else()
  find_program(chromium NAMES chromium chromium-browser google-chrome)
endif()
if(NOT chromium)
  message("skipped: no browser (chromium) here")
  return()
endif()
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${PROGRAM} polish --surface table --plant ideal --duration 3 --quiet --out ${WORK}
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${PROGRAM} polish --surface table --duration 1 --controller mpc --quiet
  --set shape.kind=sphere --set shape.hollow=true --set shape.radius=0.6 --out ${WORK}/bowl
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${PROGRAM} solve ${CMAKE_CURRENT_LIST_DIR}/../../examples/problems/reaching_within_limits.yaml
  --quiet --out ${WORK}/plan COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${PROGRAM} show quadruped --html ${WORK}/robot.html
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
set(ENV{CHROMIUM} ${chromium})
foreach(pages "${WORK}/table_mpc/run.html;${WORK}/table_mpc/trace.csv;${WORK}/comparison.html;${WORK}/bowl/table_sphere_mpc/run.html;${WORK}/plan/run.html" "${WORK}/robot.html")
  execute_process(COMMAND ${NODE} test/page.test.mjs ${pages} WORKING_DIRECTORY ${WEB}
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "the page does not do what it should; its folder: ${WORK}")
  endif()
endforeach()
message("web.page: all good")

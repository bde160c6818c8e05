# Builds the page in a copy of web/: cmake -DWEB=... -DCOPY=... -DNPM=... -DPAGE=... -P build_page.cmake
file(GLOB old LIST_DIRECTORIES true ${COPY}/*)
list(REMOVE_ITEM old ${COPY}/node_modules)
if(old)
  file(REMOVE_RECURSE ${old})
endif()
file(COPY ${WEB}/ DESTINATION ${COPY} PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE)
execute_process(COMMAND ${NPM} run --silent build WORKING_DIRECTORY ${COPY}
  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed OR NOT EXISTS ${COPY}/dist/page.html)
  message(FATAL_ERROR "web/ does not build (-DBURNISH_PAGE=OFF leaves the page out):\n${said}")
endif()
file(COPY_FILE ${COPY}/dist/page.html ${PAGE})

# Installs burnish into a separate folder, builds the project beside this file against it, and runs it.
# -DBUILD= the build to install, -DVERSION= its version, -DWORK= where to work, -DGENERATOR= -DCOMPILER=
# -DEIGEN= include folder, -DX86= whether -mavx2 exists, -DHEADERS= whether to compile each header alone,
# -DPAGE= whether the page of runs was built, -DPYTHON=, -DJOBS=
cmake_minimum_required(VERSION 3.22)
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

function(run name)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${name} failed:\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

run("installation" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
# The library must not need the source tree or its prefix: the installation is moved.
file(RENAME ${prefix} ${WORK}/moved)
set(prefix ${WORK}/moved)

# find_package must not accept another minor version or a newer version.
string(REGEX MATCH "^([0-9]+)\\.([0-9]+)\\." wanted ${VERSION})
set(major ${CMAKE_MATCH_1})
set(minor ${CMAKE_MATCH_2})
math(EXPR next "${minor} + 1")
foreach(other IN ITEMS 0.1 ${major}.${next} ${VERSION}.1)
  find_package(burnish ${other} QUIET PATHS ${prefix} NO_DEFAULT_PATH)
  if(burnish_FOUND OR NOT burnish_CONSIDERED_VERSIONS STREQUAL VERSION)
    message(FATAL_ERROR "burnish ${VERSION} was accepted as ${other}, or not found: '${burnish_CONSIDERED_VERSIONS}'")
  endif()
endforeach()
message(STATUS "burnish ${VERSION} is not accepted as another version")

# The loop for a robot in docs/polishing.md, with a plant in place of the robot.
set(on_a_robot "")
if(EXISTS ${prefix}/include/burnish/tasks AND EXISTS ${prefix}/bin/burnish)
  file(READ ${CMAKE_CURRENT_LIST_DIR}/../../docs/polishing.md page)
  string(REGEX MATCH "## On a robot.*" page "${page}")
  string(FIND "${page}" "```cpp" begin)
  math(EXPR begin "${begin} + 7")
  string(SUBSTRING "${page}" ${begin} -1 page)
  string(FIND "${page}" "```" end)
  string(SUBSTRING "${page}" 0 ${end} program)
  string(REGEX MATCHALL "#include[^\n]*\n" PAGE_INCLUDES "${program}")
  string(REPLACE ";" "" PAGE_INCLUDES "${PAGE_INCLUDES}")
  string(REGEX REPLACE "#include[^\n]*\n" "" PAGE_BODY "${program}")
  string(REPLACE "Measurement measurement;" "make_robot(setting, task.tick_rate);\nMeasurement measurement;" PAGE_BODY "${PAGE_BODY}")
  set(on_a_robot ${WORK}/on_a_robot.cpp)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/on_a_robot.cpp.in ${on_a_robot} @ONLY)
  file(COPY_FILE ${prefix}/share/burnish/tasks/polishing/table.yaml ${WORK}/mine.yaml)
endif()

foreach(native ON OFF)
  set(consumer ${WORK}/consumer_native_${native})
  run("configuring the consumer" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${consumer}
    -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${prefix} -DCONSUMER_NATIVE=${native} -DCONSUMER_HEADERS=${HEADERS}
    -DCONSUMER_WANTS=${major}.${minor} -DCONSUMER_ON_A_ROBOT=${on_a_robot})
  set(HEADERS OFF)  # checked once
  run("building the consumer" ${CMAKE_COMMAND} --build ${consumer} -j ${JOBS})
  file(READ ${consumer}/robots_dir robots)
  if(NOT robots STREQUAL "${prefix}/share/burnish/robots")
    message(FATAL_ERROR "burnish_ROBOTS_DIR is ${robots}")
  endif()
  run("the consumer" ${CMAKE_COMMAND} -E env BURNISH_ROBOTS=${robots} ${consumer}/consumer)
  string(STRIP "${output}" output)
  if(NOT output MATCHES "^30.0 N along .z of the surface, on tool, by the world")
    message(FATAL_ERROR "the consumer printed: ${output}")
  endif()
  message(STATUS "consumer with -march=native ${native}: ${output}")
  run("one layer alone" ${consumer}/one_layer)
  if(on_a_robot)
    run("the program of docs/polishing.md" ${CMAKE_COMMAND} -E chdir ${WORK} ${CMAKE_COMMAND} -E env
      BURNISH_ROBOTS=${robots} ${consumer}/on_a_robot)
    if(NOT output MATCHES "presses with (29|30|31)[.]")
      message(FATAL_ERROR "the program of docs/polishing.md printed: ${output}")
    endif()
    set(on_a_robot "")  # checked once
  endif()
endforeach()

# The installed command line runs from the folder that it was moved to.
if(EXISTS ${prefix}/bin/burnish)
  # A robot that exists only in the moved installation.
  file(COPY ${prefix}/share/burnish/robots/arm7/ DESTINATION ${prefix}/share/burnish/robots/only_here)
  run("the installed command line" ${CMAKE_COMMAND} -E env --unset=BURNISH_ROBOTS
    ${prefix}/bin/burnish show only_here)
  message(STATUS "the installed command line runs, and finds the robots")
  foreach(text IN ITEMS man/man1/burnish.1 bash-completion/completions/burnish
      zsh/vendor-completions/_burnish fish/vendor_completions.d/burnish.fish)
    file(READ ${prefix}/share/${text} contents)
    if(NOT contents MATCHES "polish")
      message(FATAL_ERROR "${text} was installed without its contents")
    endif()
  endforeach()
  message(STATUS "the manual page and the completions of three shells are installed")
endif()

# The licences of third parties are installed.
file(READ ${prefix}/share/doc/burnish/third_party_licences.txt licences)
set(wanted "libeigen3-dev")
if(PAGE)
  list(APPEND wanted "three.js authors" "Leon Sorokin")
endif()
foreach(name IN LISTS wanted)
  if(NOT licences MATCHES "${name}")
    message(FATAL_ERROR "third_party_licences.txt does not name ${name}")
  endif()
endforeach()
if(NOT EXISTS ${prefix}/share/doc/burnish/LICENSE)
  message(FATAL_ERROR "the licence is not installed")
endif()

# The installed Python package runs from the moved folder.
file(GLOB python_package ${prefix}/lib/python3*/site-packages)
if(python_package)
  run("the installed Python package" ${CMAKE_COMMAND} -E env --unset=BURNISH_ROBOTS
    PYTHONPATH=${python_package} ${PYTHON} -c
    "import burnish\nprint(burnish.__file__, burnish.load_robot('only_here'))")
  if(NOT output MATCHES "^${python_package}")
    message(FATAL_ERROR "another Python package than the installed one was imported: ${output}")
  endif()
  message(STATUS "the installed Python package runs, and finds the robots")
endif()

set(flags "")
if(X86)
  set(flags -mavx2)
endif()
execute_process(COMMAND ${COMPILER} -std=c++20 ${flags} -fsyntax-only -I ${prefix}/include
  -isystem ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/bare.cpp RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result EQUAL 0 OR NOT errors MATCHES "link burnish::burnish in CMake, or define")
  message(FATAL_ERROR "a consumer without the definitions did not fail with the expected message:\n${errors}")
endif()
message(STATUS "a consumer without the definitions fails with a message")
message(STATUS "package: all good")

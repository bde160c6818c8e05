# Test of scripts/arrow: it finds no violations in this project, and all violations in a made-up project.
#   cmake -DSOURCE=... -DWORK=... -DPYTHON=... -P arrow.cmake
execute_process(COMMAND ${PYTHON} ${SOURCE}/scripts/arrow RESULT_VARIABLE status OUTPUT_VARIABLE said)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${said}")
endif()
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/src/CMakeLists.txt "burnish_layer(base SOURCES base/low.cpp)
burnish_layer(middle SOURCES middle/b.cpp LINK burnish_base)
burnish_layer(high SOURCES middle/c.cpp LINK burnish_middle)\n")
file(WRITE ${WORK}/src/base/low.cpp "#include \"middle/b.hpp\"\n")
file(WRITE ${WORK}/src/middle/b.hpp "#include \"burnish/high/c.hpp\"\n#include \"burnish/tasks/polishing/task.hpp\"\n")
file(WRITE ${WORK}/src/attic/d.cpp "")
file(WRITE ${WORK}/include/burnish/high/c.hpp "#include \"middle/b.hpp\"\n")
file(WRITE ${WORK}/apps/burnish/signals.hpp "")
file(WRITE ${WORK}/tasks/polishing/run.cpp "#include \"signals.hpp\"\n")
file(WRITE ${WORK}/src/middle/c.hpp "#include \"middle/b.hpp\"\n")
file(WRITE ${WORK}/docs/architecture.md "## Inside `middle`\n\n| parts |\n| --- |\n| `c`, `b` |\n| `a` |\n\n## More\n")
execute_process(COMMAND ${PYTHON} ${SOURCE}/scripts/arrow ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE said)
set(wanted "src/CMakeLists.txt: middle/c.cpp is compiled into the layer high, whose folder is src/high
src/attic: there is no layer of that name in src/CMakeLists.txt
src/base/low.cpp: middle/b.hpp belongs to the layer middle; base may include no other layer
src/middle/b.hpp: burnish/high/c.hpp belongs to the layer high; middle may include only base, math
src/middle/b.hpp: burnish/tasks/polishing/task.hpp belongs to a task; layers must not include tasks
include/burnish/high/c.hpp: middle/b.hpp is not installed; an installed header must not include it
tasks/polishing/run.cpp: signals.hpp belongs to a program; layers and tasks must not include programs
docs/architecture.md: a is no part of layer middle
src/middle/c.hpp: middle/b.hpp stands after c in docs/architecture.md
")
if(NOT status EQUAL 1 OR NOT said STREQUAL wanted)
  message(FATAL_ERROR "status ${status}\n${said}wanted 1\n${wanted}")
endif()

# scripts/arrow finds nothing in this project, and in another what runs against the arrow there.
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
execute_process(COMMAND ${PYTHON} ${SOURCE}/scripts/arrow ${WORK} RESULT_VARIABLE status OUTPUT_VARIABLE said)
set(wanted "src/CMakeLists.txt: middle/c.cpp is compiled into the layer high, whose folder is src/high
src/attic: there is no layer of that name in src/CMakeLists.txt
src/base/low.cpp: middle/b.hpp is of the layer middle, and base may know no other
src/middle/b.hpp: burnish/high/c.hpp is of the layer high, and middle may know base, math alone
src/middle/b.hpp: burnish/tasks/polishing/task.hpp is of a task, which no layer knows
include/burnish/high/c.hpp: middle/b.hpp is of what is not installed, and this header is
tasks/polishing/run.cpp: signals.hpp is of a program, which neither layers nor tasks know
")
if(NOT status EQUAL 1 OR NOT said STREQUAL wanted)
  message(FATAL_ERROR "status ${status}\n${said}wanted 1\n${wanted}")
endif()

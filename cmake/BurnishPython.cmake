# Finds a Python with NumPy, and pybind11; sets burnish_python_found. Tries python3 in the PATH, then
# /usr/bin/python3. -DPython3_EXECUTABLE=... selects another one.
set(burnish_python_found OFF)
if(NOT Python3_EXECUTABLE)
  foreach(candidate python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, sys; print(sys.executable)"
      OUTPUT_VARIABLE burnish_python OUTPUT_STRIP_TRAILING_WHITESPACE
      RESULT_VARIABLE burnish_python_result ERROR_QUIET)
    if(burnish_python_result EQUAL 0)
      set(Python3_EXECUTABLE ${burnish_python} CACHE FILEPATH "Python for which the package is built")
      break()
    endif()
  endforeach()
endif()
if(Python3_EXECUTABLE)
  find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
  set(PYTHON_EXECUTABLE ${Python3_EXECUTABLE})
  find_package(pybind11 2.10 CONFIG QUIET)
  if(Python3_Development.Module_FOUND AND pybind11_FOUND)
    set(burnish_python_found ON)
  endif()
endif()

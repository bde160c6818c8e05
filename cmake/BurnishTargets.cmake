# Functions that make the targets of the project, one per kind of target, and their flags.
include(CMakePackageConfigHelpers)

# Components of the installation: library (shared libraries), development (headers, CMake files and static
# libraries), program (command line, robots, tasks), python, documents (licences).

# A new minor version can be incompatible, so that its libraries have other names.
set(BURNISH_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Installed files find their libraries by relative paths, so that the installation can be moved.
if(NOT DEFINED CMAKE_INSTALL_RPATH)
  file(RELATIVE_PATH burnish_lib_from_bin
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  if(APPLE)
    set(CMAKE_INSTALL_RPATH "@loader_path;@loader_path/${burnish_lib_from_bin}")
  else()
    set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/${burnish_lib_from_bin}")
  endif()
endif()

# Unity builds compile several sources as one. A full build takes a third of the time, because most of the time
# is spent in headers. -DCMAKE_UNITY_BUILD=OFF is faster after a change of a single source.
if(NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
endif()
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()

find_program(BURNISH_CCACHE ccache)
if(BURNISH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${BURNISH_CCACHE})
endif()

# Flags of all targets of the project. They are not passed to consumers.
add_library(burnish_flags INTERFACE)
target_compile_features(burnish_flags INTERFACE cxx_std_20)
target_compile_options(burnish_flags INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual -Wcast-align
  -Wno-psabi -fno-math-errno
  # GCC 12 warns about its own AVX-512 intrinsics and std::string (its bugs 105593 and 105651), and
  # about Eigen's wide stores to small vectors.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-uninitialized>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds>
  # In unity builds, GCC treats sources as headers.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
  # Delays garbage collection, which saves 1/15 of the compile time.
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>
  $<$<BOOL:${BURNISH_NATIVE}>:-march=native>
  $<$<BOOL:${BURNISH_WERROR}>:-Werror>)
if(BURNISH_SANITIZE)
  target_compile_options(burnish_flags INTERFACE -fsanitize=${BURNISH_SANITIZE}
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(burnish_flags INTERFACE -fsanitize=${BURNISH_SANITIZE})
endif()

# Remedies for a false FOUND_VARIABLE of a part.
set(burnish_remedy_MUJOCO_LIBRARY "install libmujoco-dev, or set CMAKE_PREFIX_PATH")
set(burnish_remedy_MUJOCO_INCLUDE_DIR "install libmujoco-dev, or set CMAKE_PREFIX_PATH")
set(burnish_remedy_assimp_FOUND "install libassimp-dev")
set(burnish_remedy_benchmark_FOUND "install libbenchmark-dev")
set(burnish_remedy_CLI11_FOUND "install libcli11-dev")
set(burnish_remedy_tinyxml2_FOUND "install libtinyxml2-dev")
set(burnish_remedy_yaml-cpp_FOUND "install libyaml-cpp-dev")
set(burnish_remedy_fmt_FOUND "install libfmt-dev")
set(burnish_remedy_nlohmann_json_FOUND "install nlohmann-json3-dev")
set(burnish_remedy_burnish_python_found
  "run scripts/setup --python, or set -DPython3_EXECUTABLE=... to a Python with NumPy, headers and pybind11")

# burnish_part(OPTION "name" FOUND_VARIABLE...): prints whether an optional part is built, and sets
# BURNISH_OPTION to OFF in the calling scope if a dependency is missing. If the option was set to ON, a missing
# dependency is an error.
function(burnish_part option what)
  set(missing "")
  foreach(found IN LISTS ARGN)
    if(NOT ${found})
      if(DEFINED burnish_remedy_${found})
        list(APPEND missing "${burnish_remedy_${found}}")
      else()
        list(APPEND missing "${found} is off")
      endif()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES missing)
  list(JOIN missing "; " missing)
  if(missing AND DEFINED CACHE{BURNISH_${option}} AND NOT BURNISH_${option} STREQUAL "AUTO")
    message(FATAL_ERROR "burnish: BURNISH_${option} is ${BURNISH_${option}}, and ${what} cannot be built (${missing}); "
      "-DBURNISH_${option}=AUTO builds it only if all dependencies are found")
  elseif(missing)
    message(STATUS "burnish: ${what}: off (${missing})")
    set(BURNISH_${option} OFF PARENT_SCOPE)
  else()
    message(STATUS "burnish: ${what}: on")
    set(BURNISH_${option} ON PARENT_SCOPE)
  endif()
endfunction()

# burnish_variants(name): builds a layer again for newer processors, as shared libraries that the loader of the C
# library prefers on processors that support them (glibc-hwcaps). Only layers with faster kernels use this.
# All variants have the same binary interface (base/views.hpp). Variants of different layers cannot be mixed,
# because packs of different widths are different symbols.
function(burnish_variants name)
  get_target_property(sources burnish_${name} SOURCES)
  get_target_property(links burnish_${name} LINK_LIBRARIES)
  foreach(level IN ITEMS x86-64-v3 x86-64-v4)
    set(variant burnish_${name}_${level})
    add_library(${variant} SHARED ${sources})
    set_target_properties(${variant} PROPERTIES OUTPUT_NAME burnish_${name}
      VERSION ${PROJECT_VERSION} SOVERSION ${BURNISH_SOVERSION}
      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/glibc-hwcaps/${level}
      # The loader chooses the variants of the other layers from the folder of the plain libraries.
      INSTALL_RPATH "$ORIGIN/../.." BUILD_RPATH "${CMAKE_CURRENT_BINARY_DIR}")
    get_target_property(definitions burnish_${name} COMPILE_DEFINITIONS)
    target_compile_definitions(${variant} PRIVATE ${definitions})
    target_include_directories(${variant} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
    target_compile_options(${variant} PRIVATE -march=${level})
    target_link_libraries(${variant} PRIVATE ${links})
    add_dependencies(burnish_${name} ${variant})
    install(TARGETS ${variant} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/${level}
      COMPONENT library NAMELINK_SKIP)
  endforeach()
endfunction()

# burnish_layer(name [VARIANTS] [INTERNAL] SOURCES ... LINK ... PRIVATE_LINK ...): makes a layer, the target
# burnish::name. VARIANTS: see burnish_variants(). INTERNAL: a static library for the programs of the project,
# which is not installed.
function(burnish_layer name)
  cmake_parse_arguments(arg "VARIANTS;INTERNAL" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  set(kind "")
  if(arg_INTERNAL)
    set(kind STATIC)
  endif()
  add_library(burnish_${name} ${kind} ${arg_SOURCES})
  add_library(burnish::${name} ALIAS burnish_${name})
  set_target_properties(burnish_${name} PROPERTIES
    EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON VERSION ${PROJECT_VERSION} SOVERSION ${BURNISH_SOVERSION})
  target_compile_features(burnish_${name} PUBLIC cxx_std_20)
  target_include_directories(burnish_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_include_directories(burnish_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  # See include/burnish/base/views.hpp.
  target_compile_definitions(burnish_${name} PUBLIC
    EIGEN_MAX_ALIGN_BYTES=16 EIGEN_MAX_STATIC_ALIGN_BYTES=16 EIGEN_MALLOC_ALREADY_ALIGNED=0)
  target_link_libraries(burnish_${name} PUBLIC Eigen3::Eigen ${arg_LINK}
    PRIVATE $<BUILD_INTERFACE:burnish_flags> ${arg_PRIVATE_LINK})
  if(arg_INTERNAL)
    target_include_directories(burnish_${name} INTERFACE ${PROJECT_SOURCE_DIR}/src)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY BURNISH_LAYERS burnish_${name})
  if(arg_VARIANTS AND BURNISH_HWCAPS)
    burnish_variants(${name})
  endif()
endfunction()

# burnish_alone(sources...): excludes sources from unity builds: kernels, whose machine code must not depend on
# other sources, and sources with a long compile time.
function(burnish_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# burnish_cold(targets...): compiles targets that are not critical for speed with -O1, which takes a quarter less
# time: readers, writers, plots and tests.
function(burnish_cold)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endforeach()
endfunction()

# burnish_program(name SOURCES ... LINK ...): makes an executable.
function(burnish_program name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE burnish_flags ${arg_LINK})
endfunction()

function(burnish_install_package)
  get_property(layers GLOBAL PROPERTY BURNISH_LAYERS)
  install(TARGETS ${layers} EXPORT burnishTargets ARCHIVE COMPONENT development
    LIBRARY COMPONENT library NAMELINK_COMPONENT development)
  set(where ${CMAKE_INSTALL_LIBDIR}/cmake/burnish)
  set(burnish_robots_install_dir ${CMAKE_INSTALL_DATADIR}/burnish/robots)
  install(EXPORT burnishTargets NAMESPACE burnish:: DESTINATION ${where} COMPONENT development)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/burnishConfig.cmake.in
    ${PROJECT_BINARY_DIR}/burnishConfig.cmake INSTALL_DESTINATION ${where}
    PATH_VARS burnish_robots_install_dir)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/burnishConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/burnishConfig.cmake
    ${PROJECT_BINARY_DIR}/burnishConfigVersion.cmake DESTINATION ${where} COMPONENT development)
endfunction()

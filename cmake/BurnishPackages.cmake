# Debian packages, one per component, made by `cpack` in a build with BURNISH_PACKAGES (preset packages), for
# all processors of this architecture and with Debian's folders.
if(NOT BURNISH_HWCAPS OR NOT BURNISH_APPS OR NOT BURNISH_PYTHON)
  message(FATAL_ERROR "BURNISH_PACKAGES needs the command line (${BURNISH_APPS}), Python (${BURNISH_PYTHON}) "
    "and kernels chosen at run time (BURNISH_HWCAPS, ${BURNISH_HWCAPS}); the preset packages enables them")
endif()
set(BURNISH_MAINTAINER "burnish authors <burnish@example.org>" CACHE STRING "Maintainer of the packages")

set(burnish_package_library libburnish${BURNISH_SOVERSION})
set(burnish_package_development libburnish-dev)
set(burnish_package_program burnish)
set(burnish_package_python python3-burnish)
set(components library development program python)

# Copyright and changelog of each package.
set(papers ${PROJECT_BINARY_DIR}/debian)
add_custom_command(OUTPUT ${papers}/copyright ${papers}/changelog.gz ${papers}/CHANGELOG.md.gz
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DLICENCES=${burnish_licences} -DOUT=${papers}
    -DVERSION=${PROJECT_VERSION} "-DMAINTAINER=${BURNISH_MAINTAINER}"
    -P ${CMAKE_CURRENT_LIST_DIR}/debian/papers.cmake
  DEPENDS ${burnish_licences} ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    ${CMAKE_CURRENT_LIST_DIR}/debian/papers.cmake
  COMMENT "Writing copyright and changelog" VERBATIM)
add_custom_target(burnish_papers ALL DEPENDS ${papers}/copyright)
add_dependencies(burnish_papers burnish_licences)
foreach(component IN LISTS components)
  install(FILES ${papers}/copyright ${papers}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${burnish_package_${component}} COMPONENT ${component})
endforeach()
install(FILES ${papers}/CHANGELOG.md.gz README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program PATTERN __pycache__ EXCLUDE)

# debian_package(component SECTION ... [DEPENDS ...] [RECOMMENDS ...] [CONTROL files...] DESCRIPTION "..."):
# sets the fields of a package. dpkg-shlibdeps finds the libraries that it is linked with.
function(debian_package component)
  cmake_parse_arguments(arg "" "SECTION;DESCRIPTION" "DEPENDS;RECOMMENDS;CONTROL" ${ARGN})
  string(TOUPPER ${component} upper)
  list(JOIN arg_DEPENDS ", " depends)
  list(JOIN arg_RECOMMENDS ", " recommends)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${burnish_package_${component}} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${arg_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS "${recommends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${arg_CONTROL}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${arg_DESCRIPTION}" PARENT_SCOPE)
endfunction()

set(what "burnish computes the contact dynamics of a robot and its exact derivatives in
whatever reference frame a task calls for, solves optimal control problems on
them, and runs the solution as model predictive control.
")
set(same "(= ${PROJECT_VERSION})")
# Programs that are linked with these libraries need this package. Variants for newer processors have the
# same names.
get_property(layers GLOBAL PROPERTY BURNISH_LAYERS)
set(shlibs "")
foreach(layer IN LISTS layers)
  get_target_property(type ${layer} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    string(APPEND shlibs
      "lib${layer} ${BURNISH_SOVERSION} ${burnish_package_library} (>= ${PROJECT_VERSION})\n")
  endif()
endforeach()
file(CONFIGURE OUTPUT ${papers}/shlibs CONTENT "${shlibs}")
file(CONFIGURE OUTPUT ${papers}/triggers CONTENT "activate-noawait ldconfig\n")
debian_package(library SECTION libs CONTROL ${papers}/shlibs ${papers}/triggers DESCRIPTION
  "contact dynamics, its derivatives and optimal control (shared libraries)
${what}
These are the shared libraries. Those that compute come for x86-64, x86-64-v3
(AVX2) and x86-64-v4 (AVX-512), of which the loader takes what suits the
processor.")
debian_package(development SECTION libdevel
  DEPENDS "${burnish_package_library} ${same}" "${burnish_package_program} ${same}" "libeigen3-dev (>= 3.4)"
    libtinyxml2-dev libyaml-cpp-dev
  DESCRIPTION "contact dynamics, its derivatives and optimal control (C++)
${what}
These are the headers and what CMake needs to find the libraries with
find_package(burnish).")
debian_package(program SECTION science
  DEPENDS "${burnish_package_library} ${same}"
  DESCRIPTION "contact dynamics, optimal control and polishing with robots
${what}
This is the command line, with five robots and the polishing task.")
math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
debian_package(python SECTION python
  DEPENDS "${burnish_package_library} ${same}" "${burnish_package_program} ${same}" python3-numpy
    "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})" "python3 (<< ${Python3_VERSION_MAJOR}.${next_python})"
  RECOMMENDS python3-matplotlib python3-distributed python3-scipy python3-h5py python3-nlopt
  CONTROL ${CMAKE_CURRENT_LIST_DIR}/debian/postinst ${CMAKE_CURRENT_LIST_DIR}/debian/prerm
  DESCRIPTION "contact dynamics, its derivatives and optimal control (Python 3)
${what}
This is the package for Python 3: import burnish.")

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own summary
set(CPACK_PACKAGE_CONTACT "${BURNISH_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian/compress_manuals.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SOURCE burnish)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src ${PROJECT_BINARY_DIR}/tasks)
include(CPack)

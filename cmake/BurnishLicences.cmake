# third_party_licences.txt: licences of third-party code in the programs and libraries, for redistribution.
# The head of the page of runs lists its parts. The other code is headers, whose licences come from Debian's
# packages.
set(burnish_licences ${PROJECT_BINARY_DIR}/third_party_licences.txt)
set(burnish_header_packages libeigen3-dev)
if(BURNISH_APPS)
  list(APPEND burnish_header_packages libcli11-dev)
endif()
if(yaml-cpp_FOUND AND nlohmann_json_FOUND)
  list(APPEND burnish_header_packages nlohmann-json3-dev)
endif()
if(BURNISH_PYTHON)
  list(APPEND burnish_header_packages pybind11-dev)
endif()
set(burnish_page "")
if(BURNISH_PAGE)
  set(burnish_page ${burnish_page_file})
endif()

add_custom_command(OUTPUT ${burnish_licences}
  COMMAND ${CMAKE_COMMAND} "-DPAGE=${burnish_page}" "-DPACKAGES=${burnish_header_packages}"
    -DOUT=${burnish_licences} -P ${CMAKE_CURRENT_LIST_DIR}/collect_licences.cmake
  DEPENDS ${burnish_page} ${CMAKE_CURRENT_LIST_DIR}/collect_licences.cmake
  COMMENT "Collecting licences" VERBATIM)
add_custom_target(burnish_licences ALL DEPENDS ${burnish_licences})
if(TARGET burnish_page)
  add_dependencies(burnish_licences burnish_page)
endif()
install(FILES LICENSE ${burnish_licences} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)

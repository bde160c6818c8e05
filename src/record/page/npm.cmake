# burnish_find_npm(result): the command that runs npm, of this machine, or else fetched from npm's
# registry into the build folder; empty without either.
set(burnish_npm_version 10.9.9) # the newest for Node 18
set(burnish_npm_sha512
  d60fba8cb42f688b81e33c2f1cbef2ad7b977166700ec0ad057f1b6d60ea6ef2524abf673e20c35931cd8305d1dbb8887134d6eefdc0e7b8435bd458bf65b862)

# npm's own settings say where its registry is.
function(burnish_npm_registry result)
  set(registry "$ENV{npm_config_registry}")
  if(NOT registry AND EXISTS "$ENV{HOME}/.npmrc")
    file(STRINGS "$ENV{HOME}/.npmrc" registry REGEX "^registry *=" LIMIT_COUNT 1)
    string(REGEX REPLACE "^registry *= *" "" registry "${registry}")
  endif()
  if(NOT registry)
    set(registry https://registry.npmjs.org)
  endif()
  string(REGEX REPLACE "/+$" "" registry "${registry}")
  set(${result} ${registry} PARENT_SCOPE)
endfunction()

function(burnish_find_npm result)
  find_program(BURNISH_NPM npm)
  if(BURNISH_NPM)
    set(${result} ${BURNISH_NPM} PARENT_SCOPE)
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/npm-${burnish_npm_version})
  set(program ${folder}/package/bin/npm-cli.js)
  set(${result} ${BURNISH_NODE} ${program} PARENT_SCOPE)
  if(EXISTS ${program})
    return()
  endif()
  burnish_npm_registry(registry)
  # Without EXPECTED_HASH, with which a failed download would be an error.
  file(DOWNLOAD ${registry}/npm/-/npm-${burnish_npm_version}.tgz ${folder}.tgz
    STATUS status TIMEOUT 60 INACTIVITY_TIMEOUT 20)
  list(GET status 0 failed)
  if(NOT failed)
    file(SHA512 ${folder}.tgz found)
    if(NOT found STREQUAL burnish_npm_sha512)
      set(failed ON)
    endif()
  endif()
  if(failed)
    set(${result} "" PARENT_SCOPE)
  else()
    # Renamed when it is whole: half of it, after an interruption, is never taken for npm.
    file(ARCHIVE_EXTRACT INPUT ${folder}.tgz DESTINATION ${folder}.part)
    file(RENAME ${folder}.part ${folder})
  endif()
  file(REMOVE ${folder}.tgz)
endfunction()

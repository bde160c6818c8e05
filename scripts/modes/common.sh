# Common functions of the modes of ./test, which sources this file after setting setup, builds,
# cmake_arguments and ctest_arguments. The CMake flags of a mode are its preset in CMakePresets.json.

JOBS=$(scripts/jobs)
export JOBS

say() { printf '\n== %s\n' "$*"; }

install_packages() { # scripts/setup arguments...
  [[ $setup == no ]] || scripts/setup "$@"
}

configure() { # preset, build folder, cmake arguments...
  local preset=$1 build=$2
  shift 2
  local generator=()
  mkdir -p "$build"
  # A folder that was configured by hand keeps its generator.
  [[ ! -e $build/CMakeCache.txt ]] ||
    generator=(-G "$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$build/CMakeCache.txt")")
  if ! cmake --preset "$preset" -B "$build" ${generator[@]+"${generator[@]}"} "$@" \
    ${cmake_arguments[@]+"${cmake_arguments[@]}"} >"$build/configure.log" 2>&1; then
    cat "$build/configure.log"
    echo "test: configuring $build failed" >&2
    return 1
  fi
  grep -E 'burnish:' "$build/configure.log" || true
}

ctest_in() { # preset, build folder
  ctest --preset "$1" --test-dir "$2" -j "$JOBS" \
    ${ctest_arguments[@]+"${ctest_arguments[@]}"} | grep --line-buffered -vE '^ +Start +[0-9]+:'
}

build_and_test() { # preset, build folder, cmake arguments...
  configure "$@"
  cmake --build "$2" -j "$JOBS"
  ctest_in "$1" "$2"
}

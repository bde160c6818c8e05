# --aarch64     tests of the core for 64-bit ARM, cross-compiled and run in QEMU, in build-aarch64/

run_aarch64() {
  install_packages --aarch64
  local build=$builds-aarch64
  mkdir -p "$build"
  build=$(cd "$build" && pwd)
  # Debian has GoogleTest as a library only for its own machine, and as source code for others.
  local googletest=$build/googletest log=$build/googletest.log
  if ! { cmake -S /usr/src/googletest -B "$googletest" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_INSTALL_PREFIX=$build/prefix" "-DBURNISH_AARCH64_PREFIX=$build/prefix" \
    "-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/aarch64-linux-gnu.cmake" &&
    cmake --build "$googletest" -j "$JOBS" --target install; } >"$log" 2>&1; then
    cat "$log"
    echo "test: building GoogleTest for ARM failed" >&2
    return 1
  fi
  build_and_test aarch64 "$build" "-DBURNISH_AARCH64_PREFIX=$build/prefix" "-DCMAKE_PREFIX_PATH=$build/prefix"
}

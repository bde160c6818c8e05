# --long        everything that there is to build, benchmarks too, and all tests with ten times the random
#               states, in build/; campaigns with workers that are killed

run_long() {
  install_packages --long
  configure default "$builds"
  cmake --build "$builds" -j "$JOBS" --target all burnish_benchmarks
  export BURNISH_TEST_STATES=${BURNISH_TEST_STATES:-1000} BURNISH_TEST_LONG=1
  ctest_in default "$builds"
}

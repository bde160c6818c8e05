# --long        everything that there is to build, benchmarks too, and all tests with ten times the random
#               states, in build/; campaigns with workers that are killed. With BURNISH_PUBLIC_ROBOTS=DIR
#               the first command on the robots of that folder: docs/public_robots.md

run_long() {
  install_packages --long
  configure default "$builds"
  cmake --build "$builds" -j "$JOBS" --target all burnish_benchmarks
  export BURNISH_TEST_STATES=${BURNISH_TEST_STATES:-1000} BURNISH_TEST_LONG=1
  ctest_in default "$builds"
  if [[ -n ${BURNISH_PUBLIC_ROBOTS:-} ]]; then
    # That some robot does not do it (1) is a result, which the tables have.
    "$builds/apps/burnish/burnish" experiment robots --folder "$BURNISH_PUBLIC_ROBOTS" \
      --out "$builds/public_robots" --force || (($? == 1))
  fi
}

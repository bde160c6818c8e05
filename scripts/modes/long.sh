# --long        everything that there is to build, benchmarks too, and all tests with ten times the random
#               states, in build/; campaigns with workers that are killed. With BURNISH_PUBLIC_ROBOTS=DIR
#               the first command on the robots of that folder: docs/public_robots.md. Last the golden runs:
#               this tree against the commit before it, or against BURNISH_GOLDEN=COMMIT; empty: against none

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
  golden_runs
}

# A branch that is merged is compared as a whole: HEAD^ is the main line before it.
golden_runs() {
  local parent=${BURNISH_GOLDEN-HEAD^}
  if [[ -z $parent ]]; then
    return
  fi
  say "Golden runs against $parent"
  if [[ -z ${BURNISH_GOLDEN:-} ]] && ! git rev-parse --verify --quiet 'HEAD^' >/dev/null 2>&1; then
    echo "left out: no commit before this one is here"
    return
  fi
  scripts/golden "$parent" --build "$builds"
}

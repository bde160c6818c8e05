# --long        all targets with benchmarks, and all tests with ten times the random states, in build/;
#               campaigns with workers that are killed. With BURNISH_PUBLIC_ROBOTS=DIR, the first command
#               of docs/public_robots.md on the robots of that folder. Last, golden runs: comparison with
#               the previous commit, or with BURNISH_GOLDEN=COMMIT; skipped if that is empty

run_long() {
  install_packages --long
  configure default "$builds"
  cmake --build "$builds" -j "$JOBS" --target all burnish_benchmarks
  export BURNISH_TEST_STATES=${BURNISH_TEST_STATES:-1000} BURNISH_TEST_LONG=1
  ctest_in default "$builds"
  if [[ -n ${BURNISH_PUBLIC_ROBOTS:-} ]]; then
    # Exit code 1, a robot that fails, is a result in the tables.
    "$builds/apps/burnish/burnish" experiment robots --folder "$BURNISH_PUBLIC_ROBOTS" \
      --out "$builds/public_robots" --force || (($? == 1))
  fi
  golden_runs
}

# For a merge, HEAD^ is the main branch before it, so that the whole merged branch is compared.
golden_runs() {
  local parent=${BURNISH_GOLDEN-HEAD^}
  if [[ -z $parent ]]; then
    return
  fi
  say "golden runs against $parent"
  if [[ -z ${BURNISH_GOLDEN:-} ]] && ! git rev-parse --verify --quiet 'HEAD^' >/dev/null 2>&1; then
    echo "skipped: this repository has no earlier commit"
    return
  fi
  scripts/golden "$parent" --build "$builds"
}

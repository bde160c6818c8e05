# --coverage    fraction of lines that the tests reach, for each layer; all lines are in
#               build-coverage/coverage/index.html

run_coverage() {
  install_packages --coverage
  # Removes counts of an earlier run, which belong to other sources.
  [[ ! -d $builds-coverage ]] || find "$builds-coverage" -name '*.gcda' -delete
  build_and_test coverage "$builds-coverage"
  scripts/coverage "$builds-coverage" -j "$JOBS"
}

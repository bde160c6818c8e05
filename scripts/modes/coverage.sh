# --coverage    which share of every layer's lines the tests reach: a table, and each line in
#               build-coverage/coverage/index.html

run_coverage() {
  install_packages --coverage
  # Counts of an earlier run belong to other sources.
  [[ ! -d $builds-coverage ]] || find "$builds-coverage" -name '*.gcda' -delete
  build_and_test coverage "$builds-coverage"
  scripts/coverage "$builds-coverage" -j "$JOBS"
}

# --format      clang-format instead of tests: fails where a file differs

run_format() {
  install_packages --lint
  scripts/lint format
}

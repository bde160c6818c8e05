# --types       mypy on the Python package and its examples

run_types() {
  install_packages --lint
  scripts/lint types
}

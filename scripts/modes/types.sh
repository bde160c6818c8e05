# --types       mypy on the Python package, which it builds, and its examples

run_types() {
  install_packages --lint
  configure default "$builds"
  cmake --build "$builds" -j "$JOBS" --target burnish_python_package
  scripts/lint types "$builds"
}

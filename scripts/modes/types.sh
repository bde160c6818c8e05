# --types       mypy on the Python package, after building it, and on the Python examples

run_types() {
  install_packages --lint
  configure default "$builds"
  cmake --build "$builds" -j "$JOBS" --target burnish_python_package
  scripts/lint types "$builds"
}

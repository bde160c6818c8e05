# (nothing)     build for this machine in build/ and run all tests

run_tests() {
  install_packages --test
  build_and_test default "$builds"
}

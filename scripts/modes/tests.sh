# (nothing)     all tests, with a build for this machine in build/

run_tests() {
  install_packages --test
  build_and_test default "$builds"
}

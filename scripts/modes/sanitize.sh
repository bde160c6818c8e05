# --sanitize    tests with the address and undefined behaviour sanitizers, in build-sanitize/

run_sanitize() {
  install_packages
  # Every report is a failure; there are no suppressions.
  build_and_test sanitize "$builds-sanitize"
}

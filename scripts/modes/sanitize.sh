# --sanitize    with the address and undefined behaviour sanitizers, in build-sanitize/

run_sanitize() {
  install_packages
  # A false report of any kind would be a reason to stop, hence no suppressions.
  build_and_test sanitize "$builds-sanitize"
}

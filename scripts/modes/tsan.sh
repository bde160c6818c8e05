# --tsan        with the thread sanitizer, the tests that use threads, in build-tsan/

run_tsan() {
  install_packages
  # A report of any kind is a failure: no suppressions.
  build_and_test tsan "$builds-tsan"
}

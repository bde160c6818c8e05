# --tsan        tests that use threads, with the thread sanitizer, in build-tsan/

run_tsan() {
  install_packages
  # Every report is a failure; there are no suppressions.
  build_and_test tsan "$builds-tsan"
}

# --clang       tests with Clang, with warnings as errors, in build-clang/

run_clang() {
  install_packages --clang
  build_and_test clang "$builds-clang"
}

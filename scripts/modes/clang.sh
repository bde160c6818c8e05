# --clang       with Clang, all warnings being errors, in build-clang/

run_clang() {
  install_packages --clang
  build_and_test clang "$builds-clang"
}

# --tidy        clang-tidy on the sources, in build-tidy/

run_tidy() {
  install_packages --lint
  configure default "$builds-tidy"
  scripts/lint tidy "$builds-tidy"
}

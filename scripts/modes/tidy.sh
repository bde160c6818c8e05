# --tidy        clang-tidy on the sources that the last 15 commits change, in build-tidy/; --tidy --whole
#               on all of them

run_tidy() {
  install_packages --lint
  configure default "$builds-tidy"
  scripts/lint tidy "$builds-tidy" "$@"
}

# --tidy        clang-tidy on the sources that the last 15 commits changed, in build-tidy/; --tidy --whole:
#               on all sources

run_tidy() {
  install_packages --lint
  configure default "$builds-tidy"
  scripts/lint tidy "$builds-tidy" "$@"
}

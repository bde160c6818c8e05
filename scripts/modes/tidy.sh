# --tidy        clang-tidy on the sources that the last 15 commits changed, in build-tidy/
#   --whole       instead on all sources
#   --most=N      on at most N of the changed sources, those with the most changed lines

run_tidy() {
  install_packages --lint
  configure default "$builds-tidy"
  scripts/lint tidy "$builds-tidy" "$@"
}

# --bare        on a bare machine, a minimal Debian 12 from Debian's archive alone: set-up,
#               configuration and every file that ./demo, ./test, plain cmake and pip install need;
#               the page and the Python tests with that Debian's Node and Python, and a project
#               that uses what build/ holds; in build-bare/. Skipped without root or user namespaces
#   --full      instead builds and runs ./demo and ./test there and prints their times;
#               --full=demo or --full=test: one of them
#   --without-npm   npm's registry cannot be reached there

run_bare() {
  install_packages --bare
  scripts/bare/run "$builds" "$@"
}

# --bare        tests on a bare machine, a minimal Debian 12, in build-bare/: setup, configuration, and
#               existence of all files that ./demo, ./test, plain cmake and pip install need; the page
#               and the Python tests with Debian's Node and Python; a project that uses the
#               installation of build/. Skipped without root or user namespaces
#   --full      instead runs ./demo and ./test there and prints their times;
#               --full=demo or --full=test: only one of them
#   --without-npm   makes npm's registry unreachable there

run_bare() {
  install_packages --bare
  scripts/bare/run "$builds" "$@"
}

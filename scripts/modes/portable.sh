# --portable    tests of a build without -march=native, with shared libraries that choose their kernels at
#               run time, in build-portable/

run_portable() {
  install_packages --test
  build_and_test portable "$builds-portable"
}

# --core        tests of the parts that need only Eigen (no URDF, robots, command line), in build-core/

run_core() {
  install_packages --core
  build_and_test core "$builds-core"
}

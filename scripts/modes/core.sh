# --core        what needs Eigen alone (no URDF, no robots, no command line), in build-core/

run_core() {
  install_packages --core
  build_and_test core "$builds-core"
}

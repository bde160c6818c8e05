# --instructions
#               counts of instructions of kernels and of an iteration with valgrind, compared with
#               their budgets, in build-instructions/

run_instructions() {
  install_packages --lint
  configure instructions "$builds-instructions"
  cmake --build "$builds-instructions" -j "$JOBS" --target burnish_instructions
  scripts/instructions "$builds-instructions/benchmarks/burnish_instructions"
}

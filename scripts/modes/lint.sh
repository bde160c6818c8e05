# --lint        --format, --types and --tidy

run_lint() {
  run_mode format
  run_mode types
  run_mode tidy
}

# --format      check of the format with clang-format, without tests

run_format() {
  install_packages --lint
  scripts/lint format
}

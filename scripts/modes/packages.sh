# --packages    Debian packages, in build-packages/: built, checked by lintian, then installed, used and
#               removed in a minimal Debian 12. The last step is skipped without root or user namespaces

run_packages() {
  install_packages --packages
  local build=$builds-packages
  # With this variable, equal sources make equal packages.
  SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || date +%s)
  export SOURCE_DATE_EPOCH
  configure packages "$build"
  cmake --build "$build" -j "$JOBS"
  rm -f "$build"/*.deb
  if ! cpack --config "$build/CPackConfig.cmake" -B "$build" >"$build/cpack.log" 2>&1; then
    cat "$build/cpack.log"
    echo "test: cpack failed" >&2
    return 1
  fi
  say "lintian"
  lintian --fail-on error "$build"/*.deb
  say "in a minimal Debian 12"
  scripts/packages "$build"
}

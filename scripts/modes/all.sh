# --all         all modes except --coverage; the tests of (nothing), --types and --bare run last. A failed
#               mode does not stop the others

run_all() {
  local stage began lines=() failed=0
  local options=(${cmake_arguments[@]+"${cmake_arguments[@]}"})
  [[ $setup == yes ]] || options+=(--no-setup)
  for stage in --format --api --tidy --instructions --core --aarch64 --portable --packages --sanitize --tsan --clang --fuzz "" --types --bare; do
    say "./test $stage"
    began=$SECONDS
    # shellcheck disable=SC2086
    if ./test $stage ${options[@]+"${options[@]}"}; then
      lines+=("passed  $((SECONDS - began)) s  ./test $stage")
    else
      lines+=("FAILED  $((SECONDS - began)) s  ./test $stage")
      failed=$((failed + 1))
    fi
  done
  say "summary"
  printf '%s\n' "${lines[@]}"
  if ((failed)); then
    echo "$failed of ${#lines[@]} stages failed"
    return 1
  fi
  echo "all ${#lines[@]} stages passed"
}

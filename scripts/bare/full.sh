# Sourced by run: runs the two commands of the README, each in a new root, and prints their times, including
# the installation of packages.

# shellcheck disable=SC2154
began() { awk '{print $14 + $15 + $16 + $17}' /proc/$$/stat; }

lines=()
for command in $full; do
  say "./$command, from nothing"
  minimal_root_copy bare "$command"
  log=$logs/full_$command.log
  cpu=$(began)
  clock=$SECONDS
  status=0
  minimal_root_run "$command" --chdir=/burnish CCACHE_DISABLE=1 "./$command" 2>&1 | tee "$log" || status=$?
  clock=$((SECONDS - clock))
  cpu=$((($(began) - cpu) / $(getconf CLK_TCK)))
  page="without the web page"
  [[ ! -e $place/$command/burnish/build/page.html ]] || page="with the page"
  word=passed
  ((status == 0)) || word=FAILED
  lines+=("$(printf '%s  ./%s: %d s, %d CPU-seconds, %s' "$word" "$command" "$clock" "$cpu" "$page")")
  minimal_root_remove "$command"
done
say "done"
printf '%s\n' "${lines[@]}"
[[ "${lines[*]}" != *FAILED* ]] || exit 1

# --fuzz        fuzz tests of the readers of files (robots, problems, tasks, requests) with sanitizers, in
#               build-fuzz/; fails for a crash, 1 s of processor time for one text, or 1 GB of memory.
#               Failing texts are in build-fuzz/found
#     --seconds=N   duration per reader (30)
#     --runs=N      number of texts per reader, without a time limit
#     --reader=NAME one of urdf, mjcf, srdf, robot, problem, task, request, table
#     --seed=N      random seed (1)

run_fuzz() {
  local readers=(urdf mjcf srdf robot problem task request table) seed=1 extent=-max_total_time=30 word
  for word in "$@"; do
    case $word in
      --seconds=*) extent=-max_total_time=${word#*=} ;;
      --runs=*) extent=-runs=${word#*=} ;;
      --reader=*) readers=("${word#*=}") ;;
      --seed=*) seed=${word#*=} ;;
      *) refuse "'$word' needs a value, such as --seconds=30" ;;
    esac
  done
  [[ ${extent#*=} =~ ^[1-9][0-9]*$ && $seed =~ ^[1-9][0-9]*$ ]] ||
    refuse "--seconds, --runs and --seed must be integers of at least 1"
  local build=$builds-fuzz reader
  for reader in "${readers[@]}"; do
    [[ -d tests/fuzz/corpus/$reader ]] || refuse "--reader=$reader is unknown; wanted one of urdf, mjcf, srdf, robot, problem, task, request, table"
  done
  install_packages --fuzz
  configure fuzz "$build"
  cmake --build "$build" -j "$JOBS" --target fuzz
  rm -rf "$build"/{seeds,grown,logs,found}
  mkdir -p "$build"/{logs,found}

  say "fuzzing ${readers[*]}: ${extent#-} each, seed $seed"
  local -A reader_of=() # by process
  trap 'kill "${!reader_of[@]}" 2>/dev/null || true' EXIT
  trap 'exit 130' INT TERM
  for reader in "${readers[@]}"; do
    ((${#reader_of[@]} < JOBS)) || wait_for_reader "$build"
    start_reader "$build" "$reader" "$extent" "$seed"
    reader_of[$!]=$reader
  done
  while ((${#reader_of[@]})); do wait_for_reader "$build"; done
  trap - EXIT INT TERM
  report_fuzzing "$build" "${readers[@]}"
}

# Collects the seeds of a reader: its corpus, earlier failures, and the files of burnish.
collect_seeds() { # build folder, reader
  local file seeds=$1/seeds/$2 own=()
  case $2 in
    urdf) own=(robots/*/*.urdf) ;;
    robot) own=(robots/*/robot.yaml) ;;
    problem) own=(examples/problems/*.yaml) ;;
    task) own=(tasks/*/*.yaml) ;;
    request) own=(examples/eval/*.json) ;;
  esac
  mkdir -p "$seeds"
  for file in tests/fuzz/{corpus,regressions}/"$2"/* ${own[@]+"${own[@]}"}; do
    [[ ! -f $file ]] || cp "$file" "$seeds/${file//\//_}"
  done
}

# Writes the dictionary of a reader: all words of its seeds, and texts that are often misread.
write_dictionary() { # build folder, reader
  {
    grep -raohE '[A-Za-z_][A-Za-z_0-9]{2,39}' "$1/seeds/$2" | sort -u
    printf '%s\n' 1e308 -1e308 1e-308 1e999 -1 2147483648 18446744073709551616 nan inf \
      '[]' '{}' '[[' '{a: ' '&a ' '*a' '<<: ' '- ' '? ' ': ' '---' '!!' '<!--' '-->' '<![CDATA[' '&#0;'
  } | sed 's/.*/"&"/' >"$1/seeds/$2.words"
}

start_reader() { # build folder, reader, libFuzzer's extent, seed
  local grown=$1/grown/$2
  collect_seeds "$1" "$2"
  write_dictionary "$1" "$2"
  mkdir -p "$grown"
  # tests/fuzz/run.cpp limits the processor time to 1 s, independent of the load. The timeout ends endless
  # loops. The small quarantine keeps freed memory from counting towards the limit.
  ASAN_OPTIONS=quarantine_size_mb=32 UBSAN_OPTIONS=print_stacktrace=1 \
    "$1/tests/fuzz/fuzz_$2" -seed="$4" "$3" -timeout=30 -report_slow_units=30 -rss_limit_mb=1024 -max_len=65536 \
    -dict="$1/seeds/$2.words" -artifact_prefix="$1/found/$2-" -print_final_stats=1 \
    "$grown" "$1/seeds/$2" >"$1/logs/$2" 2>&1 &
}

wait_for_reader() { # build folder
  local ended=""
  if wait -n -p ended "${!reader_of[@]}"; then touch "$1/logs/${reader_of[$ended]}.passed"; fi
  unset "reader_of[$ended]"
}

report_fuzzing() { # build folder, readers...
  local build=$1 reader failed=0 word file
  shift
  stat() { sed -n "s/^stat::$1: *//p" "$build/logs/$reader"; }
  say "inputs, accepted or rejected"
  printf '%-10s %10s %9s %8s  %s\n' reader inputs per-second peak-MB result
  for reader in "$@"; do
    if [[ -e $build/logs/$reader.passed ]]; then
      word=passed
    else
      word=FAILED
      failed=1
    fi
    printf '%-10s %10s %9s %8s  %s\n' "$reader" "$(stat number_of_executed_units)" \
      "$(stat average_exec_per_sec)" "$(stat peak_rss_mb)" "$word"
  done
  ((failed)) || return 0
  for reader in "$@"; do
    [[ ! -e $build/logs/$reader.passed ]] || continue
    say "$reader: the end of $build/logs/$reader"
    grep -vE '^(#|stat::|Dictionary|DE:)' "$build/logs/$reader" | tail -n 40
    for file in "$build/found/$reader-"*; do
      [[ ! -e $file ]] || echo "to repeat: $build/tests/fuzz/fuzz_$reader $file"
    done
  done
  return 1
}

# Sourced by run: checks of a bare machine that need no full build.

root=$place/bare
# shellcheck disable=SC2016
# Skips fsync, because this root is temporary.
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/bare"
minimal_root_carry bare scripts/bare/cmake scripts/bare/look /usr/local/bin/
without_stand_in=PATH=/usr/sbin:/usr/bin:/sbin:/bin

# Checks that a command of the documentation reaches its build, and that all inputs of the build exist. The
# command is stopped there, and therefore fails.
reaches_build() { # command
  rm -f "$root/looked"
  in_root npm_config_engine_strict=true bash -ec "$1" || true
  [[ -e $root/looked ]]
}
looked() { sed 's/^/         /' "$root/looked"; }

step "./demo" reaches_build "./demo"
looked
step "plain cmake, as in README.md" reaches_build "rm -rf build; cmake -S . -B build && cmake --build build"
looked

# Commands of docs/python.md up to the one that uses the installed package.
installation=$(sed -n '/^## Installing it/,/^## /p' docs/python.md | awk '/^```/ {block++; next} block == 1' | grep -v 'import burnish')
[[ $installation == *"pip install ."* ]] || fail "docs/python.md has no 'pip install .' in its section 'Installing it'"
step "pip install ., as in docs/python.md" reaches_build "$installation"
looked
pip_again() { # command that damages build-wheel
  in_root $without_stand_in bash -ec "$1"
  reaches_build "/root/burnish/bin/pip install ."
}
step "... after a failed call without make" pip_again \
  'rm -r build-wheel; mv /usr/bin/make /tmp; ! ~/burnish/bin/pip install . >/dev/null 2>&1; mv /tmp/make /usr/bin'
step "... with an incomplete build-wheel" pip_again \
  'head -c 2000 build-wheel/CMakeCache.txt >half; mv half build-wheel/CMakeCache.txt'
step "... with a build-wheel of another generator and folder" pip_again \
  'cp build-wheel/burnish_build.json /tmp; rm -r build-wheel; cp -r . /tmp/elsewhere
   cmake -G Ninja -S /tmp/elsewhere -B /tmp/elsewhere/build-wheel
   mv /tmp/elsewhere/build-wheel .; mv /tmp/burnish_build.json build-wheel'

step "./test" reaches_build "rm -rf build; ./test"
looked
in_root $without_stand_in bash -c 'echo "node $(node --version), $(cmake --version | head -1), \
$(g++ --version | head -1), $(python3 --version)"' | sed 's/^/         /'

# Checks with Debian's Node. The page may be off only if npm's registry cannot be reached.
registry_answers() {
  local registry
  registry=$(sed -n 's/^registry=//p' "$root/root/.npmrc" | tail -1)
  in_root node -e 'fetch(process.argv[1]).then((a) => process.exit(a.ok ? 0 : 1), () => process.exit(1))' \
    "${registry:-https://registry.npmjs.org/}" >"$logs/registry.log" 2>&1
}
build_page() {
  grep -H "page of runs: on" "$root/burnish/build/configure.log"
  in_root $without_stand_in cmake --build build --target burnish_page
  # The browser of the test web.page is missing here; the module that drives it is tested.
  in_root bash -ec 'cd build/web; node --test test/unit.test.mjs; node test/browser.mjs'
}
if grep -q "page of runs: off" "$root/burnish/build/configure.log" && ! registry_answers; then
  say "its Node: skipped, npm's registry cannot be reached"
else
  step "its Node: the page, its unit tests, and the module that drives a browser" build_page
fi

# The build of this machine runs in the root only if this machine is Debian 12.
built_outside() {
  [[ $(. /etc/os-release; echo "$ID $VERSION_ID") == "debian 12" ]] || { echo "this machine is not Debian 12"; return 1; }
  cmake --install "$builds" --prefix "$place/prefix" >"$logs/install.log" 2>&1 ||
    { echo "$builds is not a complete build, see $logs/install.log"; return 1; }
}
if reason=$(built_outside); then
  minimal_root_carry bare "$place/prefix" /opt/burnish
  consumer() {
    in_root $without_stand_in bash -ec 'cmake -S tests/package -B /tmp/consumer -DCMAKE_PREFIX_PATH=/opt/burnish
      cmake --build /tmp/consumer
      /opt/burnish/bin/burnish show arm7
      BURNISH_ROBOTS=/opt/burnish/share/burnish/robots /tmp/consumer/consumer | tee /dev/stderr | grep -q "30.0 N along +z"'
  }
  step "a project that uses burnish, with plain cmake" consumer
  # All tests except those of memory over time, which take half of the time.
  python_tests() {
    in_root PYTHONPATH=/opt/burnish/lib/python3.11/site-packages PYTHONDONTWRITEBYTECODE=1 \
      timeout 300 python3 -m pytest -q -p no:cacheprovider --ignore=python/tests/test_leaks.py python/tests
  }
  if [[ -d $root/opt/burnish/lib/python3.11/site-packages/burnish ]]; then
    step "its Python: the package of this machine's build, with its tests" python_tests
  else
    say "its Python: skipped, $builds has no package for Python 3.11"
  fi
else
  say "this machine's build: skipped, $reason"
fi

# Test of this test: it must detect a missing package.
purged() {
  in_root dpkg --purge --force-depends zlib1g-dev
  ! in_root look build burnish_app >"$logs/purged.log" && cat "$logs/purged.log" && grep -q '/libz\.so$' "$logs/purged.log"
}
step "without zlib1g-dev: this test fails and names libz.so" purged
say "all checks passed"

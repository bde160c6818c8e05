# Functions for tests on a bare machine: make minimal Debian 12 roots from Debian's archive, copy files into
# them, and run commands in them.
#
#   minimal_root_enter PLACE SCRIPT ARGUMENTS...  must be called first: runs the script again, as root of
#                                                 new namespaces, with roots in PLACE
#   minimal_root_make NAME [PACKAGE...]           makes a root with mmdebstrap (minbase) and packages
#   minimal_root_copy NAME OTHER                  copies the root NAME to OTHER
#   minimal_root_carry NAME FILE... DESTINATION   copies files; a DESTINATION that ends in / is a folder
#   minimal_root_carry_tracked NAME REPOSITORY DESTINATION   copies the files that git tracks
#   minimal_root_run NAME [--chdir=FOLDER] [VARIABLE=VALUE...] COMMAND...
#                                                 runs a command without other environment variables
#   minimal_root_remove NAME                      removes a root
#
# Mounts are in a mount namespace and processes in a PID namespace, so both end with the script; PLACE is
# removed afterwards. Roots are in memory if there is enough (MINIMAL_ROOT_ON=disk or memory overrides this),
# because dpkg waits for the disk after each file. Proxies, the settings of apt for them, certificates and
# npm's registry are passed to the roots.

minimal_root_skip() { # reason
  echo "skipped: a minimal root cannot be made: $*"
  exit 0
}

minimal_root_enter() {
  local place=$1
  shift
  if [[ ${MINIMAL_ROOT_PLACE:-} == "$place" ]]; then
    # The first process of a PID namespace has no default actions for signals.
    trap 'exit 143' TERM
    [[ ${MINIMAL_ROOT_ON} != memory ]] || mount -t tmpfs -o mode=755,size=80% tmpfs "$place"
    return
  fi

  command -v mmdebstrap >/dev/null || minimal_root_skip "mmdebstrap is missing (scripts/setup --bare installs it)"
  [[ -e /usr/share/keyrings/debian-archive-keyring.gpg ]] ||
    minimal_root_skip "the keys of Debian's archive are missing (package debian-archive-keyring)"
  local namespaces=(unshare --mount --pid --ipc --uts --fork --kill-child --mount-proc) output
  [[ $(id -u) == 0 ]] || namespaces+=(--user --map-root-user --map-auto)
  output=$("${namespaces[@]}" true 2>&1) ||
    minimal_root_skip "neither root nor user namespaces: '${namespaces[*]}' printed '${output//$'\n'/ }'"

  # Removes files of an interrupted run. Only the namespace can remove files of users other than root.
  "${namespaces[@]}" rm -rf --one-file-system "$place"
  mkdir -p "$place"
  if [[ -z ${MINIMAL_ROOT_ON:-} ]]; then
    MINIMAL_ROOT_ON=disk
    (($(awk '/MemAvailable/ {print $2}' /proc/meminfo) < 6000000)) || MINIMAL_ROOT_ON=memory
  fi
  export MINIMAL_ROOT_ON
  # Not `exec`, because this process must clean up, and forward signals that a PID namespace ignores.
  MINIMAL_ROOT_PLACE=$place setpriv --pdeathsig KILL "${namespaces[@]}" bash "$@" &
  local inside=$! status=0
  trap 'status=130; kill -KILL "$inside" 2>/dev/null || true' INT TERM HUP
  wait "$inside" || status=$((status ? status : $?))
  wait "$inside" 2>/dev/null || true
  # Killed processes may still be running.
  local attempt
  for attempt in 1 2 3 4 5; do
    "${namespaces[@]}" rm -rf --one-file-system "$place" 2>/dev/null && break
    sleep "$attempt"
  done
  exit "$status"
}

# Prints sources.list for bookworm: the mirrors of this machine, or those of Debian.
minimal_root_sources() {
  local origins main security
  # shellcheck disable=SC2016
  origins=$(apt-get indextargets --format '$(ORIGIN)|$(LABEL)|$(REPO_URI)|' 2>/dev/null || true)
  main=$(sed -nE 's,^Debian\|Debian\|(https?://[^|]*)\|.*,\1,p' <<<"$origins" | head -1)
  security=$(sed -nE 's,^Debian\|Debian-Security\|(https?://[^|]*)\|.*,\1,p' <<<"$origins" | head -1)
  main=${main:-http://deb.debian.org/debian}
  security=${security:-http://deb.debian.org/debian-security}
  local signed='[signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]'
  printf 'deb %s %s main\n' "$signed $main" bookworm "$signed $main" bookworm-updates \
    "$signed $security" bookworm-security
}

minimal_root_make() {
  local name=$1 root=$MINIMAL_ROOT_PLACE/$1 sources packages option options=()
  shift
  sources=$(minimal_root_sources)
  packages=("$@")
  [[ $sources != *https://* ]] || packages+=(ca-certificates)
  while IFS= read -r option; do
    options+=("--aptopt=$option")
  done < <(apt-config dump 2>/dev/null | grep -E '^Acquire::(https?::|Check-|Retries|ForceIPv)' | grep -v ' "";$' || true)
  mkdir -p "$root"
  if ! mmdebstrap --variant=minbase --mode=root ${options[@]+"${options[@]}"} \
    ${packages[@]+"--include=$(IFS=,; echo "${packages[*]}")"} bookworm "$root" - <<<"$sources" \
    >"$root.log" 2>&1; then
    cat "$root.log" >&2
    echo "minimal root '$name': mmdebstrap failed" >&2
    return 1
  fi
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  minimal_root_certificates "$root"
  minimal_root_npm "$root"
  minimal_root_mounts "$root"
}

minimal_root_copy() {
  local root=$MINIMAL_ROOT_PLACE/$2
  cp -a --one-file-system "$MINIMAL_ROOT_PLACE/$1" "$root"
  minimal_root_mounts "$root"
}

minimal_root_certificates() { # root
  mkdir -p "$1/usr/local/share/ca-certificates"
  # The package ca-certificates adds these during its installation.
  find /usr/local/share/ca-certificates -name '*.crt' -exec cp -L -t "$1/usr/local/share/ca-certificates" {} + 2>/dev/null || true
  [[ ! -e ${NODE_EXTRA_CA_CERTS:-} ]] || cp -L "$NODE_EXTRA_CA_CERTS" "$1/etc/certificates-for-node.crt"
}

minimal_root_npm() { # root
  local key value
  { [[ ! -e ~/.npmrc ]] || grep -E '^(//|@)' ~/.npmrc || true; } >"$1/root/.npmrc"
  command -v npm >/dev/null || return 0
  for key in registry proxy https-proxy noproxy strict-ssl; do
    value=$(npm config get "$key" 2>/dev/null || true)
    [[ -z $value || $value == null || $value == undefined ]] || echo "$key=$value" >>"$1/root/.npmrc"
  done
  value=$(npm config get cafile 2>/dev/null || true)
  if [[ -e $value ]]; then
    cp -L "$value" "$1/etc/certificates-for-npm.crt"
    echo "cafile=/etc/certificates-for-npm.crt" >>"$1/root/.npmrc"
  fi
}

minimal_root_mounts() { # root
  local node
  mount -t proc proc "$1/proc"
  mount --rbind /sys "$1/sys"
  mount -t tmpfs -o mode=755 tmpfs "$1/dev"
  for node in null zero full random urandom tty; do
    : >"$1/dev/$node"
    mount --bind "/dev/$node" "$1/dev/$node"
  done
  mkdir "$1/dev/pts" "$1/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=666 devpts "$1/dev/pts"
  mount -t tmpfs -o mode=1777 tmpfs "$1/dev/shm"
  ln -s pts/ptmx "$1/dev/ptmx"
  ln -s /proc/self/fd "$1/dev/fd"
  ln -s fd/0 "$1/dev/stdin"
  ln -s fd/1 "$1/dev/stdout"
  ln -s fd/2 "$1/dev/stderr"
}

minimal_root_carry() {
  local root=$MINIMAL_ROOT_PLACE/$1 files=("${@:2:$#-2}") destination=${!#}
  [[ $destination == */ ]] || mkdir -p "$root$(dirname "$destination")"
  [[ $destination != */ ]] || mkdir -p "$root$destination"
  cp -R --preserve=mode,timestamps,links "${files[@]}" "$root$destination"
}

minimal_root_carry_tracked() {
  local root=$MINIMAL_ROOT_PLACE/$1 repository=$2 destination=$3 file
  mkdir -p "$root$destination"
  git -C "$repository" ls-files -z | while IFS= read -r -d '' file; do
    [[ ! -e $repository/$file && ! -L $repository/$file ]] || printf '%s\0' "$file"
  done | tar -C "$repository" --null --no-recursion -T - -c | tar -C "$root$destination" --no-same-owner -x
}

minimal_root_run() {
  local root=$MINIMAL_ROOT_PLACE/$1 variable environment=()
  shift
  for variable in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY TERM; do
    [[ -z ${!variable:-} ]] || environment+=("$variable=${!variable}")
  done
  [[ ! -e $root/etc/certificates-for-node.crt ]] || environment+=("NODE_EXTRA_CA_CERTS=/etc/certificates-for-node.crt")
  # Background processes of minimal_root_enter ignore signals of the keyboard.
  chroot "$root" /usr/bin/env -i --default-signal=INT,QUIT HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    ${environment[@]+"${environment[@]}"} env "$@" </dev/null
}

minimal_root_remove() {
  local mounted
  for mounted in proc sys dev; do
    umount --lazy "$MINIMAL_ROOT_PLACE/$1/$mounted"
  done
  rm -rf --one-file-system "${MINIMAL_ROOT_PLACE:?}/${1:?}"
}

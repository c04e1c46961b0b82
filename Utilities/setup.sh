# SPDX-License-Identifier: BSD-3-Clause
# What demo.sh and test.sh share: packages, configuring and building. They source it after 'set -eu'.
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/build"

fail()
{
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# The packages of the groups named.
packages_of()
{
  for group in "$@"; do
    sed -n "s/^$group  *//p" "$root/Utilities/packages.txt"
  done
}

# Those of the packages named that are not installed, on one line.
not_installed()
{
  for package in "$@"; do
    status=$(dpkg-query -W -f '${db:Status-Status} ' "$package" 2>/dev/null || true)
    case " $status" in
      *" installed "*) ;;
      *) printf '%s ' "$package" ;;
    esac
  done
}

# Install what is missing of the groups named; without a look at the network where nothing is.
install_packages()
{
  command -v dpkg-query >/dev/null 2>&1 && command -v apt-get >/dev/null 2>&1 || fail \
    "this system has no apt-get. Install what Utilities/packages.txt names by other means, then: cmake --preset release"
  # shellcheck disable=SC2046
  absent=$(not_installed $(packages_of "$@"))
  if [ -z "$absent" ]; then
    printf 'Packages: all present\n'
    return 0
  fi

  start=$(date +%s)
  printf 'Packages: installing %s\n' "$absent"
  as_root=""
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 || fail \
      "packages are missing, this user is not root and there is no sudo." \
      "As root: apt-get install --no-install-recommends $absent"
    as_root="sudo"
  fi
  $as_root apt-get -q update ||
    printf 'warning: the package lists could not be refreshed; going on with those at hand\n' >&2
  system=$(sed -n 's/^PRETTY_NAME="\(.*\)"$/\1/p' /etc/os-release 2>/dev/null || true)
  for package in $absent; do
    LC_ALL=C apt-cache policy "$package" | grep -q 'Candidate: [^(]' || fail \
      "package '$package' cannot be had from the package sources of this system (${system:-unknown})." \
      "Debian 12 and 13 have it in 'main', Ubuntu in 'universe': see /etc/apt/sources.list and sources.list.d."
  done
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends $absent ||
    fail "apt-get could not install: $(not_installed $absent)"
  printf 'Packages: %s s\n' "$(($(date +%s) - start))"
}

# Configure with the options given, and build everything that they switch on.
build_project()
{
  start=$(date +%s)
  mkdir -p "$build"
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" >"$build/configure.log" 2>&1 || {
    cat "$build/configure.log" >&2
    fail "configuring failed; the reason stands above"
  }
  printf 'Configure: %s s\n' "$(($(date +%s) - start))"
  start=$(date +%s)
  cmake --build "$build" -j "$(nproc)" || fail "building failed; the reason stands above"
  printf 'Build: %s s\n' "$(($(date +%s) - start))"
}

# A bare Debian of the release named in a folder of its own, from where this system takes its packages: make_system FOLDER RELEASE
make_system()
{
  [ "$(id -u)" -eq 0 ] || fail "a system of its own in $1 needs root"
  if [ -f "$1/.complete" ]; then
    return 0
  fi
  install_packages debian
  mirror=$(LC_ALL=C apt-get indextargets --format '$(SITE)' | grep -v security | head -n 1)
  [ -n "$mirror" ] || fail "no package source is configured: see /etc/apt"
  rm -rf "$1"
  mkdir -p "$1"
  debootstrap --variant=minbase "$2" "$1" "$mirror" >"$1.log" 2>&1 || {
    tail -n 20 "$1.log" >&2
    fail "debootstrap could not make a Debian ($2) from the package sources of this one"
  }
  cp -r /etc/apt/apt.conf.d/. "$1/etc/apt/apt.conf.d/"
  cp /etc/resolv.conf "$1/etc/resolv.conf"
  chroot "$1" apt-get -q update >"$1.log" 2>&1 || fail "the system in $1 cannot reach the package sources"
  touch "$1/.complete"
}

# Run a command in such a system, with /proc and /dev as long as it runs: in_system FOLDER COMMAND...
in_system()
{
  unshare --mount sh -c 'system=$1; shift; mount -t proc proc "$system/proc" && mount --bind /dev "$system/dev" &&
    exec chroot "$system" env -i HOME=/ PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive sh -c "dpkg --configure -a >/dev/null 2>&1; exec \"\$@\"" in_system "$@" </dev/null' in_system "$@"
}

# Copy what is in this tree, without what was built, to a folder.
copy_tree()
{
  mkdir -p "$1"
  (cd "$root" && tar -c --exclude=./build --exclude='./build-*' --exclude=./output --exclude=./.git .) | tar -x -C "$1"
}

#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Make Debian packages of the libraries, the headers, the Python package, the program and the pages:
#   sh Utilities/debian.sh [--try]
# --try installs them into a fresh system made by debootstrap and uses them there; it needs root and the network.
set -eu
. "$(dirname "$0")/setup.sh"

case "${1:-}" in
  "" | --try) ;;
  *)
    printf 'usage: sh Utilities/debian.sh [--try]\n'
    printf 'Build in build-debian/ and write the packages to build-debian/packages/.\n'
    printf -- '--try: install them into a fresh Debian below build-debian/ and use them there (root, network).\n'
    exit 0
    ;;
esac
try=${1:-}
build="$root/build-debian"
packages="$build/packages"

install_packages build debian
build_project -DCMAKE_INSTALL_PREFIX=/usr -DSHADOWCONES_BUILD_TESTING=OFF -DSHADOWCONES_BUILD_EXAMPLES=OFF
rm -rf "$packages"
(cd "$build" && cpack -G DEB >"$build/cpack.log" 2>&1) || {
  cat "$build/cpack.log" >&2
  fail "the packages could not be made; the reason stands above"
}
for package in "$packages"/*.deb; do
  printf '%s  %s KiB\n' "${package##*/}" "$(($(stat -c %s "$package") / 1024))"
done
[ -n "$try" ] || exit 0

# The fresh system takes its packages from where this one does.
[ "$(id -u)" -eq 0 ] || fail "--try makes a system of its own below $build: it needs root"
. /etc/os-release
mirror=$(LC_ALL=C apt-get indextargets --format '$(SITE) $(RELEASE)' | sed -n "s/ $VERSION_CODENAME\$//p" | head -n 1)
[ -n "$mirror" ] || fail "no package source of $VERSION_CODENAME is configured: see /etc/apt"
system="$build/system"
if [ ! -f "$system/.complete" ]; then
  rm -rf "$system"
  debootstrap --variant=minbase "$VERSION_CODENAME" "$system" "$mirror" >"$build/debootstrap.log" 2>&1 || {
    tail -n 20 "$build/debootstrap.log" >&2
    fail "debootstrap could not make a system from the package sources of this one"
  }
  rm -f "$system/etc/apt/sources.list"
  cp -r /etc/apt/. "$system/etc/apt/"
  cp /etc/resolv.conf "$system/etc/resolv.conf"
  chroot "$system" apt-get -q update >"$build/update.log" 2>&1 || fail "the fresh system cannot reach the package sources"
  touch "$system/.complete"
fi
mkdir -p "$system/packages"
cp "$packages"/*.deb "$system/packages/"
cp -r "$root/Examples/Consumer" "$system/packages/"
cp "$root/Utilities/debian/try.sh" "$system/packages/"
# Some packages look at /proc while they are installed; in a mount namespace it is gone again afterwards.
unshare --mount sh -c 'mount -t proc proc "$0/proc" && chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin sh /packages/try.sh' "$system"

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

. /etc/os-release
system="$build/system"
make_system "$system" "$VERSION_CODENAME"
mkdir -p "$system/packages"
cp "$packages"/*.deb "$system/packages/"
cp -r "$root/Examples/Consumer" "$system/packages/"
cp "$root/Utilities/debian/try.sh" "$system/packages/"
in_system "$system" sh /packages/try.sh

#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Get ParaView, build the plugin for it and test it, on Debian:
#   sh Utilities/paraview.sh [--if-there] [--try-13 FOLDER]
# A second run takes seconds. PARAVIEW_PREFIX in the environment names an unpacked ParaView to use instead of a download.
set -eu
. "$(dirname "$0")/setup.sh"

usage()
{
  printf 'usage: sh Utilities/paraview.sh [--if-there] [--try-13 FOLDER]\n'
  printf 'Unpack the ParaView of this system in build-paraview/debian, build the plugin in build-paraview and run its tests.\n'
  printf -- '--if-there: do so only where the plugin has been built before; else say that it was not built.\n'
  printf -- '--try-13 FOLDER: the same in a Debian 13 of its own in FOLDER, outside this tree (root, network, 4 GB).\n'
}

build="$root/build-paraview"
case "${1:-}" in
  "") ;;
  --if-there)
    if [ -z "$(find "$build/lib" -name ShadowConesParaView.so 2>/dev/null)" ]; then
      printf 'ParaView plugin: not built here (sh Utilities/paraview.sh)\n'
      exit 0
    fi
    ;;
  --try-13)
    [ -n "${2:-}" ] || { usage >&2; exit 2; }
    mkdir -p "$2"
    system=$(cd "$2" && pwd)
    case "$system/" in "$root"/*) fail "$system lies in this tree: name a folder elsewhere" ;; esac
    make_system "$system" trixie
    copy_tree "$system/ShadowCones"
    in_system "$system" sh /ShadowCones/Utilities/paraview.sh
    exit 0
    ;;
  *)
    usage
    [ "$1" = --help ] && exit 0
    exit 2
    ;;
esac

# ParaView 5.11 of Debian 12 is made with Qt 5, ParaView 5.13 of Debian 13 with Qt 6.
. /etc/os-release
case "${VERSION_ID:-}" in
  1[3-9]) install_packages build paraview paraview-13 ;;
  *) install_packages build paraview paraview-12 ;;
esac
# What was configured before is used again.
config=$(sed -n 's/^ParaView_DIR:PATH=//p' "$build/CMakeCache.txt" 2>/dev/null || true)
prefix=${PARAVIEW_PREFIX:-${config%/usr/lib/*}}
if [ -z "$prefix" ] || [ ! -d "$prefix/usr/lib" ]; then
  # python3-paraview and python3-vtk9 exclude each other: ParaView is unpacked beside what the modules need, not installed.
  install_packages paraview-libraries
  prefix="$build/debian"
  if [ ! -f "$prefix/.complete" ]; then
    start=$(date +%s)
    rm -rf "$prefix" "$build/packages"
    mkdir -p "$prefix" "$build/packages"
    (cd "$build/packages" && apt-get -q download paraview paraview-dev python3-paraview >download.log 2>&1) || {
      cat "$build/packages/download.log" >&2
      fail "ParaView could not be had from the package sources of this system"
    }
    for package in "$build"/packages/*.deb; do
      dpkg -x "$package" "$prefix"
    done
    rm -rf "$build/packages"
    touch "$prefix/.complete"
    printf 'ParaView: %s s\n' "$(($(date +%s) - start))"
  fi
fi
# Debian 13 has its Python modules under longer names than those that its own CMake files look for.
find "$prefix/usr/lib/python3/dist-packages" -name '*.cpython-*.so' 2>/dev/null | while read -r module; do
  ln -sf "${module##*/}" "${module%%.cpython-*}.so"
done
config=$(find "$prefix/usr/lib" -name paraview-config.cmake | head -n 1)
[ -n "$config" ] || fail "there is no paraview-config.cmake below $prefix/usr/lib"
build_project -DSHADOWCONES_BUILD_PARAVIEW_PLUGIN=ON -DSHADOWCONES_BUILD_TESTING=ON -DParaView_DIR="${config%/*}"
(cd "$build" && ctest --output-on-failure)
plugin=$(find "$build/lib" -name ShadowConesParaView.so)
printf '\nThe plugin: %s\nTo try it: PV_PLUGIN_PATH=%s %s/usr/bin/paraview\n' "$plugin" "${plugin%/*}" "$prefix"

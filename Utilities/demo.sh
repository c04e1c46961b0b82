#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# From a bare Debian or Ubuntu to pictures of light shafts around a chair: sh Utilities/demo.sh [OUTDIR]
set -eu
. "$(dirname "$0")/setup.sh"

case "${1:-}" in
  -*)
    printf 'usage: sh Utilities/demo.sh [OUTDIR]\n'
    printf 'Install what is missing, build, and write the chain of the chair to OUTDIR (default: ./output).\n'
    exit 0
    ;;
esac
output=${1:-output}
mkdir -p "$output" || fail "cannot make the folder '$output'"

install_packages build demo
if [ -f "$build/CMakeCache.txt" ]; then
  build_project
else
  # A first build without the tests needs fewer packages and half the time; test.sh adds them to the same folder.
  build_project -DSHADOWCONES_BUILD_TESTING=OFF -DSHADOWCONES_BUILD_EXAMPLES=OFF
fi

PYTHONPATH="$build/lib/python3/dist-packages" xvfb-run -a -s "-screen 0 1280x1024x24" \
  /usr/bin/python3 "$root/Examples/Python/chair_demo.py" --data "$root/Data" --output "$output"

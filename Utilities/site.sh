#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Build the site from Documentation and the headers: sh Utilities/site.sh [OUTDIR] (default: build/site)
set -eu
. "$(dirname "$0")/setup.sh"

output=${1:-"$build/site"}
case "$output" in
  -*)
    printf 'usage: sh Utilities/site.sh [OUTDIR]\n'
    printf 'Install what is missing and write the site to OUTDIR/html (default: build/site/html). To read it:\n'
    printf '  python3 -m http.server --directory OUTDIR/html, then http://localhost:8000 in a browser\n'
    exit 0
    ;;
esac
install_packages site
mkdir -p "$output" || fail "cannot make the folder '$output'"
output=$(cd "$output" && pwd)

python3 "$root/Utilities/site/pages.py" "$output"
mkdocs build --quiet --clean -f "$output/mkdocs.yml"
version=$(sed -n 's/^project(ShadowCones VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
rm -rf "$output/html/api"
cd "$root"
{
  cat Utilities/site/Doxyfile
  printf 'PROJECT_NUMBER = %s\nOUTPUT_DIRECTORY = %s/html\nHTML_OUTPUT = api\nWARN_AS_ERROR = YES\n' "$version" "$output"
} | doxygen - || fail "the reference of the classes has warnings; they stand above"
printf 'Site: %s/html\n' "$output"

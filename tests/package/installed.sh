#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the build into a scratch prefix, builds examples/cpp against it as a user would, and
# runs it on a bundled scene of two objects; then once more by pkg-config.
# usage: installed.sh BUILD_DIR
set -euo pipefail
build=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cmake --install "$build" --prefix "$scratch/prefix" >/dev/null
cmake -G Ninja -S "$root/examples/cpp" -B "$scratch/example" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$scratch/prefix" >/dev/null
cmake --build "$scratch/example"
"$scratch/example/find_objects" "$root/testvectors/scenes/studio-two/000034" \
  "$root/testvectors/models10" | tee "$scratch/found"
[ "$(grep -c '^model ' "$scratch/found")" -eq 2 ] || {
  echo "expected two objects" >&2
  exit 1
}

# The same program by pkg-config, as projects without CMake do it.
if command -v pkg-config >/dev/null; then
  export PKG_CONFIG_PATH="$scratch/prefix/lib/pkgconfig:$(echo "$scratch"/prefix/lib/*/pkgconfig)"
  # shellcheck disable=SC2046
  g++ -std=c++17 "$root/examples/cpp/find_objects.cpp" -o "$scratch/by_pkg_config" \
    $(pkg-config --cflags --libs trihedron)
  "$scratch/by_pkg_config" "$root/testvectors/scenes/studio-two/000034" "$root/testvectors/models10" |
    diff - "$scratch/found"
fi

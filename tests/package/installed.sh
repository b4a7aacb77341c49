#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the build into a scratch prefix, builds examples/cpp against it as a user would, and
# runs it on a bundled scene of two objects.
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

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Runs the regression in a build that counts lines and toggles, and writes docs/coverage.md.
# usage: coverage.sh [FRAMES [JOBS]]
set -eu
cd "$(dirname "$0")/../.."
out=build/rtl-coverage
cmake --preset rtl-coverage >/dev/null
cmake --build --preset rtl-coverage --target trihedron
rm -rf $out/data && mkdir -p $out/data
$out/sw/cli/trihedron verify --frames "${1:-3000}" --jobs "${2:-$(nproc)}" \
  --pictures testvectors/scenes --coverage $out/functional.json --code-coverage $out/data
exec tests/coverage/report.py $out/data $out/functional.json --out docs/coverage.md \
  --missed $out/missed.txt

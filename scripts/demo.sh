#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the project and recognises the objects of a bundled scene (two objects, perspective
# cameras, noise) from the features of the simulated hardware. Writes out/demo/report.html, a page
# to look at, and the pictures of every stage beside it.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh trihedron
build/release/sw/cli/trihedron recognize testvectors/scenes/studio-two/000034 \
  --models testvectors/models10 --frontend rtl --out out/demo --report out/demo/report.html
echo "report: $PWD/out/demo/report.html (open it in a browser; it needs no network)"
echo "pictures: out/demo"

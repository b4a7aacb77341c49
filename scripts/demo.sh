#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the project and recognises the objects of a bundled scene (two objects, perspective
# cameras, noise) from the features of the simulated hardware. Pictures go to out/demo.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/build.sh trihedron
build/release/sw/cli/trihedron recognize testvectors/scenes/studio-two/000034 \
  --models testvectors/models10 --frontend rtl --out out/demo
echo "pictures: out/demo"

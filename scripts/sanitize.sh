#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the readers, the golden model and their tests with clang's ASan and UBSan, and runs the tests
# and a short fuzzing of each harness. Skipped without clang.
# usage: scripts/sanitize.sh [CTEST OPTIONS]
set -euo pipefail
cd "$(dirname "$0")/.."
command -v clang++ >/dev/null ||
  { echo "sanitize.sh: SKIPPED, clang is not installed; scripts/install.sh test brings it"; exit 0; }

cmake --preset sanitize >/dev/null
cmake --build --preset sanitize --target trihedron_golden_tests trihedron_io_tests \
  trihedron_fuzz_{scene,mesh,results,stream}
ctest --preset sanitize -j "$(nproc)" -R '^(golden|io|fuzz):' "$@"

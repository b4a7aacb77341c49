#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the pages of the C++ API into out/api/html; any warning of Doxygen is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

mkdir -p out
doxygen docs/Doxyfile
pages=$(find out/api/html -name '*_8hpp.html' | wc -l)
headers=$(find sw/golden sw/recognition sw/io sw/render sw/calibration -name '*.hpp' | wc -l)
[ "$pages" -ge "$headers" ] || {
  echo "api_docs: $pages pages of $headers headers" >&2
  exit 1
}
echo "API of $headers headers: out/api/html/index.html"

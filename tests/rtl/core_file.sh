#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# trihedron.core lists every RTL source once, the package first, and only files that exist.
set -eu
cd "$(dirname "$0")/../.."
listed=$(sed -n 's/^      - \(.*\/.*\)$/\1/p' trihedron.core)
for file in $listed; do
  [ -f "$file" ] || { echo "trihedron.core: $file does not exist"; exit 1; }
done
rtl=$(echo "$listed" | grep '^rtl/.*\.sv$')
[ "$(echo "$rtl" | head -1)" = rtl/trihedron_registers.sv ] ||
  { echo "trihedron.core: the package rtl/trihedron_registers.sv must come first"; exit 1; }
[ "$(echo "$rtl" | sort)" = "$(ls rtl/*.sv | sort)" ] ||
  { echo "trihedron.core: its RTL list differs from rtl/*.sv"; exit 1; }
echo "trihedron.core: $(echo "$rtl" | wc -l) RTL files"

#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, configures and builds build/release. A second run is quick.
# usage: scripts/build.sh [TARGET...]   everything without
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install.sh
# Always: a pulled change may add or remove RTL files, which the build alone notices too late.
cmake --preset release >/dev/null
cmake --build --preset release ${1:+--target "$@"}

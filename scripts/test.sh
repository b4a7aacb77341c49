#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the project and runs every test.
# usage: scripts/test.sh [CTEST OPTIONS]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install.sh test
scripts/build.sh
ctest --preset release -j "$(nproc)" "$@"

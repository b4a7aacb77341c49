#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the Debian packages of a build, unpacks them, and runs what is inside. Where lintian is
# installed, it must find no error.
# usage: debian.sh BUILD_DIR
set -euo pipefail
build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "debian package: $*" >&2; exit 1; }

(cd "$scratch" && cpack --config "$build/CPackConfig.cmake" -B "$scratch" >"$scratch/log" 2>&1) ||
  { cat "$scratch/log" >&2; fail "cpack failed"; }
program=$(ls "$scratch"/trihedron_*.deb) library=$(ls "$scratch"/trihedron-dev_*.deb)
dpkg -x "$program" "$scratch/root"
dpkg -x "$library" "$scratch/dev"

"$scratch/root/usr/bin/trihedron" --version | grep -q '^trihedron [0-9]' || fail "--version"
gzip -dc "$scratch/root/usr/share/man/man1/trihedron.1.gz" | grep -q '^\.SH COMMANDS' || fail "no manual"
bash -c "source '$scratch/root/usr/share/bash-completion/completions/trihedron'; complete -p trihedron" >/dev/null ||
  fail "no completion for bash"
grep -q '^#compdef trihedron' "$scratch/root/usr/share/zsh/vendor-completions/_trihedron" || fail "no completion for zsh"
[ -f "$scratch/dev/usr/include/trihedron/recognition/recognize.hpp" ] || fail "no headers"
[ ! -e "$scratch/root/usr/include" ] || fail "headers in the program's package"
dpkg-deb -f "$program" Depends | grep -q libopencv || fail "no dependencies"
if command -v lintian >/dev/null; then
  # As a package of no distribution: no bug of it is closed, nothing was uploaded.
  lintian --allow-root --fail-on error --suppress-tags initial-upload-closes-no-bugs,embedded-library \
    "$program" "$library" || fail "lintian"
fi
echo "$(basename "$program"), $(basename "$library"): fine"

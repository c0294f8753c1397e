#!/bin/sh
# Builds the controller for a Cortex-M4F and fails when its assembly can reach a panic or an allocator.
set -eu
cd "$(dirname "$0")"
target="${CARGO_TARGET_DIR:-target}"
cargo rustc --quiet --release --target thumbv7em-none-eabihf -- --emit asm
assembly=$(ls -t "$target"/thumbv7em-none-eabihf/release/deps/pairtrawl_control_embedded-*.s | head -n 1)
grep -q 'track' "$assembly" || { echo "no machine code was made" >&2; exit 1; }
if grep -nE 'panic|bounds_check|unwrap_failed|expect_failed|__rust_alloc|alloc::' "$assembly"; then
    echo "the controller can panic or allocate, see above" >&2
    exit 1
fi
echo "no panic path, no allocation: $(grep -cE '^_?_?[A-Za-z_].*:$' "$assembly") symbols checked"

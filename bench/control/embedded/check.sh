#!/bin/sh
# Builds the controller for a Cortex-M4F and fails when its machine code, or the sine and cosine that it calls, can reach a
# panic or an allocator.
set -eu
cd "$(dirname "$0")"
deps="${CARGO_TARGET_DIR:-target}/thumbv7em-none-eabihf/release/deps"
forbidden='panic|bounds_check|unwrap_failed|expect_failed|__rust_alloc|alloc::'

cargo rustc --quiet --release --target thumbv7em-none-eabihf -- --emit asm
assembly=$(ls -t "$deps"/pairtrawl_control_embedded-*.s | head -n 1)
grep -q 'track' "$assembly" || { echo "no machine code was made" >&2; exit 1; }
if grep -nE "$forbidden" "$assembly"; then
    echo "the controller can panic or allocate, see above" >&2
    exit 1
fi

cargo rustc --quiet --release --package libm --target thumbv7em-none-eabihf -- --emit asm
assembly=$(ls -t "$deps"/libm-*.s | head -n 1)
# Only what sincosf needs: other functions of libm may panic, and are not called.
used=$(awk '/^_ZN4libm4math.*:$/ { used = /sincosf|rem_pio2f|rem_pio2_large|k_sinf|k_cosf|scalbn|floor/ } used' "$assembly")
echo "$used" | grep -q 'sincosf' || { echo "libm has no sincosf" >&2; exit 1; }
if echo "$used" | grep -nE "$forbidden"; then
    echo "sincosf can panic or allocate, see above" >&2
    exit 1
fi
echo "no panic path, no allocation"

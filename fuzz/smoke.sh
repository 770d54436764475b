#!/usr/bin/env bash
# Feeds each parser with mutated seeds for a few seconds: fuzz/smoke.sh [seconds each, 10]. Exit code 1 if one fails.
#
# Needs cargo and a C++ compiler, no nightly and no cargo-fuzz: coverage is a stable option of the compiler, and the fuzzer is a
# crate. ASAN=1 adds the address sanitizer, which stable has too once RUSTC_BOOTSTRAP lets it. `cargo fuzz run scene_toml` also works.
set -euo pipefail
cd "$(dirname "$0")"
seconds=${1:-10}
target=$(rustc -vV | sed -n 's/^host: //p')
flags="--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4"
flags+=" -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table"
flags+=" -Cllvm-args=-sanitizer-coverage-trace-compares"
if [ -n "${ASAN:-}" ]; then
    export RUSTC_BOOTSTRAP=1
    flags+=" -Zsanitizer=address"
fi
# With --target, build scripts and macros are not instrumented.
RUSTFLAGS="$flags" cargo build --quiet --release --target "$target"

mkdir -p artifacts
failed=0
for seeds in seeds/*/; do
    name=$(basename "$seeds")
    mkdir -p "corpus/$name"
    log=artifacts/$name.log
    if "target/$target/release/$name" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536 \
        -artifact_prefix="artifacts/$name-" "corpus/$name" "$seeds" >"$log" 2>&1; then
        echo "$name: ok, $(sed -n 's/^Done \([0-9]*\) runs in \([0-9]*\).*/\1 runs in \2 s/p' "$log")"
    else
        failed=1
        echo "$name: FAILED"
        tail -30 "$log"
    fi
done
exit $failed

#!/bin/sh
# Runs fuzzers that `make fuzz` has built, one after another; exits with 1 if one of them has found anything.
#
#   BUILD=build/fuzz tests/fuzz/run.sh SECONDS NAME...
#
# An input that ends a fuzzer is kept in $BUILD/findings/NAME-crash-... (-leak-, -timeout-, -oom-); `build/tests/fuzz/NAME FILE` replays
# it. When it is mended, put it into tests/fuzz/corpus/NAME under a name that tells what it was.
set -u
: "${BUILD:?}"
seconds=$1
shift
export UBSAN_OPTIONS=print_stacktrace=1 LSAN_OPTIONS="suppressions=$PWD/.ci/lsan.supp:print_suppressions=0"
# Scratch files in memory where there is such a place.
[ -w /dev/shm ] && export TMPDIR=/dev/shm
mkdir -p "$BUILD/findings"
found=0
for name in "$@"; do
    mkdir -p "$BUILD/corpus/$name"
    set -- -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 -reload=0 \
        -artifact_prefix="$BUILD/findings/$name-"
    [ ! -f "tests/fuzz/$name.dict" ] || set -- "$@" -dict="tests/fuzz/$name.dict"
    "$BUILD/fuzzers/$name" "$@" "$BUILD/corpus/$name" "tests/fuzz/corpus/$name" || found=1
done
exit $found

#!/bin/sh
# -ffast-math, and what it is made of, is nowhere: not in the flags of any object, nor in the program's own word on them.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
# shellcheck source=tests/support/check.sh
. tests/support/check.sh

# Of GCC and clang: what loses NaN, infinity, the sign of zero, denormal numbers or the order of operations.
fast='-(ffast-math|Ofast|funsafe-math-optimizations|ffinite-math-only|fassociative-math|freciprocal-math|fno-signed-zeros'
fast="$fast|mdaz-ftz|ffp-model=fast|ffp-contract=(fast|on)|fcx-limited-range|fapprox-func|fno-honor-[a-z]*)"

without() { ! grep -nE -e "$fast" "$1"; }

# Comments may speak of it.
sed 's/^#.*//' Makefile >"$tmp/Makefile"
check "Makefile" without "$tmp/Makefile"
check "flags of this build, those of SIMD sources among them" without "$BUILD/gen/flags"
"$ROUGHLIGHT" info >"$tmp/info"
check "info says the flags" grep -q '^flags.*-ffp-contract=off' "$tmp/info"
check "flags that the program was built with" without "$tmp/info"
grep -rnE -e '(pragma|__attribute__|optimize).*(fast-math|Ofast|fp_contract|float_control)' src studies >"$tmp/sources"
check "no pragma or attribute" test ! -s "$tmp/sources"

# The search finds what it is for.
echo "cc -O2 -g -Ofast" >"$tmp/bad"
seen() { ! without "$tmp/bad"; }
check "a flag would be seen" seen

summary

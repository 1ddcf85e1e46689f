#!/bin/sh
# What a program is known by: the sources that it was built from. Builds a copy of the tree: an empty commit recompiles one source and
# changes nothing else, a changed source gives another hash, and without git it is the same as with it.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
tree=$tmp/tree
n=0

ok() { n=$((n + 1)) && echo "ok - $1"; }
not_ok() { n=$((n + 1)) && echo "not ok - $1"; }
check() {
    name=$1
    shift
    if "$@"; then ok "$name"; else not_ok "$name"; fi
}

# The sources as they are now, and what has been built of them, with their times: what is not changed is not built again.
mkdir -p "$tree/$BUILD/obj"
tar -cf - Makefile .ci src studies shaders | tar -xf - -C "$tree"
cp -a "$BUILD/obj/src" "$BUILD/obj/studies" "$tree/$BUILD/obj/"
cp -a "$BUILD/gen" "$BUILD/libroughlight.a" "$BUILD/roughlight" "$BUILD/roughlight-oiio.so" "$tree/$BUILD/"
[ ! -d "$BUILD/obj/.ci" ] || cp -a "$BUILD/obj/.ci" "$tree/$BUILD/obj/"

# MAKEFLAGS are kept: they have the variables that this tree was built with.
build() { make -C "$tree" --no-print-directory BUILD="$BUILD" SETUP=check V= all >"$tmp/made" 2>&1 || cat "$tmp/made"; }
compiled() { sed -n 's/^  C[CX]*  *//p' "$tmp/made" | tr '\n' ' '; }
header() { sed -n "s/^#define $1 \"\(.*\)\"/\1/p" "$tree/$BUILD/gen/version.h"; }
# A hook or a signature of this machine's settings is none of our business.
in_tree() { git -C "$tree" -c user.name=test -c user.email=test@example.org -c commit.gpgsign=false -c core.hooksPath=/dev/null "$@"; }
commit() { in_tree commit -q "$@" -m "a commit"; }

build
check "without git the commit is unknown" [ "$(header RL_COMMIT)" = unknown ]
code=$(header RL_CODE)
check "and the code is that of the tree itself: $code" grep -q "RL_CODE \"$code\"" "$BUILD/gen/version.h"

if command -v git >/dev/null; then
    in_tree init -q
    echo "/$BUILD/" >"$tree/.gitignore"
    in_tree add -A
    commit
    build
    first=$(header RL_COMMIT)
    check "a clone: $first" [ ${#first} -eq 12 ]
    check "is the same code" [ "$(header RL_CODE)" = "$code" ]
    commit --allow-empty
    build
    check "an empty commit is another commit" [ "$(header RL_COMMIT)" != "$first" ]
    check "of the same code" [ "$(header RL_CODE)" = "$code" ]
    check "and compiles version.c alone: $(compiled)" [ "$(compiled)" = "src/base/version.c " ]
    build
    check "once" [ -z "$(compiled)" ]
else
    ok "an empty commit is the same code # SKIP there is no git here"
fi

for file in studies/spent.c src/base/hash.h src/image/oiio.cpp; do
    cp -p "$tree/$file" "$tmp/kept"
    echo "/* a comment */" >>"$tree/$file"
    make -C "$tree" --no-print-directory BUILD="$BUILD" SETUP=check "$BUILD/gen/version.h" >"$tmp/made" 2>&1 || cat "$tmp/made"
    check "a change of $file is other code" [ "$(header RL_CODE)" != "$code" ]
    cp -p "$tmp/kept" "$tree/$file"
done
build
check "taken back, it is the same again" [ "$(header RL_CODE)" = "$code" ]

echo "1..$n"

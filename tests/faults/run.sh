#!/bin/sh
# Proof that `roughlight study check` sees what it should: plants the faults NAME.patch of this folder one at a time in a copy of the
# tree, builds it, and expects exit code 1; and 0 for the harmless changes, harmless-NAME.patch. A patch that does not apply or build
# fails. `make faults` runs them all, or those that F names: some 20 seconds each.
#
#   BUILD=build tests/faults/run.sh [--scene SCENE]... [--seeds N] [FAULT]...
#
# --scene and --seeds are the check's: the cases of no scene (`none`), or fewer seeds, are quicker.
#
# stdout: a row a fault, TSV: fault, result (caught, passed, missed, alarmed, broken), metrics that are worse, the one that is
# farthest beyond what it can see, and what the fault is.
set -u
build=${BUILD:-build}
here=$(dirname "$0")
# shellcheck source=tests/faults/tree.sh
. "$here/tree.sh"
options=
while case ${1-} in --scene | --seeds) [ $# -ge 2 ] ;; *) false ;; esac do
    options="$options $1 $2"
    shift 2
done
for name; do
    [ -f "$here/$(basename "$name" .patch).patch" ] && continue
    echo "$0: no fault is called '$name'; there are: $(cd "$here" && echo *.patch | sed 's/\.patch//g')" >&2
    exit 2
done
scratch=$(mktemp -d) || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 130' INT TERM HUP
tab=$(printf '\t')
tree=$scratch/tree
failed=0

copy_tree || exit 2

# check: the rows in $scratch/rows; its exit code
# shellcheck disable=SC2086
check() { (cd "$tree" && exec "$build/roughlight" study check $options) >"$scratch/rows" 2>"$scratch/stderr"; }

# The number of metrics that are worse, and the one that is so by the largest multiple of what it detects.
worse() {
    awk -F "$tab" '
        NR > 1 && $6 == "worse" {
            n++
            size = $13 > 0 ? ($10 < 0 ? -$10 : $10) / $13 : 1e300
            if (n == 1 || size > largest) { largest = size; name = $3 " of " ($1 == "none" ? "" : $1 " ") $2 }
        }
        END { sub(/ width=[0-9]+ height=[0-9]+/, "", name); printf "%d\t%s", n, n ? name : "-" }' "$scratch/rows"
}

# row NAME RESULT WHAT
row() {
    printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$(worse)" "$3"
    case $2 in
    caught | passed) ;;
    *)
        failed=$((failed + 1))
        echo "$1: $2" >&2
        ;;
    esac
}

# judge EXPECTED CODE: one word
judge() {
    case $1$2 in
    00) echo passed ;;
    01) echo alarmed ;;
    11) echo caught ;;
    10) echo missed ;;
    *) echo broken ;;
    esac
}

: >"$scratch/rows"
printf 'fault\tresult\tworse\tmost\twhat\n'
if ! make_tree; then
    cat "$scratch/make" >&2
    exit 2
fi
check
row "(none)" "$(judge 0 $?)" "The sources as they are."

[ $# -gt 0 ] || set -- "$here"/*.patch
for patch; do
    name=$(basename "$patch" .patch)
    patch=$here/$name.patch
    what=$(head -n 1 "$patch")
    expected=1
    case $name in harmless-*) expected=0 ;; esac
    : >"$scratch/rows"
    if ! plant "$patch"; then
        cat "$scratch/patch" >&2
        row "$name" broken "$what"
        exit 1
    fi
    if make_tree; then
        check
        row "$name" "$(judge $expected $?)" "$what"
    else
        grep -E 'error' "$scratch/make" >&2
        row "$name" broken "$what"
    fi
    dig_out "$patch" || exit 2
done
[ $failed -eq 0 ]

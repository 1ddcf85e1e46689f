#!/bin/sh
# Databases that cannot be used: full disk, read-only folder, locked, damaged. Exit code 2, one line that names the file, nothing on
# stdout, and nothing lost of what was there.
set -u
tmp=$(mktemp -d)
mounted=
trap '[ -z "$mounted" ] || umount "$mounted"; rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
tab=$(printf '\t')
n=0

ok() { n=$((n + 1)) && echo "ok - $1"; }
not_ok() { n=$((n + 1)) && echo "not ok - $1"; }
check() {
    name=$1
    shift
    if "$@"; then ok "$name"; else not_ok "$name"; fi
}

# refused NAME PATTERN COMMAND...
refused() {
    name=$1 pattern=$2
    shift 2
    "$@" >"$tmp/stdout" 2>"$tmp/stderr"
    code=$?
    grep -v '^samples: cases: \|^[0-9]* cases to measure' "$tmp/stderr" >"$tmp/said" # progress, where something was measured before
    if [ $code -eq 2 ] && [ "$(wc -l <"$tmp/said")" -eq 1 ] && grep -Eq -- "$pattern" "$tmp/said" && [ ! -s "$tmp/stdout" ]; then
        ok "$name"
    else
        not_ok "$name: exit code $code: $(cat "$tmp/stderr")"
    fi
}

small="samples --quick --scene sphere-quad --axis rr=30 --axis rounds=0,1 --axis seeds=2 --axis width=32 --axis height=24
    --axis env_size=64 --axis samples=1,4"
# shellcheck disable=SC2086
run() { "$rl" study run $small --db "$@"; }
measured() { "$rl" study status --db "$1" 2>/dev/null | awk -F "$tab" '$1 == "samples" { print $5 }'; }

run "$tmp/good.db" 2>"$tmp/stderr" || cat "$tmp/stderr"
cases=$(measured "$tmp/good.db")
check "a good database: ${cases:=0} cases" [ "$cases" -ge 12 ]

# ---- No room -----------------------------------------------------------------------------------------------------

# limited KIB FILE: no file may grow beyond that
limited() { (trap '' XFSZ && ulimit -f $(($1 * 2)) && run "$2"); }
refused "no room for the first table" "/full.db: cannot" limited 4 "$tmp/full.db"
cp "$tmp/good.db" "$tmp/full.db"
refused "no room for a run that has nothing to do" "/full.db: cannot" limited 20 "$tmp/full.db"
check "loses nothing" [ "$(measured "$tmp/full.db")" -eq "$cases" ]
mkdir "$tmp/disk"
if mount -t tmpfs -o size=80k none "$tmp/disk" 2>/dev/null; then
    mounted=$tmp/disk
    mkdir "$mounted/cache" && cp "$tmp"/cache/* "$mounted/cache"
    refused "a disk that becomes full" "/disk/r.db: cannot .*full" run "$mounted/r.db"
    kept=$(measured "$mounted/r.db")
    check "what was measured before is kept: ${kept:-none} of $cases" [ "${kept:-0}" -lt "$cases" ]
    if mount -o remount,size=4m "$mounted" 2>/dev/null; then
        run "$mounted/r.db" 2>"$tmp/stderr"
        check "with room again the run goes on" grep -q "^$cases cases: $((cases - ${kept:-0})) measured, ${kept:-0} done before, 0 failed" "$tmp/stderr"
    fi
    refused "a full disk for tables" "cannot write.*No space" sh -c "dd if=/dev/zero of='$mounted/rest' 2>/dev/null; '$rl' study export --db '$tmp/good.db' -o '$mounted/tables'"
else
    ok "a disk that becomes full # SKIP no file system may be mounted here"
fi

# ---- No permission -----------------------------------------------------------------------------------------------

chmod 755 "$tmp"
mkdir "$tmp/read-only"
cp "$tmp/good.db" "$tmp/read-only/r.db"
chmod 444 "$tmp/read-only/r.db"
chmod 555 "$tmp/read-only"
# Root may write everywhere.
nobody=
[ "$(id -u)" -ne 0 ] || nobody="setpriv --reuid=65534 --regid=65534 --clear-groups"
if $nobody "$rl" study list >/dev/null 2>&1; then
    # shellcheck disable=SC2086
    refused "a folder that may not be written to" "/read-only/new.db: cannot open for writing: Permission denied" $nobody "$rl" study run $small --db "$tmp/read-only/new.db"
    # shellcheck disable=SC2086
    refused "a file that may not be written to" "/read-only/r.db: cannot open for writing: Permission denied" $nobody "$rl" study run $small --db "$tmp/read-only/r.db"
    check "which may be read" sh -c "$nobody '$rl' study status --db '$tmp/read-only/r.db' | grep -q '^samples'"
    # shellcheck disable=SC2086
    refused "a folder that may not be made" "/read-only/new.*Permission denied" $nobody "$rl" study export --db "$tmp/read-only/r.db" -o "$tmp/read-only/new"
    check "which is as it was" cmp -s "$tmp/good.db" "$tmp/read-only/r.db"
else
    ok "a folder that may not be written to # SKIP the program cannot be run as another user"
fi
chmod 755 "$tmp/read-only"

# ---- Locked ------------------------------------------------------------------------------------------------------

cp "$tmp/good.db" "$tmp/locked.db"
"$rl" study run samples --full --scene sphere-quad --db "$tmp/locked.db" 2>/dev/null &
writer=$!
# shellcheck disable=SC2034
for attempt in $(seq 200); do
    "$rl" study status --db "$tmp/locked.db" 2>/dev/null | grep -q "^samples${tab}full" && break
    sleep 0.1
done
refused "another run is writing" "/locked.db: locked: another run of roughlight" run "$tmp/locked.db"
refused "merging into it" "/locked.db: locked: another run of roughlight" "$rl" study merge "$tmp/locked.db" "$tmp/good.db"
check "one may look on" sh -c "'$rl' study status --db '$tmp/locked.db' | grep -q '^samples'"
kill -KILL $writer
wait $writer 2>/dev/null
run "$tmp/locked.db" 2>"$tmp/stderr"
check "killed, it holds no lock" grep -q "^$cases cases: 0 measured, $cases done before" "$tmp/stderr"

# ---- Damaged -----------------------------------------------------------------------------------------------------

size=$(wc -c <"$tmp/good.db")
damage() { # NAME: a good file to be spoilt
    cp "$tmp/good.db" "$tmp/$1.db"
    echo "$tmp/$1.db"
}
head -c 100 /dev/zero | tr '\0' 'x' | dd of="$(damage header)" conv=notrunc 2>/dev/null
truncate -s 50 "$(damage stump)"
truncate -s $((size / 2)) "$(damage half)"
truncate -s $((size - 512)) "$(damage short)"
head -c $((size - 8192)) /dev/zero | tr '\0' 'Z' | dd of="$(damage pages)" bs=4096 seek=2 conv=notrunc 2>/dev/null
for file in header stump half short pages; do
    cp "$tmp/$file.db" "$tmp/before"
    refused "$file: run" "/$file.db: (not an SQLite database|damaged)" run "$tmp/$file.db"
    refused "$file: dry run" "/$file.db: (not an SQLite database|damaged)" run "$tmp/$file.db" --dry-run
    for verb in status "export -o $tmp/out" "report -o $tmp/out"; do
        # shellcheck disable=SC2086
        refused "$file: ${verb%% *}" "/$file.db: (not an SQLite database|damaged)" "$rl" study $verb --db "$tmp/$file.db"
    done
    refused "$file: merge into" "/$file.db: (not an SQLite database|damaged)" "$rl" study merge "$tmp/$file.db" "$tmp/good.db"
    refused "$file: merge from" "/$file.db: (not an SQLite database|damaged)" "$rl" study merge "$tmp/new.db" "$tmp/good.db" "$tmp/$file.db"
    check "$file: the file is left as it was" cmp -s "$tmp/before" "$tmp/$file.db"
done

# A text where a number belongs: SQLite would give it as 0.
if command -v python3 >/dev/null && python3 -c 'import sqlite3' 2>/dev/null; then
    python3 -c "import sqlite3; sqlite3.connect('$(damage text)', isolation_level=None).execute(\"UPDATE metrics SET value = 'abc' WHERE name = 'rmse'\")"
    for verb in "export -o $tmp/out" "report -o $tmp/out" status; do
        # shellcheck disable=SC2086
        refused "text: ${verb%% *}" "/text.db: damaged: table metrics, column value, row of case [0-9]*, metric rmse: found the text 'abc'" "$rl" study $verb --db "$tmp/text.db"
    done
    refused "text: merge from" "/text.db: damaged: table metrics" "$rl" study merge "$tmp/merged.db" "$tmp/text.db"
else
    ok "a text where a number belongs # SKIP nothing here writes one"
fi
check "nothing is made beside them" [ ! -e "$tmp/new.db" -a ! -e "$tmp/out" -a -z "$(find "$tmp" -name '*-journal')" ]
echo "1..$n"

# For shell tests, which source it after making the folder $tmp:
#
#     check NAME COMMAND...    ok if the command succeeds, else the end of what it said
#     summary                  last: the counts, and whether none failed
passed=0
failed=0

check() {
    name=$1
    shift
    if "$@" >"$tmp/log" 2>&1; then
        passed=$((passed + 1))
        echo "ok - $name"
    else
        failed=$((failed + 1))
        echo "not ok - $name: $(tail -c 800 "$tmp/log" | tr '\n' ' ')"
    fi
}

summary() {
    echo "$passed passed, $failed failed"
    [ $failed -eq 0 ]
}

# shellcheck shell=sh disable=SC2154
# Sourced by what plants faults: a copy of the tree, built like this one, to plant them in. The caller has set `build` (where this tree
# is built), `scratch` (a folder of its own) and `tree` (in it, not there yet).

# The sources as they are now, and what has been built of them, with their times: what is not changed is not built again. The folder it
# is built in has the same name, since that is in the compiler's flags.
copy_tree() {
    mkdir "$tree" || return
    if git rev-parse --git-dir >/dev/null 2>&1; then
        git ls-files --cached --others --exclude-standard
    else
        find . -path "./$build" -prune -o -type f -print
    fi | tar -cf - -T - | tar -xf - -C "$tree" || return
    mkdir -p "$tree/$build"
    cp -a "$build/obj" "$build/gen" "$build/libroughlight.a" "$build/roughlight" "$build/roughlight-oiio.so" "$tree/$build/"
}

make_tree() { make -C "$tree" --no-print-directory BUILD="$build" SETUP=check all >"$scratch/make" 2>&1; }

# plant PATCH: leaves nothing in the tree if it does not apply
plant() { patch -d "$tree" -p1 -s -f <"$1" >"$scratch/patch" 2>&1; }

# dig_out PATCH. The time of what is put back must be later than that of what was built of it.
dig_out() {
    sleep 1
    patch -d "$tree" -p1 -s -f -R <"$1" || return
    grep '^+++ ' "$1" | sed "s,^+++ [^/]*/,$tree/,; s,$(printf '\t').*,," | xargs touch
}

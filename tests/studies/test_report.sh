#!/bin/sh
# The studies from end to end: a quick run that is killed, interrupted, finished and skipped; its tables; the report, which
# a browser then opens: every picture loads, every claim is there, and the page is not blank.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
db=$tmp/results.db
tab=$(printf '\t')

# check NAME CONDITION...: the condition is a command
check() {
    name=$1
    shift
    if "$@"; then echo "ok - $name"; else echo "not ok - $name"; fi
}

# refused NAME PATTERN ARGUMENTS...: exit code 2, and one line on stderr that matches
refused() {
    name=$1 pattern=$2
    shift 2
    "$rl" "$@" >"$tmp/stdout" 2>"$tmp/stderr"
    code=$?
    if [ $code -eq 2 ] && [ "$(wc -l <"$tmp/stderr")" -eq 1 ] && grep -q -- "$pattern" "$tmp/stderr"; then
        echo "ok - $name"
    else
        echo "not ok - $name: exit code $code, $(cat "$tmp/stderr")"
    fi
}

column() { # column NAME FILE: the values of a column of a TSV file
    awk -F "$tab" -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i; next } { print $c }' "$2"
}

# ---- Bad requests ------------------------------------------------------------------------------------------------

refused "an unknown verb" "expected list, run, status, export, merge, report or check" study draw
refused "no study named" "found no study, expected at least one" study run --db "$db"
refused "an unknown study" "no study 'sample'" study run sample --db "$db"
refused "two grids" "found both, expected one of them" study run fps --quick --full --db "$db"
refused "an unknown scene" "no-such-scene" study run fps --quick --scene no-such-scene --db "$tmp/x.db"
refused "one scene twice" "was given before" study run fps --quick --scene sphere-quad --scene sphere-quad --db "$tmp/x.db"
# Scenes that do not fit, do not exist, or would: none of them is looked at.
for study in distribution interpolation hard; do
    for scene in glass lamps teapot-star no-such-scene; do
        refused "$study: a scene" "--scene: found '$scene', but the study $study takes no scene" \
            study run $study --quick --scene $scene --db "$tmp/x.db"
    done
done
refused "a scene for a study that takes none, beside one that does" "'sphere-quad', but the study distribution takes no scene" \
    study run fps distribution --quick --scene sphere-quad --dry-run --db "$tmp/x.db"
refused "a database that is not there" "No such file" study status --db "$tmp/nowhere.db"
refused "a database in no writable place" "/proc/" study run fps --quick --db /proc/results.db
echo "not a database, but long enough to be taken for one ............................................" >"$tmp/text.db"
refused "a text file as database" "not an SQLite database" study report --db "$tmp/text.db" -o "$tmp/r"
check "which is left as it was" grep -q "not a database, but" "$tmp/text.db"

"$rl" study list >"$tmp/list.tsv"
for study in distribution samples roughness bitdepth frame margin environment budget effects fps bare visibility accuracy hard; do
    check "list has study $study" [ "$(column study "$tmp/list.tsv" | grep -cx $study)" -eq 1 ]
done

# ---- Killed, interrupted, finished, skipped --------------------------------------------------------------------------

for pause in 0.3 0.9 1.6; do
    "$rl" study run samples fps --quick --db "$db" 2>/dev/null &
    pid=$!
    sleep $pause
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
done
measured() { # cases of samples that a database has
    "$rl" study status --db "$1" 2>/dev/null | awk -F "$tab" '$1 == "samples" { n += $5 } END { print n + 0 }'
}
# The default grid takes a minute and more: it cannot end before it is interrupted.
"$rl" study run samples --db "$tmp/long/r.db" 2>"$tmp/stderr" &
pid=$!
for attempt in $(seq 300); do
    [ "$(measured "$tmp/long/r.db")" -ge 4 ] && break
    sleep 0.1
done
kill -INT $pid
wait $pid
check "Ctrl-C gives exit code 130" [ $? -eq 130 ]
check "and says what was finished" grep -q "cases: .* measured" "$tmp/stderr"
kept=$(measured "$tmp/long/r.db")
check "what was finished before is kept: $kept of 228" [ "$kept" -ge 4 -a "$kept" -lt 228 ]
rm -rf "$tmp/long"

"$rl" study run samples fps --quick --db "$db" 2>"$tmp/stderr"
check "the next run finishes" [ $? -eq 0 ]
check "a study done, it says how far it is and how long the rest may take" \
    grep -q "^samples: cases: .* in .* s; of all: [0-9]* of [0-9]*, about [0-9]* s left" "$tmp/stderr"
check "and says where its time went" [ "$(tail -n 1 "$tmp/stderr" | sed 's/[0-9.][0-9.]*/N/g')" = \
    "N s: N % measured, N % reference, N % set-up, N % evaluation, N % harness" ]
"$rl" study status --db "$db" >"$tmp/status.tsv"
check "every planned case is measured" [ "$(column planned "$tmp/status.tsv")" = "$(column measured "$tmp/status.tsv")" ]
check "none failed" [ -z "$(column failed "$tmp/status.tsv" | grep -vx 0)" ]
"$rl" study run samples fps --quick --db "$db" 2>"$tmp/stderr"
check "one more run has nothing to do" grep -q "^161 cases: 0 measured, 161 done before, 0 failed" "$tmp/stderr"
check "references are computed once each" [ "$(ls "$tmp/cache" | wc -l)" -eq 12 ]
check "nothing half-written is left" [ -z "$(find "$tmp" -name '.*' -type f)" ]

# A scene that cannot be measured: it is named, the others are, and the exit code says so.
mkdir "$tmp/empty"
PATH_TO_SHADERS=$tmp/empty
cp -r shaders plots "$PATH_TO_SHADERS"
mkdir -p "$tmp/empty/studies" && cp -r studies/scenes "$tmp/empty/studies"
echo "oops" >>"$tmp/empty/shaders/methods/random.glsl"
ROUGHLIGHT_DATA=$tmp/empty "$rl" study run fps --quick --scene sphere-quad --db "$tmp/broken.db" 2>"$tmp/stderr"
check "a failing case gives exit code 3" [ $? -eq 3 ]
check "and is named with the reason" grep -q "failed: fps sphere-quad arm=random-4 .*random" "$tmp/stderr"
"$rl" study run fps --quick --scene sphere-quad --db "$tmp/broken.db" 2>"$tmp/stderr"
check "with the fault repaired it is tried again" grep -q "59 cases: 59 measured, 0 done before, 0 failed" "$tmp/stderr"

# ---- The study that has cases without a scene ---------------------------------------------------------------------

"$rl" study run accuracy --quick --db "$db" 2>"$tmp/stderr"
check "accuracy runs" [ $? -eq 0 ]
"$rl" study run accuracy --quick --scene teapot-star --db "$tmp/r2.db" 2>/dev/null &
pid=$!
sleep 0.2
kill -INT $pid
wait $pid
check "and stops on Ctrl-C" [ $? -eq 130 ]

# ---- Tables ------------------------------------------------------------------------------------------------------

mkdir "$tmp/tables" && echo "of another database" >"$tmp/tables/margin.tsv"
"$rl" study export --db "$db" -o "$tmp/tables" 2>"$tmp/stderr" && "$rl" study export --db "$db" --format json -o "$tmp/tables" 2>"$tmp/stderr"
check "claims.tsv has its columns" [ "$(head -n 1 "$tmp/tables/claims.tsv")" = \
    "claim${tab}verdict${tab}value${tab}low${tab}high${tab}unit${tab}study${tab}command${tab}scene${tab}figure${tab}note${tab}cases${tab}size_px${tab}seeds" ]
check "and every table has rows: none is written of studies that were not run, or left of another database" \
    [ -z "$(wc -l "$tmp"/tables/*.tsv | awk '$1 < 2')" -a ! -e "$tmp/tables/margin.tsv" -a ! -e "$tmp/tables/budget.json" ]
check "every verdict is one of four" [ -z "$(column verdict "$tmp/tables/claims.tsv" |
    grep -vx 'holds\|holds up to\|fails\|inconclusive')" ]
# Value and interval are numbers; an end is infinite where nothing bounds it (studies/README.md), and holds the value.
unnumbered() { # unnumbered FILE: the claims that are not so
    awk -F "$tab" 'function number(x) { return x ~ /^-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$/ }
        NR > 1 && !(number($3) && (number($4) || $4 == "-inf") && (number($5) || $5 == "inf") &&
            ($4 == "-inf" || $4 <= $3) && ($5 == "inf" || $3 <= $5) && $6 != "") { print $1 ": " $3 " [" $4 ", " $5 "] " $6 }
        END { if (NR < 20) print "only " NR - 1 " claims were looked at" }' "$1"
}
check "every claim has a number and its interval ($(unnumbered "$tmp/tables/claims.tsv"))" [ -z "$(unnumbered "$tmp/tables/claims.tsv")" ]
# The studies that are brief in `make report`, too; a grid that has no number for a claim has no row of it.
"$rl" study run interpolation visibility --quick --db "$tmp/more.db" 2>"$tmp/stderr" && "$rl" study export --db "$tmp/more.db" -o "$tmp/more"
check "nor of two more studies ($(unnumbered "$tmp/more/claims.tsv"))" [ -z "$(unnumbered "$tmp/more/claims.tsv")" ]
"$rl" study run samples --quick --scene sphere-quad --axis rr=30 --axis samples=4 --db "$tmp/few.db" 2>"$tmp/stderr"
"$rl" study export --db "$tmp/few.db" -o "$tmp/few" 2>"$tmp/stderr"
check "and of a grid that is too small for some claims" [ -z "$(unnumbered "$tmp/few/claims.tsv" | grep -v '^only')" -a \
    "$(wc -l <"$tmp/few/claims.tsv")" -gt 1 ]
check "it is said how many" grep -q "no number for [1-9][0-9]* claims, which are not in claims.tsv; the report's pages list them" "$tmp/stderr"
check "a row each case of samples" [ "$(wc -l <"$tmp/tables/samples.tsv")" -eq 91 ]
check "a row each arm of fps" [ "$(wc -l <"$tmp/tables/fps.tsv")" -eq 72 ]
check "and each cost model of the first scene" [ "$(wc -l <"$tmp/tables/fps_models.tsv")" -eq 16 ]
check "a row each case of accuracy" [ "$(cat "$tmp"/tables/accuracy_*.tsv | wc -l)" -eq \
    $((3 + $("$rl" study status --db "$db" | awk -F "$tab" '$1 == "accuracy" { n += $5 } END { print n + 0 }'))) ]
for integrator in reference cubature montecarlo vegas cubature-uv; do
    check "accuracy has the integrator $integrator" [ "$(column integrator "$tmp/tables/accuracy_points.tsv" | grep -cx $integrator)" -gt 0 ]
done
check "the reference is within every tolerance" [ "$(awk -F "$tab" 'NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
    $c["integrator"] == "reference" && !($c["error_max"] <= $c["tolerance"])' "$tmp/tables/accuracy_points.tsv" | wc -l)" -eq 0 ]
check "raw frame times" [ "$(wc -l <"$tmp/tables/frame_times.tsv")" -gt 120 ]
for column in rmse rmse_low rmse_high noise floor bias relmse max frame_ms samples rr env_size_px scene_hash; do
    check "samples.tsv has a column $column" [ -n "$(column $column "$tmp/tables/samples.tsv" | head -n 1)" ]
done
check "what measured them, a row each study and scene" [ "$(column study "$tmp/tables/provenance.tsv" | sort -u | tr '\n' ' ')" = \
    "accuracy fps samples " -a "$(($(wc -l <"$tmp/tables/provenance.tsv") - 1))" -eq \
    "$("$rl" study status --db "$db" | awk -F "$tab" 'NR > 1 && $5 > 0' | wc -l)" ]
for column in scene_hash version commit dirty compiler cflags cpu backend renderer gl_version threads; do
    check "with a column $column, filled" [ -n "$(column $column "$tmp/tables/provenance.tsv")" -a \
        -z "$(column $column "$tmp/tables/provenance.tsv" | grep -x '')" ]
done
"$rl" study status --db "$db" >"$tmp/status.tsv"
check "and with the renderer that status names" [ "$(column renderer "$tmp/tables/provenance.tsv" | sort -u)" = \
    "$(column renderer "$tmp/status.tsv" | grep . | sort -u)" ]
for table in claims samples fps fps_models accuracy_points frame_times provenance; do
    check "$table.json is an array of objects" [ "$(head -c 5 "$tmp/tables/$table.json" | tr -d '\n')" = "[  {" ]
done

# ---- The report --------------------------------------------------------------------------------------------------

"$rl" study report --db "$db" -o "$tmp/report" 2>"$tmp/stderr"
check "the report is made" [ $? -eq 0 ]
page=$tmp/report/index.html
pages=$(cd "$tmp/report" && echo *.html)
check "an overview, and a page a study ($pages)" [ "$pages" = "accuracy.html fps.html index.html samples.html" ]
check "the tables beside them have rows" [ -z "$(wc -l "$tmp"/report/*.tsv | awk '$1 < 2')" ]
check "each page says where its study's time went" [ "$(sed -n 's/^<p class="spent">[0-9.]* s: [0-9.]* % measured, [0-9.]* % reference, [0-9.]* % set-up, [0-9.]* % evaluation.*/spent/p' \
    "$tmp/report/samples.html" "$tmp/report/fps.html" "$tmp/report/accuracy.html" | wc -l)" -eq 3 ]
# The shares are those of the table spent, over all groups of the study.
said=$(sed -n 's/^<p class="spent">\([0-9.]*\) s: \([0-9.]*\) % measured.*/\1 \2/p' "$tmp/report/samples.html")
summed=$(awk -F "$tab" '$1 == "samples" { m += $4; all += $4 + $5 + $6 + $7 } END { printf "%.1f %.1f", all, 100 * m / all }' \
    "$tmp/report/spent.tsv")
check "of samples $said, as its table has it ($summed)" [ "$said" = "$summed" ]
check "and the overview of each and of all" [ "$(grep -c 'class="spent"' "$page")" -eq 1 -a \
    "$(grep -o '<td class="number">[0-9.]* s</td>' "$page" | wc -l)" -eq 4 ]
check "they refer to nothing outside" [ -z "$(grep -o '\(src\|href\)="[a-z]*:[^"]*"' "$tmp"/report/*.html)" ]
check "the claim that no point of the quick grid is about stands on the page alone" [ "$(grep -c '<li>ours: the reference to 1e-5 is at least 10,000 times .*: paired by point at the 0 of 10 points' \
    "$tmp/report/accuracy.html")" -eq 1 -a -z "$(grep '10,000 times' "$tmp/report/claims.tsv")" ]
# Every "page.html#anchor", "file" and "#anchor", held against the files that are there and the pages' anchors.
broken=$(cd "$tmp/report" && awk '
    FNR == 1 { file[FILENAME] = 1 }
    { line = $0
      while (match(line, / id="[^"]*"/)) {
          name = substr(line, RSTART + 5, RLENGTH - 6)
          if (id[FILENAME "#" name]++) print FILENAME ": twice the anchor " name
          line = substr(line, RSTART + RLENGTH) }
      line = $0
      while (match(line, /(src|href)="[^"]*"/)) {
          link = substr(line, RSTART, RLENGTH); sub(/^[^"]*"/, "", link); sub(/"$/, "", link)
          links[++n] = link; from[n] = FILENAME
          line = substr(line, RSTART + RLENGTH) } }
    END { for (i = 1; i <= n; i++) {
              target = links[i]; sub(/#.*/, "", target); if (target == "") target = from[i]
              if (target in file) found = 1; else { found = (getline text < target) > 0; close(target) }
              if (!found) print from[i] ": no file " links[i]
              hash = index(links[i], "#")
              if (hash && !((target substr(links[i], hash)) in id)) print from[i] ": no anchor " links[i] }
          if (n < 300) print "only " n " links were looked at" }' $pages)
check "every link leads somewhere, and every anchor is there once ($broken)" [ -z "$broken" ]
# Every element that is opened is closed, in order: the pages have no attribute with > in it.
unclosed=$(cd "$tmp/report" && for file in $pages; do
    sed '1d; /^<style>/,/^<\/style>/d' "$file" | tr '\n' ' ' | grep -o '<[^>]*>' | awk -v file="$file" '
        { tag = $0; gsub(/^<\/?|[ >].*$/, "", tag) }
        tag ~ /^(meta|img|br|link)$/ { next }
        /^<\// { if (stack[n] != tag) { print file ": </" tag "> closes <" stack[n] ">"; exit } n--; next }
        { stack[++n] = tag }
        END { if (n) print file ": <" stack[n] "> is never closed" }'
done)
check "every element is closed ($unclosed)" [ -z "$unclosed" ]
# A verdict's number leads to the cases that it comes from: those are in the tables, of the claim's own scene.
traced=$(awk -F "$tab" '
    FNR == 1 { for (i = 1; i <= NF; i++) c[FILENAME, $i] = i; if (FILENAME ~ /claims/) claims = FILENAME; next }
    FILENAME != claims { scene[$(c[FILENAME, "identity"])] = c[FILENAME, "scene"] ? $(c[FILENAME, "scene"]) : "none"; next }
    { n = split($(c[claims, "cases"]), identity, " "); value = $(c[claims, "value"]) }
    value != "nan" && n == 0 { print "no cases: " $1 }
    { for (i = 1; i <= n; i++) {
          seen++
          if (!(identity[i] in scene)) print "no such case " identity[i] ": " $1
          else if (scene[identity[i]] != $(c[claims, "scene"])) print "a case of " scene[identity[i]] ": " $1 } }
    END { if (seen < 60) print "only " seen " cases were looked at" }' \
    "$tmp"/report/samples.tsv "$tmp"/report/fps.tsv "$tmp"/report/accuracy_*.tsv "$tmp"/report/claims.tsv)
check "every verdict with a number names cases of its scene in the tables ($traced)" [ -z "$traced" ]
shown=$(awk -F "$tab" 'NR > 1 && $10 != "" { print $7 "-" $10 "-" $9 ".small.png" }' "$tmp/report/claims.tsv" | sort -u)
check "every claim names a figure" [ "$(awk -F "$tab" 'NR > 1 && $10 == ""' "$tmp/report/claims.tsv" | wc -l)" -eq 0 ]
check "which is there" [ -z "$(for f in $shown; do [ -s "$tmp/report/$f" ] || echo "$f"; done)" ]
check "and the overview shows one beside every claim" [ "$(grep -o 'class="whose' "$page" | wc -l)" -eq \
    "$(grep -o 'class="small"' "$page" | wc -l)" ]
check "pictures as EXR beside it" [ "$(ls "$tmp"/report/picture-*.exr | wc -l)" -eq 8 ]
for study in samples:12 fps:12 accuracy:6; do
    n=${study#*:} study=${study%:*}
    check "every figure of $study is drawn, as SVG, as PNG and in small" [ "$(ls "$tmp"/report/$study-*.svg | wc -l)" -eq $n \
        -a "$(ls "$tmp"/report/$study-*.png | wc -l)" -eq $((2 * n)) -a "$(ls "$tmp"/report/$study-*.small.png | wc -l)" -eq $n ]
done
check "and none is missing" [ "$(cat "$tmp"/report/*.html | grep -c 'nothing to draw')" -eq 0 ]
cp shaders/methods/random.glsl "$tmp/empty/shaders/methods/"
echo "oops oops" >>"$tmp/empty/plots/samples.gp"
ROUGHLIGHT_DATA=$tmp/empty "$rl" study report --db "$db" -o "$tmp/broken-plots" 2>"$tmp/stderr"
check "a script that fails fails the report" [ $? -eq 2 ]
check "and is named" grep -q "plots/samples.gp: gnuplot failed" "$tmp/stderr"
PATH=$tmp/empty "$rl" study report --db "$db" -o "$tmp/no-plots" 2>"$tmp/stderr"
check "without gnuplot: exit code 2 and its name" grep -q "gnuplot: not found" "$tmp/stderr"

browser() { # the browser's own talk is not of interest
    chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
        --disable-component-update --disable-sync --hide-scrollbars --user-data-dir="$tmp/browser" "$@" 2>/dev/null
}
if ! command -v chromium >/dev/null; then
    echo "ok - the page in a browser # skip no chromium"
    exit
fi

# Copies of the pages that write each image's width and their own into the document once all is loaded, in one document of
# frames, since it takes a browser a second to start. Nothing may be wider than a phone: pages scroll down, never sideways.
for file in $pages; do
    sed 's#</body>#<script>addEventListener("load", () => parent.postMessage({page: "'"$file"'", text: document.body.innerText, \
        width: document.documentElement.scrollWidth, images: [...document.images].map(i => i.naturalWidth)}, "*"));</script></body>#' \
        "$tmp/report/$file" >"$tmp/report/probe-$file"
done
{
    echo '<!DOCTYPE html><meta charset="utf-8"><body><script>addEventListener("message", e => {
        const p = document.createElement("pre"), d = e.data;
        p.textContent = `\npage ${d.page} width ${d.width} images ${d.images.length} empty ${d.images.filter(w => w == 0).length}\n${d.text}\n`;
        document.body.append(p); });</script>'
    for file in $pages; do echo "<iframe src=\"probe-$file\" width=\"500\" height=\"900\"></iframe>"; done
} >"$tmp/report/probe.html"
browser --dump-dom --virtual-time-budget=60000 --window-size=1000,1000 "file://$tmp/report/probe.html" >"$tmp/dom.html"
for file in $pages; do
    check "the browser shows every image of $file" grep -q "^page $file width [0-9]* images $(grep -o '<img' "$tmp/report/$file" | wc -l) empty 0" "$tmp/dom.html"
    width=$(sed -n "s/^page $file width \([0-9]*\) .*/\1/p" "$tmp/dom.html")
    check "$file fits a narrow window (${width:-unknown} of 500 pixels)" [ "${width:-9999}" -le 500 ]
done
# The claims' only special characters are quotes and <; a page has them without "paper: " and "(scene)".
sed "s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g" "$tmp/dom.html" >"$tmp/dom.txt"
absent=$(column claim "$tmp/report/claims.tsv" | sed 's/^[a-z]*: //; s/ (teapot-star)$//; s/ (sphere-quad)$//; s/ (three-lights)$//' | sort -u | while read -r claim; do
    [ "$(grep -cF -- "$claim" "$tmp/dom.txt")" -ge 2 ] || echo "$claim"
done)
check "every claim is on the overview and on its study's page ($absent)" [ -z "$absent" ]
rm "$tmp"/report/probe*.html

for size in 1280,4000 400,4000; do
    browser --screenshot="$tmp/page.png" --window-size=$size "file://$page"
    browser --screenshot="$tmp/blank.png" --window-size=$size about:blank
    "$rl" compare "$tmp/page.png" "$tmp/blank.png" >"$tmp/compare.tsv" 2>"$tmp/stderr"
    check "at $size the page is not blank" awk -v rmse="$(column rmse "$tmp/compare.tsv")" 'BEGIN { exit !(rmse > 0.05) }'
done

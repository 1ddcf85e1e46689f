#!/bin/sh
# The figures that the studies store and export, held against what they must obey and against the same case made by hand.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
n=0

# check NAME TABLE AWK: the program sees the columns by name as c["name"], row by row, and calls bad("why"); it must see a row.
check() {
    n=$((n + 1))
    why=$(awk -F'\t' 'function slack(x) { return 1e-9 * (x < 0 ? -x : x) + 1e-12 }
        function bad(why) { if (!failed++) print "row " NR ": " why }
        function near(a, b, tolerance) { d = a - b; s = b < 0 ? -b : b; return (d < 0 ? -d : d) <= tolerance * (s > 1e-12 ? s : 1e-12) }
        NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i; next }
        { for (i = 1; i <= NF; i++) c[name[i]] = $i }
        '"$3"'
        END { if (!seen) print "no row was looked at" }' "$2")
    [ -z "$why" ] && echo "ok - $1" || echo "not ok - $1: $why"
}

"$rl" study run samples fps --quick --scene teapot-star --db "$tmp/r.db" 2>"$tmp/err" || cat "$tmp/err"
"$rl" study export --db "$tmp/r.db" -o "$tmp" >/dev/null 2>"$tmp/err" || cat "$tmp/err"

check "frames a second are the inverse of the frame time, the interval's ends exchanged" "$tmp/fps.tsv" '
    { seen = 1
      if (!near(c["fps"] * c["frame_ms"], 1000, 1e-6)) bad("fps " c["fps"])
      if (!near(c["fps_low"] * c["frame_ms_high"], 1000, 1e-6) || !near(c["fps_high"] * c["frame_ms_low"], 1000, 1e-6)) bad("interval") }'
check "the paper's Table 1 stands beside it" "$tmp/fps.tsv" '
    BEGIN { paper["plain"] = 530; paper["regular-13"] = 28; paper["random-4"] = 38 }
    c["series"] == "table1" && c["arm"] in paper { seen = 1; if (c["paper_fps"] != paper[c["arm"]]) bad(c["arm"] " " c["paper_fps"]) }'
check "what is above the frame without highlight is the difference of both medians, nearly" "$tmp/fps.tsv" '
    c["series"] == "table1" && c["arm"] == "none" { none = c["frame_ms"]; wide = c["frame_ms_high"] - c["frame_ms_low"] }
    c["series"] == "table1" && c["arm"] == "regular-13" { seen = 1
      off = c["frame_ms"] - none - c["above_baseline_ms"]
      if ((off < 0 ? -off : off) > wide + c["frame_ms_high"] - c["frame_ms_low"]) bad("off by " off) }'
check "the rounds stop at what was asked, and say how precise they are" "$tmp/fps.tsv" '
    { seen = 1
      if (c["frames"] < c["rounds"] || c["frames"] > 3 * c["rounds"]) bad("frames " c["frames"] " of " c["rounds"])
      half = c["frame_ms_high"] - c["frame_ms"]; if (c["frame_ms"] - c["frame_ms_low"] > half) half = c["frame_ms"] - c["frame_ms_low"]
      if (!near(c["time_precision"], half / c["frame_ms"], 1e-6)) bad("precision " c["time_precision"])
      if (c["time_precise"] != (c["time_precision"] <= 0.02)) bad("precise " c["time_precise"])
      if (c["time_capped"] != 1 - c["time_precise"]) bad("capped " c["time_capped"]) }'
check "an environment map an object, a normal map a roughness, about as many pixels" "$tmp/fps.tsv" '
    c["series"] == "objects" && c["arm"] == "random-4" { seen = 1
      if (c["env_maps"] != c["objects"]) bad("maps " c["env_maps"])
      if (c["objects"] == 1) one = c["drawn_px"]
      if (c["drawn_px"] < 0.6 * one || c["drawn_px"] > 1.4 * one) bad("drawn " c["drawn_px"] " against " one) }
    c["series"] == "roughness" && c["arm"] == "random-4" && c["normal_maps"] != c["roughnesses"] { bad("maps " c["normal_maps"]) }'
check "models name their points, and every interval holds its value" "$tmp/fps_models.tsv" '
    { seen = 1
      if (c["points"] < 3) bad(c["model"] " has " c["points"] " points")
      for (k in c) { base = k; if (sub(/_low$/, "", base) && c[base] != "" && c[base] != "nan")
          if (c[k] > c[base] + slack(c[base]) || c[base "_high"] < c[base] - slack(c[base])) bad(base " " c[k] " " c[base]) } }'
check "every interval holds its value" "$tmp/samples.tsv" '
    c["series"] != "time" { seen = 1
      for (k in c) { base = k; if (sub(/_low$/, "", base) && c[base] != "" && c[k] != "")
          if (c[k] > c[base] + slack(c[base]) || c[base "_high"] < c[base] - slack(c[base])) bad(base " " c[k] " " c[base] " " c[base "_high"]) } }'
check "the squared error is bias squared and variance" "$tmp/samples.tsv" '
    c["series"] != "time" { seen = 1
      if (!near(c["rmse"] ^ 2, c["bias2"] + c["variance"], 1e-6)) bad(c["rmse"] ^ 2 " against " c["bias2"] + c["variance"])
      if (c["bias2"] > 0 && !near(c["floor"] ^ 2, c["bias2"], 1e-6)) bad("floor " c["floor"])
      if (!near(c["noise"] ^ 2, c["variance"], 1e-6)) bad("noise " c["noise"]) }'
check "seeds differ: random has noise, regular has none" "$tmp/samples.tsv" '
    c["series"] != "time" { seen = 1
      if (c["method"] == "random" && !(c["variance"] > 1e-6)) bad("variance of random " c["variance"])
      if (c["method"] == "regular" && c["variance"] != 0) bad("variance of regular " c["variance"]) }'
check "sixteen times the samples, a quarter of the noise" "$tmp/samples.tsv" '
    c["series"] == "methods" && c["method"] == "random" && c["rr"] == 30 && c["samples"] == 4 { four = c["noise"] }
    c["series"] == "methods" && c["method"] == "random" && c["rr"] == 30 && c["samples"] == 64 { seen = 1
      if (four / c["noise"] < 3.6 || four / c["noise"] > 4.4) bad("ratio " four / c["noise"]) }'
check "what is timed says how well, and why it stopped" "$tmp/samples.tsv" '
    c["frame_ms"] != "nan" { seen = 1
      if (c["frames"] < 6 || c["frames"] > 12) bad(c["frames"] " frames")
      if (c["time_capped"] != (c["time_precision"] > 0.02)) bad("precision " c["time_precision"] ", capped " c["time_capped"]) }'
check "the baseline has nothing above itself, 64 normals have more than 4" "$tmp/samples.tsv" '
    c["series"] == "time" && c["method"] == "none" { seen = 1; if (c["above_baseline_ms"] != 0) bad(c["above_baseline_ms"]) }
    c["series"] == "methods" && c["method"] == "random" && c["frame_ms"] != "nan" { above[c["samples"]] = c["above_baseline_ms"] }
    END { if (!(above[64] > above[4])) print above[64] " ms and " above[4] " ms" }'
check "seen from the object s centre, the largest map leaves little of the floor" "$tmp/samples.tsv" '
    c["series"] == "floor" { if (c["env_size_px"] > size) { size = c["env_size_px"]; floor = c["floor"]; centre = c["floor_centre"] } seen = 1 }
    END { if (!(floor > 0.01 && centre < 0.2 * floor)) print "floor " floor ", from the centre " centre }'

# One case by hand: regular 13 at R_r 30, the paper's settings, at the study's size.
scene=studies/scenes/teapot-star.yaml
"$rl" render $scene --method regular --rr 30 --size 160x120 -o "$tmp/a.exr" 2>"$tmp/err" || cat "$tmp/err"
"$rl" render $scene --method reference --rr 30 --size 160x120 --tolerance 1e-4 -o "$tmp/r.exr" 2>"$tmp/err" || cat "$tmp/err"
"$rl" compare "$tmp/a.exr" "$tmp/r.exr" | tail -1 >"$tmp/hand"
read -r rmse mae largest bias relmse rest <"$tmp/hand"
check "a case made by hand has the same figures" "$tmp/samples.tsv" '
    c["series"] == "methods" && c["setting"] == "paper" && c["method"] == "regular" && c["rr"] == 30 && c["samples"] == 13 { seen = 1
      if (!near(c["rmse"], '"$rmse"', 1e-5)) bad("rmse " c["rmse"] ", by hand '"$rmse"'")
      if (!near(c["mae"], '"$mae"', 1e-5)) bad("mae " c["mae"] ", by hand '"$mae"'")
      if (!near(c["max"], '"$largest"', 1e-5)) bad("max " c["max"] ", by hand '"$largest"'")
      if (!near(c["bias"], '"$bias"', 1e-5)) bad("bias " c["bias"] ", by hand '"$bias"'")
      if (!near(c["relmse"], '"$relmse"', 1e-5)) bad("relmse " c["relmse"] ", by hand '"$relmse"'") }'

# ---- Titles say what was measured ------------------------------------------------------------------------------

"$rl" study run frame environment samples --quick --scene sphere-quad --axis rr=200 --db "$tmp/200.db" 2>"$tmp/err" || cat "$tmp/err"
"$rl" study run distribution --quick --axis rr=200 --db "$tmp/200.db" 2>"$tmp/err" || cat "$tmp/err"
"$rl" study export --db "$tmp/200.db" -o "$tmp/200" >/dev/null 2>"$tmp/err" || cat "$tmp/err"
for study in frame distribution samples; do # as the report gives them to its plots
    awk -F '\t' -v study=$study 'NR == 1 || $1 == study' "$tmp/200/frame_times.tsv" >"$tmp/200/${study}_raw.tsv"
done
# (The pictures of distribution are of one R_r, which no axis replaces.)
for figure in frame-map frame-width frame-highlight distribution-histogram environment-size environment-format \
    environment-parallax environment-seam samples-split samples-floor samples-time; do
    n=$((n + 1))
    study=${figure%%-*} scene=sphere-quad
    case $study in frame | distribution) scene=none ;; esac
    gnuplot -c "plots/$study.gp" plots/style.gp "$tmp/200" "$tmp/$figure.svg" "${figure#*-}" $scene 2>"$tmp/err"
    words=$(sed 's/<[^>]*>//g' "$tmp/$figure.svg" 2>/dev/null | tr -d ' \n')
    case $words in
    *Rr30*) echo "not ok - $figure of R_r 200: speaks of R_r 30" ;;
    *Rr200*) echo "ok - $figure of R_r 200 says so" ;;
    *) echo "not ok - $figure of R_r 200: does not say so: $(cat "$tmp/err")" ;;
    esac
done
echo "1..$n"

#!/bin/sh
# The GPU pipeline against the CPU integrator, whole images: with many samples, fine maps and the lights seen from the object's
# centre on both sides, all that is left between them is the samples' noise. G L_e lies in [0, 1] (radiance 1), so N random normals
# leave a pixel of value p an error of at most sqrt(p (1 - p)/N); over this picture that is an RMSE of about 0.006 at N = 512, and a
# mean over its 9180 pixels of less than 7e-5. A wrong direction, face, frame, density or attenuation is larger by far.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
n=0

render() {
    out=$1
    shift
    "$rl" render studies/scenes/sphere-quad.yaml --size 160x120 -o "$out" "$@" 2>"$tmp/err" || cat "$tmp/err"
}

# agrees NAME MIN_RMSE MAX_RMSE MAX_BIAS: $tmp/a.exr against $tmp/r.exr
agrees() {
    n=$((n + 1))
    row=$("$rl" compare "$tmp/a.exr" "$tmp/r.exr" | tail -1)
    if echo "$row" | awk -F'\t' -v low="$2" -v high="$3" -v bias="$4" \
        '{ exit !($1 >= low && $1 <= high && $4 <= bias && -$4 <= bias && $7 == 0 && $8 > 9000) }'; then
        echo "ok - $1"
    else
        echo "not ok - $1: rmse, mae, max, bias ... = $row; expected RMSE $2 to $3, bias at most $4"
    fi
}

fine="--samples 512 --normal-bits float --env-size 512"
for options in "" "--rr 1" "--rr 3" "--rr 300" "--attenuation off" "--frame printed" "--env-format rgba32f"; do
    # shellcheck disable=SC2086
    render "$tmp/r.exr" --method reference --light-from object $options
    # shellcheck disable=SC2086
    render "$tmp/a.exr" --method random $fine $options
    agrees "random 512 is the reference seen from the object's centre: ${options:-defaults}" 0.0005 0.008 3e-4
done

# The parallax of a single environment map: the reference seen from every point is something else.
render "$tmp/r.exr" --method reference --light-from point
agrees "seen from each point it is another picture (parallax)" 0.02 0.1 0.02

# regular has no noise but a cut of the tails, which shrinks with the pattern.
render "$tmp/r.exr" --method reference --light-from object
# shellcheck disable=SC2086
render "$tmp/a.exr" --method regular $fine
agrees "regular 512 comes near" 0.0005 0.008 1e-3
render "$tmp/a.exr" --method regular --samples 13
agrees "regular 13 does not" 0.02 0.2 0.02

echo "1..$n"

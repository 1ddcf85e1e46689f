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

fine="--samples 512 --env-size 512"
# What has no effect on the reference is refused there.
for options in "" "--rr 1" "--rr 3" "--rr 300" "--attenuation off" "--frame printed"; do
    # shellcheck disable=SC2086
    render "$tmp/r.exr" --method reference --light-from object $options
    # shellcheck disable=SC2086
    render "$tmp/a.exr" --method random --normal-bits float $fine $options
    agrees "random 512 is the reference seen from the object's centre: ${options:-defaults}" 0.0005 0.008 3e-4
done
render "$tmp/r.exr" --method reference --light-from object
# shellcheck disable=SC2086
render "$tmp/a.exr" --method random --normal-bits float $fine --env-format rgba32f
agrees "random 512 is the reference seen from the object's centre: --env-format rgba32f" 0.0005 0.008 3e-4

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

# exhaustive has no noise and sees from the object's centre too: what is left is its texels, which are fewer the larger the map.
for options in "" "--rr 1" "--rr 300" "--attenuation off"; do
    # shellcheck disable=SC2086
    render "$tmp/r.exr" --method reference --light-from object $options
    # shellcheck disable=SC2086
    render "$tmp/a.exr" --method exhaustive --env-size 512 $options
    agrees "exhaustive 512 is the reference seen from the object's centre: ${options:-defaults}" 0 1.5e-3 5e-5
done
render "$tmp/r.exr" --method reference --light-from object
render "$tmp/a.exr" --method exhaustive --env-size 16
agrees "exhaustive 16 is not" 2e-3 0.1 0.02
for simd in plain avx2; do
    render "$tmp/r.exr" --method exhaustive --env-size 64
    ROUGHLIGHT_SIMD=$simd
    export ROUGHLIGHT_SIMD
    if "$rl" info >"$tmp/info" 2>"$tmp/err"; then
        render "$tmp/a.exr" --method exhaustive --env-size 64
        agrees "exhaustive is the same in $simd" 0 1e-6 1e-6
    else
        n=$((n + 1))
        echo "ok - exhaustive is the same in $simd # SKIP $(cat "$tmp/err")"
    fi
    unset ROUGHLIGHT_SIMD
done

echo "1..$n"

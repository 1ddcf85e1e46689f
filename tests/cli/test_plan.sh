#!/bin/sh
# plan --format json as a program reads it: valid JSON, the rows of the text, and fields that agree with each other and with the prose.
set -u
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
rl=$ROUGHLIGHT
# shellcheck source=tests/support/check.sh
. tests/support/check.sh

# plan SCENE OPTIONS...: the same as TSV and JSON, for python
plan() {
    "$rl" plan "$@" >"$tmp/tsv" && "$rl" plan "$@" --format json >"$tmp/json"
}

cat >"$tmp/plan.py" <<'PYTHON'
import json, sys

folder = sys.argv[1]


def constant(text):
    raise ValueError(text)


def unique(pairs):
    assert len(dict(pairs)) == len(pairs), pairs
    return dict(pairs)


rows = json.load(open(folder + '/json'), parse_constant=constant, object_pairs_hook=unique)
text = [line.rstrip('\n').split('\t') for line in open(folder + '/tsv')]


def of(kind, name=None):
    return [r for r in rows if r['kind'] == kind and name in (None, r['name'])]


def one(kind, name):
    found = of(kind, name)
    assert len(found) == 1, (kind, name, found)
    return found[0]
PYTHON

# python TEXT: of the plan, with its rows
python() { { cat "$tmp/plan.py"; cat; } | python3 - "$tmp"; }

# What must hold of every plan.
sound() {
    plan "$@" && python <<'PYTHON'
TEXEL = {'rgba8': 4, 'rgb10a2': 4, 'r11g11b10f': 4, 'rgba16': 8, 'rgba16f': 8, 'rgba32f': 16, 'depth16': 2, 'depth24': 4,
         'depth24_stencil8': 4, 'depth32f': 4, 'depth32f_stencil8': 8}
assert text[0] == ['kind', 'name', 'detail']
assert [[r[key] for key in text[0]] for r in rows] == text[1:]
keys = {}
for r in rows:
    assert list(r)[:3] == text[0]
    kind = 'mesh' if 'parts' in r else r.get('resource') or r['kind']
    if kind in ('effect', 'highlight', 'sphere', 'mesh', 'culling', 'pass', 'module'):
        assert keys.setdefault(kind, list(r)) == list(r), (keys[kind], r)
    if r['kind'] in ('texture', 'buffer'):
        for key in ('resource', 'format', 'width', 'height', 'count', 'bytes', 'uploaded_bytes'):
            assert key in r, (key, r)
    if r.get('width'):
        assert r['bytes'] == r['width'] * r['height'] * r['count'] * TEXEL[r['format']], r
objects, materials = set(), {r['material'] for r in rows if 'material' in r}
for r in of('pass'):
    objects |= set(r['objects'])
    if r['pass'] == 'environment':
        assert (r['each'], r['draws']) == ('scene', 6 * len([t for t in of('texture') if t['count'] == 6])), r
    elif r['program'] is not None:
        assert (r['each'], r['draws']) == ('frame', len(r['objects'])), r
for r in rows:
    for part in r.get('parts', []):
        assert part['shared_from'] is None or part['shared_from'] in objects and part['bytes'] == part['count'] == 0, part
    if 'parts' in r:
        assert r['bytes'] == sum(part['bytes'] for part in r['parts']) and r['object'] in objects, r
    for name in r.get('shared_by', []) + ([r['object']] if 'shared_by' in r else []):
        assert name in objects, r
for r in of('module'):
    assert r['program'] in {p['program'] for p in of('pass')} and r['stage'] in ('vertex', 'fragment'), r
for r in of('dropped'):
    assert r['reason'] and ' ' not in r['reason'] and r['name'].startswith(r['dropped']), r
PYTHON
}

for path in studies/scenes/*.yaml; do
    check "$path" sound "$path"
    check "$path, nothing dropped, facets" sound "$path" --drop off --interpolation constant
done
check "on the CPU" sound studies/scenes/ball-shadow.yaml --shadows on
check "the integral" sound studies/scenes/three-lights.yaml --method reference
check "exhaustive" sound studies/scenes/office.yaml --method exhaustive
check "spheres of a size found" sound studies/scenes/sphere-quad.yaml --rr 300 --margin auto
check "halves" sound studies/scenes/two-roughness.yaml --normal-bits half --env-format rgba16f --depth-bits 32

sizes() {
    plan studies/scenes/two-roughness.yaml --normal-bits half --normal-size 64 --size 40x30 --margin 0.2 && python <<'PYTHON'
import re
maps = [r for r in of('texture') if 'bits' in r]
assert len(maps) == 2 and all((r['bytes'], r['uploaded_bytes']) == (64 * 64 * 8, 64 * 64 * 16) for r in maps), maps
depth, colour = one('buffer', 'depth'), one('buffer', 'colour')
assert (depth['width'], depth['height'], depth['format'], depth['bytes']) == (40, 30, 'depth24_stencil8', 4800)
assert (colour['bytes'], colour['uploaded_bytes']) == (40 * 30 * 16, 0)
assert one('buffer', 'stencil')['part_of'] == 'depth' and one('buffer', 'stencil')['bytes'] is None
left, right = one('buffer', 'mesh of left'), one('buffer', 'mesh of right')
assert left['bytes'] == 12 * (left['triangles'] + 2 * left['vertices'])
assert [p['shared_from'] for p in right['parts']] == ['left', 'left', None] and right['bytes'] == 12 * right['vertices']
assert re.match(r'%d vertices, %d triangles' % (left['vertices'], left['triangles']), left['detail'])
assert {r['samples'] for r in of('pass') if r['pass'] == 'highlight'} == {4}
assert all(r['margin'] == 0.2 and r['bound'] is None for r in of('sphere')) and of('sphere')
PYTHON
}
check "sizes, parts and samples are numbers" sizes

maps() {
    plan studies/scenes/three-lights.yaml && python <<'PYTHON'
map = one('texture', 'environment map 0')
assert map['shared_by'] == ['ball'] and map['count'] == 6 and map['uploaded_bytes'] == 0, map
PYTHON
}
check "an environment map says whose it is" maps

# Names of a scene are anybody's.
quoted() {
    sed 's/name: teapot/name: "a \\"tea\\\\pot\\", \\u00e9\\u0001"/' studies/scenes/teapot-star.yaml >"$tmp/quoted.yaml" &&
        "$rl" plan "$tmp/quoted.yaml" --format json >"$tmp/json" && "$rl" plan "$tmp/quoted.yaml" >"$tmp/tsv" && python <<'PYTHON'
assert 'a "tea\\pot", \u00e9\x01' in {n for r in of('pass') for n in r['objects']}, rows
PYTHON
}
check "names with quotes" quoted

reasons() {
    {
        cat studies/scenes/lamps.yaml
        echo '  - {name: out, position: [0, 9, 0], intensity: [0, 0, 0]}'
    } >"$tmp/dark.yaml"
    plan "$tmp/dark.yaml" --shadows off && python <<'PYTHON'
row = one('dropped', 'light out')
assert (row['dropped'], row['dropped_name'], row['reason'], row['detail']) == ('light', 'out', 'dark', 'its strength is 0')
assert row['material'] is None and row['object'] is None
PYTHON
}
check "a drop has kind, name and a code" reasons

# A plane that looks away from its light, a matt material that asks for a highlight, and what no one sees.
cat >"$tmp/drops.yaml" <<'YAML'
camera: {position: [0, 1, 4], target: [0, 0, 0], field-of-view: 40}
materials:
  - {name: matt, ambient: [0.1, 0.1, 0.1], rr: 10, highlight: random, specular: [0, 0, 0]}
  - {name: shiny, ambient: [0.1, 0.1, 0.1], rr: 10, highlight: random, specular: [1, 1, 1], diffuse: [0, 0, 0]}
  - {name: nobody, ambient: [0.1, 0.1, 0.1]}
objects:
  - {name: floor, shape: plane, material: shiny}
  - {name: ball, shape: sphere, material: shiny, scale: 0.5, translate: [0, 1, 0]}
  - {name: stone, shape: sphere, material: matt, scale: 0.5, translate: [1, 1, 0]}
  - {name: away, shape: sphere, material: matt, scale: 0.5, translate: [0, 1, 90]}
lights:
  - {name: low, radiance: [1, 1, 1], polygon: [[-1, -3, -1], [1, -3, -1], [1, -3, 1], [-1, -3, 1]]}
YAML
dropped() {
    plan "$tmp/drops.yaml" && python <<'PYTHON'
found = {(r['dropped'], r['dropped_name'], r['material'], r['object'], r['reason']) for r in of('dropped')}
expected = {('highlight', 'random', 'shiny', 'floor', 'lights-behind'), ('highlight', 'random', 'matt', None, 'zero-specular'),
            ('object', 'away', 'matt', 'away', 'outside-view'), ('material', 'nobody', 'nobody', None, 'not-worn'),
            ('effect', 'diffuse', 'shiny', None, 'zero-coefficients')}
assert found == expected, (found - expected, expected - found)
assert all(r['environment_map'] for r in of('dropped') if r['dropped'] == 'highlight')
PYTHON
}
check "of which material and object it is" dropped

summary

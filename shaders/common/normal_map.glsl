// The normal map: microfacet normals about (1, 0, 0) drawn from D, the random numbers baked in. Texels hold
// (H + 1)/2.
layout(binding = 1) uniform sampler2D normal_map;

// The texel for sample i of this pixel. The offsets of the samples run through the whole map in steps near
// the golden section of it: all distinct, and neighbouring pixels read neighbouring texels. The map repeats;
// its size is a power of two, so that the coordinates are exact.
vec3 microfacet_normal(int i)
{
    const uint size = uint(NORMAL_MAP_SIZE);
    uint at = (uint(i) * NORMAL_MAP_STEP) & (size * size - 1u);
    vec2 offset = vec2(at & (size - 1u), at / size);
    return 2.0 * textureLod(normal_map, (gl_FragCoord.xy + offset) / float(NORMAL_MAP_SIZE), 0.0).xyz - 1.0;
}

// The normal map: microfacet normals about (1, 0, 0) drawn from D, the random numbers baked in, stored as (H + 1)/2.
layout(binding = 1) uniform sampler2D normal_map;

// A texel for sample i of this pixel. The offsets of the samples run through the whole map in steps near the golden ratio of it:
// all distinct, and neighbouring pixels read neighbouring texels.
vec3 microfacet_normal(int i)
{
    const uint size = uint(NORMAL_MAP_SIZE);
    uint at = (uint(i) * uint(NORMAL_MAP_STEP)) & (size * size - 1u);
    uvec2 texel = (uvec2(gl_FragCoord.xy) + uvec2(at & (size - 1u), at / size)) & (size - 1u);
    return 2.0 * texelFetch(normal_map, ivec2(texel), 0).xyz - 1.0;
}

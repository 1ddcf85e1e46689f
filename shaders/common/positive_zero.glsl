// 0 for -0, by its bits: compilers take x + 0.0 for x, and a sum that began with 0 ends as -0 where all of its terms are -0.
vec3 positive_zero(vec3 x)
{
    return mix(x, vec3(0.0), equal(floatBitsToUint(x), uvec3(0x80000000u)));
}

// Random numbers by address, as src/model/random.h has them: 64 bits of (seed, index), by words, x the lower one.

uvec2 random_plus(uvec2 a, uvec2 b)
{
    uint carry;
    uint low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}

// Modulo 2^64.
uvec2 random_times(uvec2 a, uvec2 b)
{
    uint high;
    uint low;
    umulExtended(a.x, b.x, high, low);
    return uvec2(low, high + a.x * b.y + a.y * b.x);
}

// a ^ (a >> by), 0 < by < 32
uvec2 random_fold(uvec2 a, int by)
{
    return a ^ uvec2(a.x >> by | a.y << (32 - by), a.y >> by);
}

uvec2 random_mix(uvec2 x)
{
    x = random_times(random_fold(x, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
    x = random_times(random_fold(x, 27), uvec2(0x133111ebu, 0x94d049bbu));
    return random_fold(x, 31);
}

uvec2 random_bits(uvec2 seed, uvec2 index)
{
    const uvec2 golden = uvec2(0x7f4a7c15u, 0x9e3779b9u);
    uvec2 start = random_mix(random_plus(seed, golden));
    return random_mix(random_plus(start, random_times(random_plus(index, uvec2(1u, 0u)), golden)));
}

// Uniform in (0, 1): of the 52 bits that C has, the first 23, centred, which is all that fits below 1 in single precision.
float random_uniform(uvec2 seed, uvec2 index)
{
    return (float(random_bits(seed, index).y >> 9) + 0.5) * 1.1920928955078125e-7;
}

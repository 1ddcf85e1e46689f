// Light from one direction: unit L and the irradiance on a plane perpendicular to it.
struct Incident {
    vec3 L, irradiance;
};

// What pixels can hold of single precision: more than this is stored as this, in C as well (src/reference/renderer.c).
const float LARGEST = 3.4028234e38;

float largest_component(vec3 a)
{
    return max(abs(a.x), max(abs(a.y), abs(a.z)));
}

// The unit vector from P to Q, and what a light there gives at P that gives `strength` at distance 1, at most LARGEST: 0 times it is 0, which
// of infinity would be no number. A light at P itself has no direction and gives nothing. No square leaves the range: differences are scaled by
// a power of two to about 1, those of coordinates that may overflow by 1/4 before.
Incident incident(vec3 Q, vec3 P, vec3 strength)
{
    float quarter = max(largest_component(Q), largest_component(P)) > 1e37 ? 0.25 : 1.0;
    vec3 d = quarter * Q - quarter * P;
    float most = largest_component(d);
    if (!(most > 0.0))
        return Incident(vec3(0.0, 0.0, 1.0), vec3(0.0));
    uint exponent = clamp(floatBitsToUint(most) >> 23, 1u, 253u);
    float power = uintBitsToFloat((254u - exponent) << 23);
    d *= power;
    float r_r = dot(d, d);
    power *= quarter;
    return Incident(d * inversesqrt(r_r), min(strength / r_r * power * power, vec3(LARGEST)));
}

// Light from one direction: unit L and the irradiance on a plane perpendicular to it.
struct Incident {
    vec3 L, irradiance;
};

// From the vector to the light, and what it gives at distance 1. A light at the point itself has no direction and gives nothing.
Incident incident(vec3 d, vec3 strength)
{
    float r_r = dot(d, d);
    if (!(r_r > 0.0))
        return Incident(vec3(0.0, 0.0, 1.0), vec3(0.0));
    float inverse = 1.0 / r_r;
    return Incident(d * sqrt(inverse), strength * inverse);
}

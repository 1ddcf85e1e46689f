// Point and parallel lights (struct rl_source): position and 1, radiant intensity; or the unit direction towards the light and 0,
// irradiance.
struct Source {
    vec4 at;
    vec4 strength;
};

layout(std140, binding = 3) uniform Sources
{
    Source sources[max(N_SOURCES, 1)];
};

Incident from_source(int i, vec3 P)
{
    Source light = sources[i];
    return incident(light.at.xyz - light.at.w * P, light.strength.rgb);
}

// Point and parallel lights (struct rl_source), the point ones first: position, radiant intensity; or the unit direction towards the light,
// irradiance.
struct Source {
    vec4 at;
    vec4 strength;
};

layout(std140, binding = 3) uniform Sources
{
    Source sources[max(N_SOURCES, 1)];
};

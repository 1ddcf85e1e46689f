// Every shaped light of the scene shrunk to a point at its centroid (struct rl_point_light).
struct PointLight {
    vec4 position; // w: the area of one side
    vec4 normal;   // unit; zero for a light of many faces, which has no cosine
    vec4 radiance;
};

layout(std140, binding = 0) uniform PointLights
{
    PointLight point_lights[max(N_LIGHTS, 1)];
};

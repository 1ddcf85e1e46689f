// Sphere pass: keeps only pixels whose mirror direction meets the bounding sphere of some light, enlarged by
// the margin, or that lie inside of one. Colours are masked; the stencil buffer takes note.
layout(std140, binding = 2) uniform LightSpheres
{
    vec4 light_spheres[max(N_LIGHTS, 1)]; // centre and radius
};

uniform float sphere_scale; // 1 + margin

layout(location = 0) out vec4 colour;

bool meets(vec3 P, vec3 direction, vec3 centre, float radius)
{
    vec3 d = centre - P;
    float along = dot(direction, d);
    vec3 across = d - max(along, 0.0) * direction;
    return dot(across, across) <= radius * radius;
}

void main()
{
    Surface s = surface_here();
    vec3 mirror = reflect(-s.V, s.N);
    bool hit = false;
    for (int i = 0; i < N_LIGHTS; i++)
        hit = hit || meets(s.P, mirror, light_spheres[i].xyz, sphere_scale * light_spheres[i].w);
    if (!hit || !(dot(s.N, s.V) > 0.0))
        discard;
    colour = vec4(0.0);
}

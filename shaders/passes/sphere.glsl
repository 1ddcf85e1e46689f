// Sphere pass: keeps only pixels whose mirror direction meets the bounding sphere of some light, enlarged by
// the margin, or that lie inside of one. The ray starts where the highlight's method sees the lights from: at the
// object's centre if it reads an environment map, which was taken there, else at P. Colours are masked; the stencil
// buffer takes note.
layout(std140, binding = 2) uniform LightSpheres
{
    vec4 light_spheres[max(N_LIGHTS, 1)]; // centre and radius
};

uniform float sphere_scale; // 1 + margin
uniform vec4 seen_from;     // xyz: the object's centre; w: 1, or 0 for P instead

layout(location = 0) out vec4 colour;

bool meets(vec3 from, vec3 direction, vec3 centre, float radius)
{
    vec3 d = centre - from;
    float along = dot(direction, d);
    vec3 across = d - max(along, 0.0) * direction;
    return dot(across, across) <= radius * radius;
}

void main()
{
    Surface s = surface_here();
    vec3 mirror = reflect(-s.V, s.N);
    vec3 from = mix(s.P, seen_from.xyz, seen_from.w);
    bool hit = false;
    for (int i = 0; i < N_LIGHTS; i++)
        hit = hit || meets(from, mirror, light_spheres[i].xyz, sphere_scale * light_spheres[i].w);
    if (!hit || !(dot(s.N, s.V) > 0.0))
        discard;
    colour = vec4(0.0);
}

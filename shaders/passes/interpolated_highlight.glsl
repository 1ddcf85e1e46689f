// The same with the highlight of a method that needs no pass of its own, which is each pixel's.
uniform vec3 specular;

layout(location = 0) out vec4 colour;

void main()
{
    Surface s = surface_here();
    vec3 rgb = shade_constants() + interpolated_radiance();
    if (dot(s.N, s.V) > 0.0)
        rgb += specular * highlight(s) * highlight_factor(s);
    colour = vec4(min(rgb, vec3(3.4028234e38)), 1.0);
}

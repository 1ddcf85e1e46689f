// Surface pass: the sum of the effects, and the highlight of a method that needs no pass of its own.
uniform vec3 specular;

layout(location = 0) out vec4 colour;

void main()
{
    Surface s = surface_here();
    vec3 rgb = shade_effects(s);
    if (dot(s.N, s.V) > 0.0)
        rgb += specular * shade_highlight(s);
    // Beyond single precision: its largest number, as in src/reference/renderer.c.
    colour = vec4(min(rgb, vec3(3.4028234e38)), 1.0);
}

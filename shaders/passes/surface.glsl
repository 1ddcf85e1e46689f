// Surface pass: the sum of the effects, and the highlight of a method that needs no pass of its own.
uniform vec3 specular;

layout(location = 0) out vec4 colour;

void main()
{
    Surface s = surface_here();
    vec3 rgb = shade_effects(s);
    if (dot(s.N, s.V) > 0.0)
        rgb += specular * shade_highlight(s);
    colour = vec4(rgb, 1.0);
}

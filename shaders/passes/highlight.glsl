// Highlight pass: added to what the surface pass left. A normal that faces away from the eye, which
// interpolation makes at silhouettes, has no highlight.
uniform vec3 specular;

layout(location = 0) out vec4 colour;

void main()
{
    Surface s = surface_here();
    vec3 rgb = dot(s.N, s.V) > 0.0 ? specular * highlight(s) * highlight_factor(s) : vec3(0.0);
    colour = vec4(rgb, 0.0);
}

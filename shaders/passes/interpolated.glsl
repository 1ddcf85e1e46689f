// Surface pass of a material whose effects were evaluated in the vertex shader, but for those that are the same everywhere.
layout(location = 0) out vec4 colour;

void main()
{
    colour = vec4(shade_constants() + interpolated_radiance(), 1.0);
}

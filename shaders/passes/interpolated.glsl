// Surface pass of a material whose effects were evaluated in the vertex shader, but for those that are the same everywhere.
layout(location = 0) out vec4 colour;

void main()
{
    colour = vec4(min(shade_constants() + interpolated_radiance(), vec3(3.4028234e38)), 1.0);
}

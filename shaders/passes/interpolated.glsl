// Surface pass of a material whose effects were evaluated in the vertex shader.
layout(location = 0) out vec4 colour;

void main()
{
    colour = vec4(interpolated_radiance(), 1.0);
}

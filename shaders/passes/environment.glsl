// Environment pass: a light shows its radiance, in the map's unit.
flat in vec3 texel;

layout(location = 0) out vec4 colour;

void main()
{
    colour = vec4(texel, 1.0);
}

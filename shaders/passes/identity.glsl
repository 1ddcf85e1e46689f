// Identity pass: which object and which of its triangles a pixel shows, counted from 1.
uniform float object_number;

layout(location = 0) out vec4 colour;

void main()
{
    colour = vec4(object_number, float(gl_PrimitiveID + 1), 0.0, 1.0);
}

// A fixed pattern of microfacet normals about (1, 0, 0), weights in w, their sum 1.
layout(std140, binding = 1) uniform Pattern
{
    vec4 pattern[SAMPLES];
};

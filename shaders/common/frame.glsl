// An orthonormal tangent frame about a unit normal, columns N, T, B, without a branch. Duff, Burgess,
// Christensen, Hery, Kensler, Liani, Villemin: Building an Orthonormal Basis, Revisited. JCGT 6 (1), 2017. The diagonal is
// src/model/frame.c's, which does not cancel. The sign is that of zero, too, as in C.
mat3 tangent_frame(vec3 N)
{
    float s = floatBitsToInt(N.z) < 0 ? -1.0 : 1.0;
    float z = abs(N.z);
    vec2 over = N.xy / (1.0 + z);
    float b = -N.x * over.y;
    return mat3(N, vec3(z + N.y * over.y, b, -s * N.x), vec3(s * b, s * (z + N.x * over.x), -N.y));
}

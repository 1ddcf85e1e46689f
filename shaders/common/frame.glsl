// An orthonormal tangent frame about a unit normal, columns N, T, B, without a branch. Duff, Burgess,
// Christensen, Hery, Kensler, Liani, Villemin: Building an Orthonormal Basis, Revisited. JCGT 6 (1), 2017.
mat3 tangent_frame(vec3 N)
{
    float s = N.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (s + N.z);
    float b = N.x * N.y * a;
    return mat3(N, vec3(1.0 + s * N.x * N.x * a, s * b, -s * N.x), vec3(b, s + N.y * N.y * a, -N.y));
}

// The tangent frame as Kimura and Tokoi print it, columns N, T, B. T and B are orthogonal to N but have
// length sqrt(N.y^2 + N.z^2): lobes narrow as N turns to +-x and collapse there.
mat3 tangent_frame(vec3 N)
{
    return mat3(N, vec3(0.0, N.z, -N.y), vec3(N.y * N.y + N.z * N.z, -N.x * N.y, -N.x * N.z));
}

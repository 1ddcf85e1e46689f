// `random`: the mean of G L_e over SAMPLES microfacet normals from the normal map (Kimura and Tokoi).
vec3 highlight(Surface s)
{
    mat3 frame = tangent_frame(s.N);
    float n_v = dot(s.N, s.V);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SAMPLES; i++) {
        vec3 h = microfacet_normal(i);
        sum += microfacet_radiance(s, n_v, frame * h, h.x);
    }
    return environment_unit / float(SAMPLES) * sum;
}

// `regular`: G L_e over a fixed pattern of SAMPLES microfacet normals, weighted by D (Kimura and Tokoi).
vec3 highlight(Surface s)
{
    mat3 frame = tangent_frame(s.N);
    float n_v = dot(s.N, s.V);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SAMPLES; i++) {
        vec4 h = pattern[i];
        sum += h.w * microfacet_radiance(s, n_v, frame * h.xyz, h.x);
    }
    return environment_unit * sum;
}

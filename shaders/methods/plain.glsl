// `plain`: Phong's lobe about the mirror direction, from each light's centroid; no light shape.
//
//     sum over lights of  radiance max(0, R.L)^n,   N.L > 0
//
// params: n.
uniform vec4 plain_params[1];

vec3 highlight(Surface s)
{
    vec3 mirror = reflect(-s.V, s.N);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < N_LIGHTS; i++) {
        vec3 L = normalize(point_lights[i].position.xyz - s.P);
        float r_l = dot(mirror, L);
        float lobe = r_l > 0.0 && dot(s.N, L) > 0.0 ? pow(min(r_l, 1.0), plain_params[0].x) : 0.0;
        sum += lobe * point_lights[i].radiance.rgb;
    }
    return sum;
}

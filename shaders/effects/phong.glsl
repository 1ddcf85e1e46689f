// Phong's highlight: a lobe about the mirror direction R of the eye, for an irradiance of 1 perpendicular to L.
//
//     W(alpha) max(0, R.L)^n,   N.L > 0,   W(alpha) = reflectance(k_s, g, N.L)
//
// params: k_s and n; g.

vec3 reflect_phong(Surface s, vec3 L, vec4 params[2])
{
    float n_l = dot(s.N, L);
    float lobe = n_l > 0.0 ? power_of_cosine(reflect(-s.V, s.N), L, params[0].w) : 0.0;
    return lobe * reflectance(params[0].rgb, params[1].x, n_l);
}

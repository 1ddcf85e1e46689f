// Goldman's fur as a listing prints it, fibres along N, for an irradiance of 1 perpendicular to L:
//
//     (k_d |N x L| + k_s fur_cone(N, L, V, p)) f_dir f_surf
//     f_dir = ((1 + kappa)/2) rho_reflect + ((1 - kappa)/2) rho_transmit,   f_surf = 2 N.L + 1
//
// params: k_d and p; k_s and rho_reflect; rho_transmit.

vec3 reflect_goldman_printed(Surface s, vec3 L, vec4 params[3])
{
    float kappa = fur_kappa(s.N, L, s.V);
    float f_dir = 0.5 * ((1.0 + kappa) * params[1].w + (1.0 - kappa) * params[2].x);
    float f_surf = 2.0 * dot(s.N, L) + 1.0;
    float lobe = fur_cone(s.N, L, s.V, params[0].w);
    return (params[0].rgb * fur_sine(s.N, L) + params[1].rgb * lobe) * (f_dir * f_surf);
}

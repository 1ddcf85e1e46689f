// No attenuation: G = 1 for every direction, also below the horizon, so that constant radiance all round
// gives just that.
float attenuation(float n_h, float n_v, float n_l, float v_h)
{
    return 1.0;
}

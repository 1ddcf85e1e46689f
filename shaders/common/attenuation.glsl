// Geometric attenuation of V-shaped grooves (Torrance and Sparrow 1967; Blinn 1977):
//
//     G = max(0, min(1, 2 (N.H)(N.V)/(V.H), 2 (N.H)(N.L)/(V.H))),  G = 0 when N.L <= 0
//
// Only ratios count: a common factor of n_h and v_h, or of n_v, n_l and v_h, changes nothing, so H and L need
// not be unit vectors. The larger factor is divided first: the product of both might underflow where G does not.
float attenuation(float n_h, float n_v, float n_l, float v_h)
{
    float least = min(n_v, n_l);
    return v_h > 0.0 && least > 0.0 ? clamp(2.0 * (max(n_h, least) / v_h) * min(n_h, least), 0.0, 1.0) : 0.0;
}

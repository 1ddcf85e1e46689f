// Geometric attenuation of V-shaped grooves (Torrance and Sparrow 1967; Blinn 1977):
//
//     G = max(0, min(1, 2 (N.H)(N.V)/(V.H), 2 (N.H)(N.L)/(V.H))),  G = 0 when N.L <= 0
//
// Only ratios count: a common factor of n_h and v_h, or of n_v, n_l and v_h, changes nothing, so H and L need
// not be unit vectors.
float attenuation(float n_h, float n_v, float n_l, float v_h)
{
    float least = min(n_v, n_l);
    // A quotient first: the product of two small cosines is no number any more long before G is 0.
    return v_h > 0.0 && least > 0.0 ? clamp(n_h / v_h * (2.0 * least), 0.0, 1.0) : 0.0;
}

// W, the reflectance of a lobe: k_s, rising by a part g of the way to 1 at grazing incidence (Schlick 1994).
vec3 reflectance(vec3 k_s, float g, float cosine)
{
    float m = max(0.0, 1.0 - cosine);
    return mix(k_s, vec3(1.0), g * (m * m) * (m * m) * m);
}

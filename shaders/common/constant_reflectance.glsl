// W, the reflectance of a lobe: the same at every angle.
vec3 reflectance(vec3 k_s, float g, float cosine)
{
    return k_s;
}

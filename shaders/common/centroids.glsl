// Shaped lights as light from the direction of their centroids. A light at P itself has no direction and gives nothing.
Incident from_centroid(int i, vec3 P)
{
    PointLight light = point_lights[i];
    vec3 d = light.position.xyz - P;
    float r_r = dot(d, d);
    vec3 L = d / sqrt(r_r);
    bool flat_light = dot(light.normal.xyz, light.normal.xyz) > 0.0;
    float facing = flat_light ? abs(dot(light.normal.xyz, L)) : 1.0;
    if (!(r_r > 0.0))
        return Incident(vec3(0.0, 0.0, 1.0), vec3(0.0));
    return Incident(L, light.radiance.rgb * (light.position.w * facing / r_r));
}

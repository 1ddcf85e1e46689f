// Shaped lights as light from the direction of their centroids.
Incident from_centroid(int i, vec3 P)
{
    PointLight light = point_lights[i];
    Incident from = incident(light.position.xyz - P, light.radiance.rgb * light.position.w);
    if (dot(light.normal.xyz, light.normal.xyz) > 0.0)
        from.irradiance *= abs(dot(light.normal.xyz, from.L));
    return from;
}

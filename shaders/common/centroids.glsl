// Shaped lights as light from the direction of their centroids. A flat one gives nothing in its plane, as far as rounding lets one know
// (src/model/plane.h): 16 x 2^-23 of the coordinates.
Incident from_centroid(int i, vec3 P)
{
    PointLight light = point_lights[i];
    vec3 Q = light.position.xyz;
    vec3 strength = light.radiance.rgb * light.position.w;
    if (dot(light.normal.xyz, light.normal.xyz) > 0.0) {
        if (!(abs(dot(light.normal.xyz, Q - P)) > 1.9073486e-6 * dot(abs(light.normal.xyz), max(abs(Q), abs(P)))))
            return Incident(vec3(0.0, 0.0, 1.0), vec3(0.0));
        strength *= abs(dot(light.normal.xyz, incident(Q, P, vec3(0.0)).L));
    }
    return incident(Q, P, strength);
}

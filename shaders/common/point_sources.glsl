// Light from a point light.
Incident from_point(int i, vec3 P)
{
    return incident(sources[i].at.xyz, P, sources[i].strength.rgb);
}

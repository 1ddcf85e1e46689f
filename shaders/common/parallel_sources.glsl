// Light from a parallel light: the same everywhere.
Incident from_parallel(int i, vec3 P)
{
    return Incident(sources[i].at.xyz, sources[i].strength.rgb);
}

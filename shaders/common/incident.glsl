// Light from one direction: unit L and the irradiance on a plane perpendicular to it.
struct Incident {
    vec3 L, irradiance;
};

// The visible point as effects and methods see it: position, unit shading normal, unit direction to the eye.
struct Surface {
    vec3 P, N, V;
};

// Lambert's diffuse reflection: of a polygon by its exact irradiance, the sum over its edges above the horizon and over the turns along the
// horizon that close it; src/effects/diffuse_area.c derives it. Of light from L as the effect diffuse.
//
//     (k_d / pi) | 1/2 sum of angle_i (gamma_i . N) |        (k_d / pi) max(0, N.L)
//
// params: k_d / pi.

// Without a polygon there is no polygon_vertex().
#if N_POLYGONS > 0
vec3 area_diffuse_area(Surface s, int first_vertex, int n, vec4 params[1])
{
    float sum = 0.0;
    bool crossed = false;
    vec3 first = vec3(0.0);
    vec3 vertex_b = polygon_vertex(first_vertex + n - 1);
    vec3 b = vertex_b - s.P;
    float z_b = dot(s.N, b);
    for (int i = 0; i < n; i++) {
        vec3 vertex_a = vertex_b;
        vec3 a = b;
        float z_a = z_b;
        vertex_b = polygon_vertex(first_vertex + i);
        b = vertex_b - s.P;
        z_b = dot(s.N, b);
        if (!(z_a > 0.0) && !(z_b > 0.0))
            continue;
        vec3 across = cross(dot(a, a) < dot(b, b) ? a : b, vertex_b - vertex_a);
        float size = length(across);
        float sine = size;
        float cosine = dot(a, b);
        if (!(z_a > 0.0) || !(z_b > 0.0)) {
            bool up = !(z_a > 0.0);
            float part_b = abs(z_a) / (abs(z_a) + abs(z_b));
            float part_a = abs(z_b) / (abs(z_a) + abs(z_b));
            vec3 crossing = part_a * a + part_b * b;
            if (!crossed)
                first = crossing;
            crossed = true;
            float y = dot(s.N, cross(first, crossing));
            float angle = angle_of(abs(y), dot(first, crossing));
            sum += (up ? angle : -angle) * sign(y);
            sine = (up ? part_a : part_b) * size;
            cosine = dot(crossing, up ? b : a);
        }
        if (size > 0.0)
            sum += angle_of(sine, cosine) * (dot(s.N, across) / size);
    }
    return params[0].rgb * (0.5 * abs(sum));
}
#endif

vec3 reflect_diffuse_area(Surface s, vec3 L, vec4 params[1])
{
    return params[0].rgb * max(0.0, dot(s.N, L));
}

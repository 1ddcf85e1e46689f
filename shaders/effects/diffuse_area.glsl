// Lambert's diffuse reflection: of a polygon by its exact irradiance, the sum over its edges above the horizon and over the turns along the
// horizon that close it; src/effects/diffuse_area.c derives it. Of light from L as the effect diffuse.
//
//     (k_d / pi) | 1/2 sum of angle_i (gamma_i . N) |        (k_d / pi) max(0, N.L)
//
// params: k_d / pi.

// Nothing of a polygon in whose plane P is as far as rounding lets one know (src/model/plane.h). No length has a unit: vertices and P times
// `down`, differences times `up`, powers of two.

// Without a polygon there is no polygon_vertex().
#if N_POLYGONS > 0
float largest_of(vec3 a)
{
    return max(abs(a.x), max(abs(a.y), abs(a.z)));
}

// 2^-e for x = m 2^e, as far as both are normal numbers.
float inverse_power(float x)
{
    uint exponent = clamp(floatBitsToUint(x) >> 23, 1u, 253u);
    return uintBitsToFloat((254u - exponent) << 23);
}

// Twice the area along the normal, A = sum of (v_i - v_0) x (v_(i+1) - v_0), does not depend on P; A.(v_0 - P)/|A| is the distance. P and the
// vertices are known to 2^-24 of their coordinates at best, each axis apart, which adds |A_x| X + |A_y| Y + |A_z| Z of that, and interpolation
// of P and the sums here are some operations more (POLYGON_UNITS).
bool is_in_plane(vec3 P, int first_vertex, int n, float down, float up)
{
    vec3 v_0 = down * polygon_vertex(first_vertex);
    vec3 size = max(abs(P), abs(v_0));
    vec3 area = vec3(0.0);
    vec3 b = vec3(0.0);
    for (int i = 1; i < n; i++) {
        vec3 v_i = down * polygon_vertex(first_vertex + i);
        vec3 a = b;
        b = up * (v_i - v_0);
        area += cross(a, b);
        size = max(size, abs(v_i));
    }
    // Corners off one plane.
    float off = 0.0;
    for (int i = 1; n > 3 && i < n; i++)
        off = max(off, abs(dot(area, up * (down * polygon_vertex(first_vertex + i) - v_0))));
    float volume = dot(area, up * (v_0 - P));
    return !(abs(volume) > 2.0 * off + POLYGON_UNITS * 1.1920929e-7 * dot(abs(area), up * size));
}

vec3 area_diffuse_area(Surface s, int first_vertex, int n, vec4 params[1])
{
    float most = largest_of(s.P);
    for (int i = 0; i < n; i++)
        most = max(most, largest_of(polygon_vertex(first_vertex + i)));
    float down = most > 1e36 ? 0.0009765625 : 1.0;
    vec3 P = down * s.P;
    most = 0.0;
    for (int i = 0; i < n; i++)
        most = max(most, largest_of(down * polygon_vertex(first_vertex + i) - P));
    float up = inverse_power(most);
    if (is_in_plane(P, first_vertex, n, down, up))
        return vec3(0.0);
    float sum = 0.0;
    bool crossed = false;
    vec3 first = vec3(0.0);
    vec3 vertex_b = down * polygon_vertex(first_vertex + n - 1);
    vec3 b = up * (vertex_b - P);
    float z_b = dot(s.N, b);
    for (int i = 0; i < n; i++) {
        vec3 vertex_a = vertex_b;
        vec3 a = b;
        float z_a = z_b;
        vertex_b = down * polygon_vertex(first_vertex + i);
        b = up * (vertex_b - P);
        z_b = dot(s.N, b);
        if (!(z_a > 0.0) && !(z_b > 0.0))
            continue;
        vec3 across = cross(dot(a, a) < dot(b, b) ? a : b, up * (vertex_b - vertex_a));
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

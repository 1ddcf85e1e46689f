// The ellipsoid distribution of microfacet normals (src/model/ellipsoid.h has formulas and sources) in single precision, for R_r from 1e-6
// to 1e12: with common/arctangent and common/sine_cosine, and with a logarithm of its own, since that of GLSL is off by 2e-4 near 1.
struct Ellipsoid {
    float rr, k, half_range, norm;
};

// log(1 + d/b) for d >= 0 and b > 0, accurate relative to itself: log(m) = 2 atanh(z), z = (m - 1)/(m + 1), by its series in z^2 < 0.03,
// and what is beyond by powers of 2.
float log_ratio(float d, float b)
{
    int n = 0;
    float z = d / (2.0 * b + d);
    if (!(d < 0.4 * b)) {
        float m = frexp((b + d) / b, n);
        bool low = m < 0.707106781;
        m = low ? 2.0 * m : m;
        n -= int(low);
        z = (m - 1.0) / (m + 1.0);
    }
    float zz = z * z;
    return float(n) * 0.693147181 +
           2.0 * z * (1.0 + zz * (1.0 / 3.0 + zz * (0.2 + zz * (1.0 / 7.0 + zz / 9.0))));
}

// For x >= 0; the difference of exponentials loses digits near 0.
float sinh_of(float x)
{
    float z = x * x;
    return x < 1.0 ? x * (1.0 + z / 6.0 * (1.0 + z / 20.0 * (1.0 + z / 42.0 * (1.0 + z / 72.0))))
                   : 0.5 * (exp(x) - exp(-x));
}

Ellipsoid ellipsoid_make(float rr)
{
    float k = sqrt(abs(rr - 1.0) * (rr + 1.0));
    float half_range = rr >= 1.0 ? angle_of(k, 1.0) : log_ratio(k + (1.0 - rr), rr);
    return Ellipsoid(rr, k, half_range, k > 0.0 ? 0.5 * k / half_range : 0.5);
}

// D in 1/radian.
float ellipsoid_pdf(Ellipsoid e, float delta)
{
    vec2 sc = sine_cosine(abs(delta));
    float rs = e.rr * sc.x;
    return e.norm * sc.y / (sc.y * sc.y + rs * rs);
}

// U. The lower tail for s = |sin delta| from t = 1 - s as one arctangent, or for R < 1 one logarithm, of terms that do not cancel.
float ellipsoid_cdf(Ellipsoid e, float delta)
{
    vec2 sc = sine_cosine(abs(delta));
    float s = sc.x;
    float t = s > 0.5 ? sc.y * sc.y / (1.0 + s) : 1.0 - s;
    float lower = 0.5 * t;
    if (e.k > 0.0) {
        float kt = e.k * t;
        float r2 = e.rr * e.rr;
        lower = e.rr >= 1.0 ? angle_of(kt, 1.0 + e.k * e.k * s)
                            : 0.5 * log_ratio(2.0 * kt, t * r2 / (1.0 + e.k) + r2 * s);
        lower /= 2.0 * e.half_range;
    }
    return delta <= 0.0 ? lower : 1.0 - lower;
}

// delta(U), its sine and its cosine. sin|delta| and t = 1 - sin|delta| are quotients of terms that do not cancel, too.
vec3 ellipsoid_inverse(Ellipsoid e, float u)
{
    float tail = u <= 0.5 ? u : 1.0 - u;
    float s = 1.0 - 2.0 * tail;
    float t = 2.0 * tail;
    if (e.k > 0.0) {
        float x = t * e.half_range;
        float y = s * e.half_range;
        if (e.rr >= 1.0) {
            vec2 sc = sine_cosine(x);
            float d = sc.y + e.k * sc.x;
            s = e.rr / e.k * sine_cosine(y).x / d;
            t = e.rr / e.k * e.rr * sc.x / d;
        } else {
            float kd = e.k * 0.5 * (exp(y) + exp(-y));
            s = sinh_of(y) / kd;
            t = e.rr * sinh_of(x) / kd;
        }
    }
    // The smaller one is the more accurate one.
    if (s > 0.5)
        s = 1.0 - t;
    else
        t = 1.0 - s;
    float c = sqrt(t * (2.0 - t));
    float side = u <= 0.5 ? -1.0 : 1.0;
    return vec3(side * angle_of(s, c), side * s, c);
}

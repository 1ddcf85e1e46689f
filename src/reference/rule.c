/* The two rules and their null rules (see rule.h). */
#include "reference/rule.h"

#include <float.h>
#include <math.h>

enum { MIDDLE = 7, NULL_PAIRS = 4, GAUSS_MIDDLE = 3, GAUSS_NULL_PAIRS = 3 };

/* Piessens, de Doncker-Kapenga, Ueberhuber, Kahaner: QUADPACK, 1983; the rule qk15, from the outermost node to the middle. */
static const double kronrod_node[8] = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0,
};
static const double kronrod_weight[8] = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714,
};

/* Null rules of degree 14, 12, 10, 8 (even) and 13, 11, 9, 7 (odd), from the outermost node to the middle: the orthonormal polynomials
 * over the 15 nodes (Gram and Schmidt in 50 digits), times the Euclidean norm of the Kronrod weights. */
static const double null_even[NULL_PAIRS][8] = {
    {-0.022921293882222405391, 0.066352265094491081611, -0.10472591670676056408, 0.13896708212217125743,
     -0.16890135682441785564, 0.19136235620336585794, -0.20430790099748694431, 0.20834952998171914488},
    {0.067132837062170095284, -0.17254975407726191136, 0.20840003161659606351, -0.16653623728409470963,
     0.063145614671620019004, 0.065151797839773327117, -0.16876710172729177239, 0.20804562379697777692},
    {-0.10610009412269442846, 0.20855155652268429243, -0.099905442339939553168, -0.10745147396662823566,
     0.20918208490874293015, -0.10357595100585132872, -0.10540794433498839117, 0.20941452867734942921},
    {0.14030393835055670163, -0.16583886444777615341, -0.10874127277449190865, 0.19085175156020395196,
     0.06538322838961139823, -0.20411763274824965509, -0.022526143721035249558, 0.20936999078236182977},
};
static const double null_odd[NULL_PAIRS][7] = {
    {0.045457727476372893644, -0.12596989532086184317, 0.18117473072698014272, -0.20612790079906645865,
     0.19801168644292635645, -0.15535037034108617433, 0.084917007668000177528},
    {-0.087306671611838672272, 0.20072473902459962439, -0.1784615549820842736, 0.040449284608312648655,
     0.12383569754427723243, -0.20773626832743164628, 0.15464117698529397442},
    {0.12381782206078168019, -0.19651964610324636674, -0.0051025907419582938496, 0.20042115023642774796,
     -0.12221009455111120425, -0.12346083748881843158, 0.19868994417995846578},
    {-0.15532637586822672881, 0.11935059182320092405, 0.18360028584237012475, -0.083594514806695313825,
     -0.19906517391328859947, 0.042789295208730139082, 0.20802705558412291456},
};

/* Every second node is the Gauss rule's: from the outermost to the middle. */
static const double gauss_weight[4] = {
    0.129484966168869693270611432679082,
    0.279705391489276667901467771423780,
    0.381830050505118944950369775488975,
    0.417959183673469387755102040816327,
};

/* Its null rules of degree 6, 4, 2 and 5, 3, 1. */
static const double gauss_null_even[GAUSS_NULL_PAIRS][4] = {
    {0.079511208774680791798, -0.24894059811617075588, 0.39621346033176379478, -0.4535681419805476614},
    {0.2606154104267233795, -0.40735645409018974935, -0.065396029942389627883, 0.42427414721171199546},
    {0.4001795983478458349, 0.080470077216154465061, -0.27041521504206727398, -0.42046892104386605197},
};
static const double gauss_null_odd[GAUSS_NULL_PAIRS][3] = {
    {-0.16874423793762684676, 0.41277192536720149896, -0.35956266402487343047},
    {-0.34158614472384833972, 0.21462195061649206924, 0.40669019365535625649},
    {-0.42776731696648905066, -0.3342115280946880697, -0.18291628301784894292},
};

double rl_rule_node(int i)
{
    return i <= MIDDLE ? -kronrod_node[i] : kronrod_node[2 * MIDDLE - i];
}

double rl_rule_weight(int i)
{
    return kronrod_weight[i <= MIDDLE ? i : 2 * MIDDLE - i];
}

/* part[j]: size of the parts of two degrees, the highest first. *fall: by how much they shrink from one to the next, at least. */
static double largest(const double part[], int n, double *fall)
{
    double most = part[0];
    *fall = 0.0;
    for (int j = 0; j + 1 < n; j++) {
        *fall = fmax(*fall, part[j] / fmax(part[j + 1], DBL_MIN));
        most = fmax(most, part[j + 1]);
    }
    return most;
}

double rl_rule_gauss(const double gauss[RL_RULE_GAUSS], double *error)
{
    double middle = gauss[GAUSS_MIDDLE], sum = gauss_weight[GAUSS_MIDDLE] * middle, size = fabs(sum);
    double even[GAUSS_MIDDLE], odd[GAUSS_MIDDLE], part[GAUSS_NULL_PAIRS], fall;
    for (int i = 0; i < GAUSS_MIDDLE; i++) {
        double a = gauss[i], b = gauss[2 * GAUSS_MIDDLE - i];
        even[i] = a + b;
        odd[i] = a - b;
        sum += gauss_weight[i] * even[i];
        size += gauss_weight[i] * (fabs(a) + fabs(b));
    }
    for (int j = 0; j < GAUSS_NULL_PAIRS; j++) {
        double a = gauss_null_even[j][GAUSS_MIDDLE] * middle, b = 0.0;
        for (int i = 0; i < GAUSS_MIDDLE; i++) {
            a += gauss_null_even[j][i] * even[i];
            b += gauss_null_odd[j][i] * odd[i];
        }
        part[j] = sqrt(a * a + b * b);
    }
    double most = largest(part, GAUSS_NULL_PAIRS, &fall);
    /* Degree 6 may be small by chance, so degrees 4 and 3 stand for it. From them to 14, the first that the rule gets wrong, it would be
     * fall^5, but two ratios say little of how it goes on: with fall^3 the error of lights of many edges was missed up to twice in a
     * thousand, with fall^2 never (measured as below). */
    *error = fmax(fmin(100.0 * part[1] * fall * fall, 10.0 * most), 4e-16 * size);
    return sum;
}

double rl_rule_kronrod(const double gauss[RL_RULE_GAUSS], const double rest[RL_RULE_BATCH], double *error)
{
    double even[8], odd[MIDDLE], sum = kronrod_weight[MIDDLE] * gauss[GAUSS_MIDDLE], size = fabs(sum);
    even[MIDDLE] = gauss[GAUSS_MIDDLE];
    for (int i = 0; i < MIDDLE; i++) {
        double a = i % 2 ? gauss[i / 2] : rest[i / 2];
        double b = i % 2 ? gauss[RL_RULE_GAUSS - 1 - i / 2] : rest[RL_RULE_BATCH - 1 - i / 2];
        even[i] = a + b;
        odd[i] = a - b;
        sum += kronrod_weight[i] * even[i];
        size += kronrod_weight[i] * (fabs(a) + fabs(b));
    }
    double part[NULL_PAIRS], fall;
    for (int j = 0; j < NULL_PAIRS; j++) {
        double a = null_even[j][MIDDLE] * even[MIDDLE], b = 0.0;
        for (int i = 0; i < MIDDLE; i++) {
            a += null_even[j][i] * even[i];
            b += null_odd[j][i] * odd[i];
        }
        part[j] = sqrt(a * a + b * b);
    }
    double most = largest(part, NULL_PAIRS, &fall);
    /* Two degrees shrink a part by `fall`; from degree 14 to 24, the first that the rule gets wrong, that would be fall^5. Over 30,000
     * random lights and points at ten tolerances from 1e-3 to 1e-12 the stated error missed the truth twice with a factor of 10, once
     * with 100, and never with this. */
    *error = fmax(fmin(300.0 * part[0] * fall * fall * fall, 10.0 * most), 4e-16 * size);
    return sum;
}

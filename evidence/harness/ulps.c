/* ulps.c - by how many units in the last place the elementary functions err at most, each on its ranges.
 * Arguments: how many random points; how far apart the floats are that the sine and cosine are swept at, 0 for none. */
#include <float.h>
#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boresight_math.h"

#ifdef BORESIGHT_FLOAT
#define DIGITS FLT_MANT_DIG
#define LEAST FLT_MIN_EXP
#define MOST FLT_MAX
#define TINY 1e-44
#define WIDEST 80.0 /* natural logarithm of what atan2 is given */
#define POWER 89.4
#else
#define DIGITS DBL_MANT_DIG
#define LEAST DBL_MIN_EXP
#define MOST DBL_MAX
#define TINY 5e-324
#define WIDEST 690.0
#define POWER 710.4
#endif
#define LARGE (DIGITS == FLT_MANT_DIG ? 3e38 : 1e60) /* where quadruple precision still knows an angle */

static uint64_t state = 88172645463325252ULL;

static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

/* Infinite where one alone is a number, or is of the other sign or beyond the largest. */
static double ulps(bs_real got, __float128 wanted)
{
    int exponent = LEAST;
    if (isnan(got) || isnanq(wanted)) {
        return (isnan(got) && isnanq(wanted)) ? 0.0 : INFINITY;
    }
    if (isinf(got)) {
        return ((fabsq(wanted) > (__float128)MOST) && ((got > 0) == (wanted > 0))) ? 0.0 : INFINITY;
    }
    if (wanted != 0) {
        (void)frexpq(wanted, &exponent);
    }
    return (double)(fabsq((__float128)got - wanted) * ldexpq(1, DIGITS - (exponent < LEAST ? LEAST : exponent)));
}

typedef struct {
    const char *name;
    bs_real (*ours)(bs_real);
    __float128 (*exact)(__float128);
    double low, high;
    int widely; /* even in the logarithm */
} range;

static const range RANGES[] = {
    {"sin", bs_sin, sinq, -6.2831855, 6.2831855, 0},
    {"cos", bs_cos, cosq, -6.2831855, 6.2831855, 0},
    {"sin turned", bs_sin, sinq, 1e-3, (double)BS_MATH_ANGLE, 1},
    {"cos turned", bs_cos, cosq, 1e-3, (double)BS_MATH_ANGLE, 1},
    {"sin large", bs_sin, sinq, (double)BS_MATH_ANGLE, LARGE, 1},
    {"cos large", bs_cos, cosq, (double)BS_MATH_ANGLE, LARGE, 1},
    {"atan", bs_atan, atanq, -4, 4, 0},
    {"atan wide", bs_atan, atanq, 1e-30, 1e30, 1},
    {"asin", bs_asin, asinq, -1, 1, 0},
    {"asin small", bs_asin, asinq, 1e-30, 1, 1},
    {"acos", bs_acos, acosq, -1, 1, 0},
    {"exp", bs_exp, expq, -1, 1, 0},
    {"exp wide", bs_exp, expq, (double)BS_MATH_EXP_LOW, (double)BS_MATH_EXP_HIGH, 0},
    {"log", bs_log, logq, 0.5, 2, 0},
    {"log wide", bs_log, logq, TINY, MOST, 1},
    {"sinh", bs_sinh, sinhq, -3, 3, 0},
    {"sinh wide", bs_sinh, sinhq, 1e-30, POWER, 1},
    {"cosh", bs_cosh, coshq, -3, 3, 0},
    {"cosh wide", bs_cosh, coshq, 1e-30, POWER, 1},
    {"tanh", bs_tanh, tanhq, -3, 3, 0},
    {"tanh wide", bs_tanh, tanhq, 1e-30, 30, 1},
};

static double spread(double low, double high)
{
    return exp(log(low) + (uniform() * (log(high) - log(low))));
}

static void of_one(const range *r, long count)
{
    double worst = 0;
    double at = 0;
    for (long k = 0; k < count; ++k) {
        bs_real x = (bs_real)(r->widely ? spread(r->low, r->high) : r->low + (uniform() * (r->high - r->low)));
        if ((r->low < 0) && (k % 4 == 0)) {
            x = (bs_real)((double)x * exp(-30 * uniform())); /* some near zero */
        }
        const double off = ulps(r->ours(x), r->exact((__float128)x));
        if (!(off <= worst)) {
            worst = off;
            at = (double)x;
        }
    }
    (void)printf("%s,%.4f,%a\n", r->name, worst, at);
}

static void of_atan2(const char *name, int widely, long count)
{
    double worst = 0;
    double at[2] = {0, 0};
    for (long k = 0; k < count; ++k) {
        bs_real y = (bs_real)(widely ? exp(WIDEST * ((2 * uniform()) - 1)) : (2 * uniform()) - 1);
        bs_real x = (bs_real)(widely ? exp(WIDEST * ((2 * uniform()) - 1)) : (2 * uniform()) - 1);
        if (widely && (k & 1)) {
            x = (bs_real)((double)y * exp((4 * uniform()) - 2));
        }
        x = (k & 2) ? -x : x;
        y = (k & 4) ? -y : y;
        const double off = ulps(bs_atan2(y, x), atan2q((__float128)y, (__float128)x));
        if (!(off <= worst)) {
            worst = off;
            at[0] = (double)y;
            at[1] = (double)x;
        }
    }
    (void)printf("%s,%.4f,%a %a\n", name, worst, at[0], at[1]);
}

#ifdef BORESIGHT_FLOAT
/* Every so many floats from 0 to 2 pi, against double; the sine is odd and the cosine even to the bit. */
static void sweep(uint32_t apart)
{
    const char *const names[2] = {"sin swept", "cos swept"};
    const double turn = 0x1.921fb6p+2;
    double worst[2] = {0, 0};
    float at[2] = {0, 0};
    for (uint32_t bits = 0;; bits += apart) {
        float x;
        float value[2];
        (void)memcpy(&x, &bits, sizeof x);
        if ((double)x > turn) {
            break;
        }
        bs_sincos(x, &value[0], &value[1]);
        const double wanted[2] = {sin((double)x), cos((double)x)};
        for (int i = 0; i < 2; ++i) {
            uint64_t word;
            (void)memcpy(&word, &wanted[i], sizeof word);
            const int exponent = (int)((word >> 52) & 0x7FF) - 1022;
            const uint64_t power = (uint64_t)(1023 + 24 - (exponent < -125 ? -125 : exponent)) << 52;
            double scale;
            (void)memcpy(&scale, &power, sizeof scale);
            const double off = fabs((double)value[i] - wanted[i]) * scale;
            if (!(off <= worst[i]) || !(value[i] >= -1.0F && value[i] <= 1.0F)) {
                worst[i] = (value[i] >= -1.0F && value[i] <= 1.0F) ? off : INFINITY;
                at[i] = x;
            }
        }
    }
    for (int i = 0; i < 2; ++i) {
        (void)printf("%s,%.4f,%a\n", names[i], worst[i], (double)at[i]);
    }
}
#endif

int main(int argc, char **argv)
{
    const long count = (argc > 1) ? atol(argv[1]) : 100000;
    for (size_t i = 0; i < sizeof RANGES / sizeof RANGES[0]; ++i) {
        of_one(&RANGES[i], count);
    }
    of_atan2("atan2", 0, count);
    of_atan2("atan2 wide", 1, count);
#ifdef BORESIGHT_FLOAT
    if ((argc > 2) && (atol(argv[2]) > 0)) {
        sweep((uint32_t)atol(argv[2]));
    }
#endif
    return 0;
}

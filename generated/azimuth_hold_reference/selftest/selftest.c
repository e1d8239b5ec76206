/* selftest.c - runs every golden vector of azimuth-hold-reference through the functions.  Generated
 * by Boresight: do not edit.
 * Exit status 0 if all pass. */
#include "selftest.h"

#include <stdio.h>

static const double PAINT = -1.2345678e30;

double selftest_nan(void)
{
    volatile double zero = 0.0;
    return zero / zero;
}

double selftest_infinity(void)
{
    volatile double zero = 0.0;
    return 1.0 / zero;
}

void selftest_paint(bs_real *out, int n)
{
    for (int i = 0; i < n; ++i) {
        out[i] = (bs_real)PAINT;
    }
}

int selftest_painted(const char *what, const bs_real *out, int n)
{
    for (int i = 0; i < n; ++i) {
        if (!((out[i] <= (bs_real)PAINT) && (out[i] >= (bs_real)PAINT))) {
            (void)printf("%s: written although the input was refused\n", what);
            return 1;
        }
    }
    return 0;
}

int selftest_compare(const char *what,
                     int vector,
                     const bs_real *out,
                     int n,
                     const double *expected,
                     const double *tolerance,
                     const unsigned short *at,
                     int nnz,
                     unsigned int angles)
{
    const double turn = 6.283185307179586;
    int failures = 0;
    int k = 0;
    for (int i = 0; i < n; ++i) {
        const int printed = (k < nnz) && (at[k] == i);
        double difference = (double)out[i] - (printed ? expected[k] : 0.0);
        const double allowed = printed ? tolerance[k] : 0.0;
        const int angle = (i < 32) && (((angles >> (unsigned int)i) & 1U) != 0U);
        if (angle && (difference > 3.0)) {
            difference -= turn;
        }
        if (angle && (difference < -3.0)) {
            difference += turn;
        }
        if (!((difference <= allowed) && (-difference <= allowed))) {
            (void)printf("%s: vector %d, element %d is off by %.3e, allowed %.3e\n", what, vector,
                         i, difference, allowed);
            ++failures;
        }
        k += printed;
    }
    return failures;
}

int main(void)
{
    int passed = 0;
    int failed = 0;
    (void)printf("%s\n", ahr_identity());
    if (test_ahr_F() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_F\n");
        ++failed;
    }
    if (test_ahr_Phi() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_Phi\n");
        ++failed;
    }
    if (test_ahr_Qc() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_Qc\n");
        ++failed;
    }
    if (test_ahr_Q() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_Q\n");
        ++failed;
    }
    if (test_ahr_zupt_z() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_zupt_z\n");
        ++failed;
    }
    if (test_ahr_zupt_H() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_zupt_H\n");
        ++failed;
    }
    if (test_ahr_zaru_z() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_zaru_z\n");
        ++failed;
    }
    if (test_ahr_zaru_H() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_zaru_H\n");
        ++failed;
    }
    if (test_ahr_azimuth_z() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_azimuth_z\n");
        ++failed;
    }
    if (test_ahr_azimuth_H() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_azimuth_H\n");
        ++failed;
    }
    if (test_ahr_strapdown() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_strapdown\n");
        ++failed;
    }
    if (test_ahr_feedback() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_feedback\n");
        ++failed;
    }
    if (test_ahr_math() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_math\n");
        ++failed;
    }
    if (test_ahr_covariance() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_covariance\n");
        ++failed;
    }
    if (test_ahr_filter() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_filter\n");
        ++failed;
    }
    if (test_ahr_digest() == 0) {
        ++passed;
    } else {
        (void)printf("FAILED ahr_digest\n");
        ++failed;
    }
    (void)printf("%d passed, %d failed\n", passed, failed);
    return (failed == 0) ? 0 : 1;
}

/* selftest.c - runs every golden vector of azimuth-hold-reference through the functions.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty.
 * Exit status 0 if all pass. */
#include "selftest.h"

#include <stdarg.h>
#include <stdio.h>

static const double PAINT = -1.2345678e30;

static void print_text(const char *text)
{
    for (int i = 0; text[i] != '\0'; ++i) {
        (void)putchar(text[i]);
    }
}

/* With so many digits at least. */
static void print_whole(int value, int least)
{
    char digits[12];
    int n = 0;
    int left = value;
    if (left < 0) {
        (void)putchar('-');
    }
    do {
        const int digit = left % 10;
        digits[n] = (char)('0' + ((digit < 0) ? -digit : digit));
        left /= 10;
        ++n;
    } while ((left != 0) || (n < least));
    while (n > 0) {
        --n;
        (void)putchar(digits[n]);
    }
}

static void print_number(double value)
{
    double left = (value < 0.0) ? -value : value;
    int exponent = 0;
    if (!((value - value) <= 0.0)) {
        print_text((left > 0.0) ? "inf" : "nan");
        return;
    }
    if (value < 0.0) {
        (void)putchar('-');
    }
    while (left >= 9.9995) {
        left /= 10.0;
        ++exponent;
    }
    while ((left > 0.0) && (left < 0.99995)) {
        left *= 10.0;
        --exponent;
    }
    left += 0.0005;
    for (int i = 0; i < 4; ++i) {
        const int digit = (int)left;
        (void)putchar('0' + digit);
        if (i == 0) {
            (void)putchar('.');
        }
        left = (left - (double)digit) * 10.0;
    }
    print_text((exponent < 0) ? "e-" : "e+");
    print_whole((exponent < 0) ? -exponent : exponent, 2);
}

void selftest_print(const char *format, ...)
{
    va_list given;
    va_start(given, format);
    for (int i = 0; format[i] != '\0'; ++i) {
        if (format[i] != '%') {
            (void)putchar(format[i]);
        } else {
            ++i;
            if (format[i] == 's') {
                print_text(va_arg(given, const char *));
            } else if (format[i] == 'd') {
                print_whole(va_arg(given, int), 1);
            } else {
                print_number(va_arg(given, double));
            }
        }
    }
    va_end(given);
}

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
            selftest_print("%s: written although the input was refused\n", what);
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
                     const float *tolerance,
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
        const double allowed = printed ? (double)tolerance[k] : 0.0;
        const int angle = (i < 32) && (((angles >> (unsigned int)i) & 1U) != 0U);
        if (angle && (difference > 3.0)) {
            difference -= turn;
        }
        if (angle && (difference < -3.0)) {
            difference += turn;
        }
        if (!((difference <= allowed) && (-difference <= allowed))) {
            selftest_print("%s: vector %d, element %d is off by %e, allowed %e\n", what, vector, i,
                           difference, allowed);
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
    selftest_print("%s\n", ahr_identity());
    if (test_ahr_F() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_F\n");
        ++failed;
    }
    if (test_ahr_Phi() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_Phi\n");
        ++failed;
    }
    if (test_ahr_Qc() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_Qc\n");
        ++failed;
    }
    if (test_ahr_Q() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_Q\n");
        ++failed;
    }
    if (test_ahr_zupt_z() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_zupt_z\n");
        ++failed;
    }
    if (test_ahr_zupt_H() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_zupt_H\n");
        ++failed;
    }
    if (test_ahr_zaru_z() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_zaru_z\n");
        ++failed;
    }
    if (test_ahr_zaru_H() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_zaru_H\n");
        ++failed;
    }
    if (test_ahr_azimuth_z() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_azimuth_z\n");
        ++failed;
    }
    if (test_ahr_azimuth_H() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_azimuth_H\n");
        ++failed;
    }
    if (test_ahr_strapdown() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_strapdown\n");
        ++failed;
    }
    if (test_ahr_feedback() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_feedback\n");
        ++failed;
    }
    if (test_ahr_math() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_math\n");
        ++failed;
    }
    if (test_ahr_covariance() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_covariance\n");
        ++failed;
    }
    if (test_ahr_filter() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_filter\n");
        ++failed;
    }
    if (test_ahr_digest() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_digest\n");
        ++failed;
    }
    if (test_ahr_live() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_live\n");
        ++failed;
    }
    if (test_ahr_probe() == 0) {
        ++passed;
    } else {
        selftest_print("FAILED ahr_probe\n");
        ++failed;
    }
    selftest_cycles();
    selftest_print("%d passed, %d failed\n", passed, failed);
    return (failed == 0) ? 0 : 1;
}

/* report.c - what the flight prints. */
#include <math.h>
#include <stdio.h>

#include "board.h"

#define DEGREES 57.295779513082321 /* in a radian */
#define MILS 1018.5916357881302

static const char *const kinds[VA_N_MEASUREMENTS] = {
    [VA_MEASUREMENT_VELOCITY] = "velocity", [VA_MEASUREMENT_DCM] = "attitude"
};
static const char *const fates[BS_MSG_FATES] = {
    [BS_MSG_IN_PART] = "taken in part", [BS_MSG_GATED] = "beyond the gate", [BS_MSG_OLD] = "too old",
    [BS_MSG_LATE] = "too late", [BS_MSG_TWICE] = "come before", [BS_MSG_AHEAD] = "ahead",
    [BS_MSG_REFUSED] = "refused", [BS_MSG_FULL] = "without room", [BS_MSG_NOT_READY] = "too early"
};
static const char *const events[] = {
    "", "begun", "", "gap, us", "clock stepped, us", "sample repeated", "bad sample, status", "held, status",
    "saturated", "lost", "astray", "correction late, samples", "correction refused", "overrun, samples"
};

static void print_line(int64_t at)
{
    bs_real sigma[VA_N_STATES];
    va_output out;

    if ((va_live_output(&aboard, at, &out) == BS_OK) && (va_live_sigmas(&aboard, sigma, NULL) == BS_OK)) {
        const bs_real *const q = out.carried.nav.q_b2n_wxyz;
        const bs_real *const mu = &out.carried.nav.q_b2m_wxyz[1]; /* half of the rotation vector, as small as it is */
        const double w = (double)q[0], x = (double)q[1], y = (double)q[2], z = (double)q[3];
        const double yaw = DEGREES * atan2(2.0 * ((w * z) + (x * y)), 1.0 - (2.0 * ((y * y) + (z * z))));
        (void)printf("%4d %12.7f %10.6f %10.6f %10.6f %10.6f %9.5f %9.5f\n", (int)(at / 1000000),
                     (yaw < 0.0) ? (yaw + 360.0) : yaw, MILS * (double)sigma[VA_IX_PHI_D],
                     2.0 * DEGREES * (double)mu[0], 2.0 * DEGREES * (double)mu[1], 2.0 * DEGREES * (double)mu[2],
                     1e3 * (double)out.carried.nav.tau, 1e3 * (double)sigma[VA_IX_D_TAU]);
    }
}

void report(const flight_record *record)
{
    const int64_t at = (int64_t)record->at;
    bs_event event;

    if ((record->kind > 0.0) || ((at % 1000000) != 0)) {
        return;
    }
    board_wait();
    while (va_live_background(&aboard) == BS_OK) {
    }
    if (at == 1000000) {
        (void)printf("   s  heading deg  sigma mil   misalignment deg                 delay ms  sigma ms\n");
    }
    print_line(at);
    while (va_live_next_event(&aboard, &event) == BS_OK) {
        if (event.code == BS_EVENT_MESSAGE) {
            (void)printf("     a message's %s: %s\n", kinds[event.which], fates[event.value]);
        } else {
            (void)printf("     %s: %ld\n", events[event.code], (long)event.value);
        }
    }
}

void report_end(void)
{
    unsigned char digest[BS_DIGEST_SIZE];
    va_live_counts n;

    (void)va_live_counted(&aboard, &n);
    (void)va_live_digest(&aboard, digest);
    (void)printf("%lu samples, %lu bad, %lu missing; of velocity and attitude %lu taken, %lu in part, %lu refused; "
                 "%lu corrections, %lu late\n", (unsigned long)n.samples, (unsigned long)n.bad, (unsigned long)n.missing,
                 (unsigned long)n.fate[BS_MSG_TAKEN], (unsigned long)n.fate[BS_MSG_IN_PART],
                 (unsigned long)n.fate[BS_MSG_REFUSED], (unsigned long)n.corrections, (unsigned long)n.corrections_late);
    for (unsigned int i = 0U; i < BS_DIGEST_SIZE; ++i) {
        (void)printf("%02x", (unsigned int)digest[i]);
    }
    (void)printf("\n");
}

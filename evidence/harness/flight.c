/* flight.c - one flight of the filter of azimuth hold, the same on every machine: its inputs come from integers, by
 * operations that IEEE 754 fixes, and what the filter holds after each hundredth sample goes into a digest.
 * A body at rest, which now and then turns about its vertical axis and back.  Messages that it is at rest, with its
 * rate, and of its azimuth are skipped at random or arrive late.  -DFLIGHT_MAIN prints what was flown. */
#include "azimuth_hold_digest.h"

#define EVERY 10000                           /* samples from digest to digest */
#define DIGESTS (FLIGHT_SAMPLES / EVERY)
#define STEP 100                              /* samples from propagate to propagate */
#define RATE 128                              /* Hz: a step of time is a power of two */
#define DT (BS_REAL(1.0) / (bs_real)RATE)

unsigned char flight_digests[DIGESTS][BS_DIGEST_SIZE];
int flight_counts[5];        /* samples, messages taken, rows of them, calls that were refused, their last status */
int flight_flush[2];         /* whether a result below the normal numbers is flushed to zero, and whether an input is */
unsigned int flight_control; /* the floating-point unit's control register, where there is one */
int flight(void);

/* A message on its way. */
typedef struct {
    int arrives; /* at this sample; -1: none is on its way */
    ah_corrected_imu imu;
    ah_reference reference;
} message;

static ah_filter filter;
static uint32_t state;

static uint32_t drawn(void)
{
    state = (state * 1664525U) + 1013904223U;
    return state >> 8U;
}

/* A multiple of 2^-16 in [-1, 1). */
static bs_real noise(void)
{
    return (bs_real)((int)(drawn() % 131072U) - 65536) * BS_REAL(1.52587890625e-05);
}

/* The least normal number halved, and the largest subnormal doubled, read back by what they are. */
static void read_flushing(void)
{
#ifdef BORESIGHT_FLOAT
    volatile bs_real least = 1.17549435e-38F;
    volatile bs_real below = 5.87747175e-39F;
#else
    volatile bs_real least = 2.2250738585072014e-308;
    volatile bs_real below = 1.1125369292536007e-308;
#endif
    const bs_real half = least * BS_REAL(0.5);
    const bs_real twice = below * BS_REAL(16777216.0);
    unsigned char bytes = 0U;
    for (size_t i = 0U; i < sizeof(half); ++i) {
        bytes = (unsigned char)(bytes | ((const unsigned char *)&half)[i]);
    }
    flight_flush[0] = (bytes == 0U) ? 1 : 0;
    flight_flush[1] = (twice > BS_REAL(0.0)) ? 0 : 1;
#if defined(__SSE2__)
    flight_control = __builtin_ia32_stmxcsr() & 0xFFC0U; /* without the flags of what has happened */
#elif defined(__aarch64__)
    flight_control = __builtin_aarch64_get_fpcr();
#elif defined(__arm__)
    flight_control = __builtin_arm_get_fpscr() & 0x07F79F00U;
#endif
}

static void judge(bs_status status)
{
    if (status != BS_OK) {
        ++flight_counts[3];
        flight_counts[4] = (int)status;
    }
}

static void begin(void)
{
    static const bs_real sigma[AH_N_STATES] = {
        BS_REAL(1e-6), BS_REAL(1e-6), BS_REAL(5.0),  BS_REAL(0.1),  BS_REAL(0.1),  BS_REAL(0.1),  BS_REAL(0.01),
        BS_REAL(0.01), BS_REAL(0.02), BS_REAL(1e-5), BS_REAL(1e-5), BS_REAL(1e-5), BS_REAL(0.01), BS_REAL(0.01),
        BS_REAL(0.01),
    };
    static bs_real P[AH_N_STATES * AH_N_STATES];
    static const ah_nav nav = {
        { BS_REAL(0.5), BS_REAL(0.75), BS_REAL(100.0) },
        { BS_REAL(0.05), BS_REAL(-0.03), BS_REAL(0.01) },
        { BS_REAL(1.0), BS_REAL(0.001), BS_REAL(-0.002), BS_REAL(0.005) },
        { BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0) },
        { BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0) },
    };
    for (int i = 0; i < AH_N_STATES; ++i) {
        P[i * (AH_N_STATES + 1)] = sigma[i] * sigma[i];
    }
    judge(ah_filter_init(&filter, &nav, P));
}

/* What the sensors deliver over one sample.  turning: rate about the vertical axis in rad/s. */
static void sense(ah_increments *increments, bs_real turning)
{
    /* rate of the Earth and gravity where the flight begins, and what the sensors are off */
    static const bs_real rate[3] = { BS_REAL(1.0e-5), BS_REAL(4.5e-5), BS_REAL(5.5e-5) };
    static const bs_real force[3] = { BS_REAL(0.002), BS_REAL(-0.003), BS_REAL(9.805) };
    for (int i = 0; i < 3; ++i) {
        increments->dtheta_before[i] = increments->dtheta_ib_b[i];
        increments->dv_before[i] = increments->dv_b[i];
        increments->dtheta_ib_b[i] = (rate[i] + (BS_REAL(0.001953125) * noise())) * DT;
        increments->dv_b[i] = (force[i] + (BS_REAL(0.0625) * noise())) * DT;
    }
    increments->dtheta_ib_b[2] += turning * DT;
}

/* The same as rates, the estimated biases removed. */
static void rates(ah_corrected_imu *imu, const ah_increments *increments, bs_real dt)
{
    for (int i = 0; i < 3; ++i) {
        imu->f_b[i] = (increments->dv_b[i] * (bs_real)RATE) - filter.nav.accel_bias[i];
        imu->omega_ib_b[i] = (increments->dtheta_ib_b[i] * (bs_real)RATE) - filter.nav.gyro_bias[i];
    }
    imu->dt = dt;
}

/* Of each message one in eight is skipped, and the others arrive up to 63 samples late. */
static void send(message *sent, int k, const ah_corrected_imu *imu)
{
    const uint32_t luck = drawn();
    const uint32_t late = drawn() % 64U;
    const bs_real off = BS_REAL(0.00390625) * noise();
    if ((luck % 8U) != 0U) {
        sent->arrives = k + (int)late;
        sent->imu = *imu;
        sent->reference.q_ref_wxyz[0] = BS_REAL(1.0);
        sent->reference.q_ref_wxyz[1] = BS_REAL(0.0);
        sent->reference.q_ref_wxyz[2] = BS_REAL(0.0);
        sent->reference.q_ref_wxyz[3] = off;
    }
}

static void taken(bs_status status, const ah_innovation *innovation)
{
    judge(status);
    if (status == BS_OK) {
        ++flight_counts[1];
        for (unsigned int used = innovation->used; used != 0U; used /= 2U) {
            flight_counts[2] += (int)(used % 2U);
        }
        judge(ah_filter_correct(&filter));
    }
}

int flight(void)
{
    static const ah_noise noises = {
        { BS_REAL(0.0001), BS_REAL(0.0001), BS_REAL(0.0001) },
        { BS_REAL(0.005), BS_REAL(0.005), BS_REAL(0.005) },
        { BS_REAL(1e-7), BS_REAL(1e-7), BS_REAL(1e-7) },
        { BS_REAL(1e-5), BS_REAL(1e-5), BS_REAL(1e-5) },
    };
    static const bs_gates gates = { BS_ALL_ROWS, BS_REAL(5.0), BS_REAL(0.0), 1, 0U };
    static const bs_real R_zupt[3] = { BS_REAL(0.0004), BS_REAL(0.0004), BS_REAL(0.0004) };
    static const bs_real R_zaru[3] = { BS_REAL(4e-6), BS_REAL(4e-6), BS_REAL(4e-6) };
    static const bs_real R_azimuth[1] = { BS_REAL(1e-4) };
    static ah_increments increments;
    static message still;
    static message azimuth;
    static bs_digest digest;
    ah_innovation innovation;
    ah_corrected_imu imu;
    state = 20261123U;
    for (int i = 0; i < 5; ++i) {
        flight_counts[i] = 0;
    }
    still.arrives = -1;
    azimuth.arrives = -1;
    read_flushing();
    begin();
    (void)bs_digest_begin(&digest);
    sense(&increments, BS_REAL(0.0));
    for (int k = 1; k <= FLIGHT_SAMPLES; ++k) {
        const int phase = k % 16384; /* two minutes, in the last quarter of which it turns and turns back */
        const int quarter = phase % 4096;
        const int turns = (phase >= 12288) ? 1 : 0;
        const bs_real turning = (quarter < 1024) || (quarter >= 3072) ? BS_REAL(0.03125) : BS_REAL(-0.03125);
        sense(&increments, (turns != 0) ? turning : BS_REAL(0.0));
        rates(&imu, &increments, DT);
        judge(ah_filter_strapdown(&filter, &imu, &increments));
        if ((k % STEP) == 0) {
            rates(&imu, &increments, (bs_real)STEP * DT);
            judge(ah_filter_propagate(&filter, &imu, &noises));
        }
        if ((k % RATE) == 0) {
            send(&still, k, &imu);
        }
        if (((k % (8 * RATE)) == 0) && (turns == 0)) {
            send(&azimuth, k, &imu);
        }
        if (still.arrives == k) {
            taken(ah_filter_measure_zupt(&filter, R_zupt, &gates, &innovation), &innovation);
            if (turns == 0) {
                taken(ah_filter_measure_zaru(&filter, &still.imu, R_zaru, &gates, &innovation), &innovation);
            }
        }
        if (azimuth.arrives == k) {
            taken(ah_filter_measure_azimuth(&filter, &azimuth.reference, R_azimuth, &gates, &innovation), &innovation);
        }
        if ((k % STEP) == 0) {
            (void)ah_filter_digest(&filter, &digest);
        }
        if ((k % EVERY) == 0) {
            (void)bs_digest_end(&digest, flight_digests[(k / EVERY) - 1]);
        }
        ++flight_counts[0];
    }
    return flight_counts[3];
}

#ifdef FLIGHT_MAIN
#include <stdio.h>

int main(void)
{
#ifdef FLIGHT_FLUSH
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040U); /* to show that it is seen */
#endif
    (void)flight();
    for (int i = 0; i < 5; ++i) {
        (void)printf("%d ", flight_counts[i]);
    }
    (void)printf("%d %d %u\n", flight_flush[0], flight_flush[1], flight_control);
    for (int i = 0; i < DIGESTS; ++i) {
        for (unsigned int j = 0U; j < BS_DIGEST_SIZE; ++j) {
            (void)printf("%02x", (unsigned int)flight_digests[i][j]);
        }
        (void)printf("\n");
    }
    return 0;
}
#endif

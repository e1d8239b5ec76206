/* flight.c - see flight.h. */
#include "flight.h"

#include <string.h>

#define DEGREES 57.295779513082321 /* in a radian */
#define MILS 1018.5916357881302

static void convert(bs_real *out, const double *in, int n)
{
    for (int i = 0; i < n; ++i) {
        out[i] = (bs_real)in[i];
    }
}

static bs_real square(double sigma)
{
    return (bs_real)sigma * (bs_real)sigma;
}

/* The slave so many ticks ago. */
static const flight_tick *ago(const flight *f, int ticks)
{
    return &f->past[(f->newest - (unsigned int)ticks) % FLIGHT_PAST];
}

/* The slave of now as the newest tick. */
static void remember(flight *f)
{
    flight_tick *tick = &f->past[f->newest];

    (void)memcpy(tick->v_n, f->filter.nav.v_n, sizeof tick->v_n);
    (void)memcpy(tick->q_b2n_wxyz, f->filter.nav.q_b2n_wxyz, sizeof tick->q_b2n_wxyz);
}

static void keep(flight *f, const bs_real dtheta[3], const bs_real dv[3])
{
    flight_tick *tick;

    f->newest = (f->newest + 1U) % FLIGHT_PAST;
    remember(f);
    tick = &f->past[f->newest];
    (void)memcpy(tick->dtheta, dtheta, sizeof tick->dtheta);
    (void)memcpy(tick->dv, dv, sizeof tick->dv);
}

/* Means of rate and specific force, biases removed, between two instants so many ticks ago. */
static va_corrected_imu mean(const flight *f, int from, int to)
{
    const bs_real dt = (bs_real)f->setup.dt;
    const bs_real seconds = (bs_real)(from - to) * dt;
    va_corrected_imu imu;

    for (int i = 0; i < 3; ++i) {
        bs_real angle = BS_REAL(0.0);
        bs_real push = BS_REAL(0.0);
        for (int j = from - 1; j >= to; --j) {
            angle += ago(f, j)->dtheta[i];
            push += ago(f, j)->dv[i];
        }
        imu.omega_ib_b[i] = (angle / seconds) - f->filter.nav.gyro_bias[i];
        imu.f_b[i] = (push / seconds) - f->filter.nav.accel_bias[i];
    }
    imu.dt = seconds;
    return imu;
}

/* The covariance up to now. */
static bs_status carry(flight *f)
{
    bs_status status = BS_OK;

    if (f->behind > 0) {
        const va_corrected_imu imu = mean(f, f->behind, 0);
        status = va_filter_propagate(&f->filter, &imu, &f->noise);
        f->behind = 0;
    }
    return bs_good(status) ? BS_OK : status;
}

/* One element of the covariance, and its mirror image. */
static void put(bs_real P[VA_N_STATES * VA_N_STATES], int i, int j, bs_real value)
{
    P[(i * VA_N_STATES) + j] = value;
    P[(j * VA_N_STATES) + i] = value;
}

/* The slave takes the master's velocity and attitude over: what is wrong with the mounting is wrong with its attitude,
 * phi = C_m2n dmu. */
static bs_status start(flight *f, const flight_message *message)
{
    const flight_setup *s = &f->setup;
    const bs_real zero[3] = { BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0) };
    bs_real q[4];
    bs_status status;
    va_nav nav = { .q_b2m_wxyz = { BS_REAL(1.0), BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0) } };

    convert(nav.lat_lon_height, message->position, 3);
    convert(nav.v_n, message->v_m_n, 3);
    convert(nav.q_b2n_wxyz, message->q_m2n_wxyz, 4);
    convert(q, message->q_m2n_wxyz, 4);
    {
        const bs_real w = q[0], x = q[1], y = q[2], z = q[3], two = BS_REAL(2.0), one = BS_REAL(1.0);
        const bs_real C[3][3] = {
            { one - (two * ((y * y) + (z * z))), two * ((x * y) - (w * z)), two * ((x * z) + (w * y)) },
            { two * ((x * y) + (w * z)), one - (two * ((x * x) + (z * z))), two * ((y * z) - (w * x)) },
            { two * ((x * z) - (w * y)), two * ((y * z) + (w * x)), one - (two * ((x * x) + (y * y))) },
        };
        (void)memset(f->dense, 0, sizeof f->dense);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                bs_real sum = (i == j) ? square(s->attitude_sigma) + square(s->start_angle_sigma) : BS_REAL(0.0);
                for (int k = 0; k < 3; ++k) {
                    sum += C[i][k] * square(s->mounting_sigma[k]) * C[j][k];
                }
                put(f->dense, VA_IX_PHI_N + i, VA_IX_PHI_N + j, sum);
                put(f->dense, VA_IX_PHI_N + i, VA_IX_DMU_X + j, C[i][j] * square(s->mounting_sigma[j]));
            }
            put(f->dense, VA_IX_DV_N + i, VA_IX_DV_N + i, square(s->start_velocity_sigma));
            put(f->dense, VA_IX_DBG_X + i, VA_IX_DBG_X + i, square(s->gyro_bias_sigma));
            put(f->dense, VA_IX_DBA_X + i, VA_IX_DBA_X + i, square(s->accel_bias_sigma));
            put(f->dense, VA_IX_DMU_X + i, VA_IX_DMU_X + i, square(s->mounting_sigma[i]));
        }
        put(f->dense, VA_IX_D_TAU, VA_IX_D_TAU, square(s->tau_sigma));
    }
    status = va_filter_init(&f->filter, &nav, f->dense);
    if (status == BS_OK) {
        keep(f, zero, zero);
        f->fresh = 0;
        f->behind = 0;
        f->flying = 1;
        f->begun += 1U;
    }
    return status;
}

void flight_begin(flight *f, const flight_setup *setup)
{
    (void)memset(f, 0, sizeof *f);
    f->setup = *setup;
    convert(f->mounting.lever_b, setup->lever_b, 3);
    for (int i = 0; i < 3; ++i) {
        f->noise.gyro_noise[i] = (bs_real)setup->gyro_noise;
        f->noise.accel_noise[i] = (bs_real)setup->accel_noise;
    }
}

bs_status flight_slave(flight *f, const double dtheta[3], const double dv[3])
{
    const va_corrected_imu imu = { .dt = (bs_real)f->setup.dt };
    const flight_tick *before = ago(f, 0);
    va_increments now;
    bs_status refused;
    bs_status status;

    if (!f->flying) {
        return BS_NOT_READY;
    }
    convert(now.dtheta_ib_b, dtheta, 3);
    convert(now.dv_b, dv, 3);
    (void)memcpy(now.dtheta_before, before->dtheta, sizeof now.dtheta_before);
    (void)memcpy(now.dv_before, before->dv, sizeof now.dv_before);
    refused = va_filter_strapdown(&f->filter, &imu, &now);
    status = refused;
    if (refused != BS_OK) {
        f->held += 1U;
        (void)memcpy(now.dtheta_ib_b, before->dtheta, sizeof now.dtheta_ib_b);
        (void)memcpy(now.dv_b, before->dv, sizeof now.dv_b);
        status = va_filter_strapdown(&f->filter, &imu, &now);
    }
    if (status == BS_OK) {
        keep(f, now.dtheta_ib_b, now.dv_b);
        f->fresh = (f->fresh < (FLIGHT_PAST - 1)) ? (f->fresh + 1) : f->fresh;
        f->behind += 1;
        if (f->behind == FLIGHT_EVERY) {
            status = carry(f);
        }
    }
    if (status != BS_OK) {
        f->flying = 0;
        return status;
    }
    return refused;
}

/* The velocity expected of the master so many ticks ago. */
static bs_status expected_velocity(const flight *f, int ticks, bs_real v_m_n[3])
{
    const va_corrected_imu imu = mean(f, ticks + FLIGHT_HALF, ticks - FLIGHT_HALF);
    va_nav nav = f->filter.nav;
    bs_real q_m2n_wxyz[4];
    bs_real omega_nb_n[3];

    (void)memcpy(nav.v_n, ago(f, ticks)->v_n, sizeof nav.v_n);
    (void)memcpy(nav.q_b2n_wxyz, ago(f, ticks)->q_b2n_wxyz, sizeof nav.q_b2n_wxyz);
    return va_expected(&nav, &imu, &f->mounting, v_m_n, q_m2n_wxyz, omega_nb_n);
}

/* The tick that the message is held against, and the rest of its age, which is all that is beyond the ticks that can be
 * used: a rate of change reaches over 2 FLIGHT_HALF ticks to both sides, to no tick before the last correction. */
static int matched(const flight *f, bs_real age, bs_real *lag)
{
    const bs_real dt = (bs_real)f->setup.dt;
    const int most = f->fresh - (2 * FLIGHT_HALF);
    int ticks = 2 * FLIGHT_HALF;

    while ((ticks < most) && (age > (((bs_real)ticks + BS_REAL(0.5)) * dt))) {
        ticks += 1;
    }
    *lag = age - ((bs_real)ticks * dt);
    return ticks;
}

bs_status flight_master(flight *f, const flight_message *message)
{
    const bs_real Rv = square(f->setup.velocity_sigma), Ra = square(f->setup.attitude_sigma);
    const bs_real R_velocity[3] = { Rv, Rv, Rv }, R_attitude[3] = { Ra, Ra, Ra };
    const bs_gates gates = { .rows = BS_ALL_ROWS, .gate = FLIGHT_GATE };
    va_innovation innovation[2] = { { .used = 0U }, { .used = 0U } };
    va_master master = { .q_m2n_wxyz = { BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0) } };
    bs_real early[3], late[3];
    bs_status status, velocity, attitude;
    va_health health;
    unsigned int all;
    va_corrected_imu imu;
    va_nav now;
    int ticks;

    if (!f->flying) {
        status = start(f, message);
        f->refused += (status != BS_OK) ? 1U : 0U;
        return status;
    }
    if (f->fresh < (4 * FLIGHT_HALF)) {
        f->refused += 1U;
        return BS_NOT_READY;
    }
    status = carry(f);
    ticks = matched(f, (bs_real)message->waited + f->filter.nav.tau, &master.lag);
    if (status == BS_OK) {
        status = expected_velocity(f, ticks + FLIGHT_HALF, early);
    }
    if (status == BS_OK) {
        status = expected_velocity(f, ticks - FLIGHT_HALF, late);
    }
    if (status != BS_OK) {
        f->flying = 0;
        f->refused += 1U;
        return status;
    }
    for (int i = 0; i < 3; ++i) {
        master.a_n[i] = (late[i] - early[i]) / (BS_REAL(2.0) * (bs_real)FLIGHT_HALF * (bs_real)f->setup.dt);
    }
    imu = mean(f, ticks + FLIGHT_HALF, ticks - FLIGHT_HALF);
    convert(master.v_m_n, message->v_m_n, 3);
    convert(master.q_m2n_wxyz, message->q_m2n_wxyz, 4);

    /* The filter measures the slave that stands in it: for so long, the slave as it was.  The error found is the one of
     * then; what happens to it until now is left out: 3 mm/s for a tilt of half a degree and 35 ms. */
    now = f->filter.nav;
    (void)memcpy(f->filter.nav.v_n, ago(f, ticks)->v_n, sizeof now.v_n);
    (void)memcpy(f->filter.nav.q_b2n_wxyz, ago(f, ticks)->q_b2n_wxyz, sizeof now.q_b2n_wxyz);
    convert(f->filter.nav.lat_lon_height, message->position, 3);
    velocity = va_filter_measure_velocity(&f->filter, &imu, &f->mounting, &master, R_velocity, &gates, &innovation[0]);
    attitude = va_filter_measure_dcm(&f->filter, &imu, &master, R_attitude, &gates, &innovation[1]);
    if (bs_good(velocity) || bs_good(attitude)) { /* both have looked at the position */
        (void)memcpy(now.lat_lon_height, f->filter.nav.lat_lon_height, sizeof now.lat_lon_height);
    }
    f->filter.nav = now;
    status = va_filter_correct(&f->filter);
    if ((status != BS_OK) || (velocity == BS_NOT_POSITIVE) || (attitude == BS_NOT_POSITIVE)) {
        f->flying = 0; /* the error is too large for this filter, or its covariance is none */
        f->refused += 1U;
        return (status != BS_OK) ? status : BS_NOT_POSITIVE;
    }
    remember(f);
    f->fresh = 0;
    all = innovation[0].used & innovation[1].used;
    f->taken += (all == 7U) ? 1U : 0U;
    f->refused += ((innovation[0].used | innovation[1].used) == 0U) ? 1U : 0U;
    f->in_part += ((all != 7U) && ((innovation[0].used | innovation[1].used) != 0U)) ? 1U : 0U;
    if (!bs_good(velocity) || !bs_good(attitude)) {
        return bs_good(velocity) ? attitude : velocity;
    }
    (void)va_filter_health(&f->filter, &health);
    if ((health.rejected[VA_MEASUREMENT_VELOCITY] >= FLIGHT_ASTRAY) ||
        (health.rejected[VA_MEASUREMENT_DCM] >= FLIGHT_ASTRAY)) {
        f->flying = 0; /* the master has jumped, or the slave */
    }
    return BS_OK;
}

bs_status flight_report(flight *f, flight_line *line)
{
    const va_nav *nav = &f->filter.nav;
    const double w = (double)nav->q_b2n_wxyz[0], x = (double)nav->q_b2n_wxyz[1];
    const double y = (double)nav->q_b2n_wxyz[2], z = (double)nav->q_b2n_wxyz[3];
    bs_real sigma[VA_N_STATES];
    double v[3], sine, turn, yaw;
    bs_status status;

    if (!f->flying) {
        return BS_NOT_READY;
    }
    status = va_filter_sigmas(&f->filter, sigma);
    if (status != BS_OK) {
        return status;
    }
    yaw = DEGREES * atan2(2.0 * ((w * z) + (x * y)), 1.0 - (2.0 * ((y * y) + (z * z))));
    line->heading_deg = (yaw < 0.0) ? (yaw + 360.0) : yaw;
    line->heading_sigma_mil = MILS * (double)sigma[VA_IX_PHI_D];
    for (int i = 0; i < 3; ++i) {
        v[i] = (double)nav->q_b2m_wxyz[i + 1];
    }
    sine = sqrt((v[0] * v[0]) + (v[1] * v[1]) + (v[2] * v[2]));
    turn = (sine > 0.0) ? (2.0 * atan2(sine, (double)nav->q_b2m_wxyz[0]) / sine) : 2.0;
    for (int i = 0; i < 3; ++i) {
        line->misalignment_deg[i] = DEGREES * turn * v[i];
    }
    line->delay_ms = 1e3 * (double)nav->tau;
    line->delay_sigma_ms = 1e3 * (double)sigma[VA_IX_D_TAU];
    return status;
}

/* truth.c - what is true at sea for many runs of many.c, in double: a hull in waves, the increments of ideal sensors on
 * it, the master's poses, and the covariance with which a filter begins. */
#include "sea.h"

enum { SEA = 2 /* of flight.MOTIONS, the random one */, COMPONENTS = 120, ROUNDS = 30 };
static const double ENOUGH = 1e-14; /* rad, and the same part of the velocity: rounding */

/* A scenario of `flight`, beyond `common`. */
typedef struct {
    double motion;
    double height;
    double log_gamma;
    double frequency;
    double ratio[3]; /* of roll, pitch, yaw by the slope of the wave, and how far they are ahead of it, rad */
    double phase[3];
    double waves; /* rad, where they run to from the bow */
    double speed;
    double heading;
    double latitude;
    double mounting;            /* rad, in heading */
    double sigma[ALL + 4];      /* of the biases, the mounting and the delay */
    double start_velocity;      /* sigmas added to those of the master's report */
    double start_angle;
    hull_shape hull;
} scene;

/* A motion with its numbers. */
typedef struct {
    hull_motion of;
    double omega[COMPONENTS];
    double amplitude[COMPONENTS][HULL_FREEDOMS][2];
} motion;

/* hull.by_slope: heave with a wave of one frequency, and angles by its slope. */
static void on_a_wave(const scene *s, motion *m)
{
    const double omega = 6.283185307179586 * s->frequency;
    const double slope = ((omega * omega) / 9.80665) * s->height;
    m->omega[0] = omega;
    for (int i = 0; i < HULL_FREEDOMS; ++i) {
        const double size = (i < HULL_HEAVE) ? 0.0 : ((i == HULL_HEAVE) ? -s->height : (slope * s->ratio[i - HULL_ROLL]));
        const double ahead = (i < HULL_ROLL) ? 0.0 : s->phase[i - HULL_ROLL];
        m->amplitude[0][i][0] = size * bs_sin(ahead); /* size sin(omega t + ahead) */
        m->amplitude[0][i][1] = -(size * bs_cos(ahead));
    }
    m->of.count = 1U;
}

/* A random sea: each of its waves begins anywhere. */
static void in_sea(const scene *s, uint64_t seed, uint64_t number, motion *m)
{
    double elevation[COMPONENTS];
    uint64_t word[COMPONENTS];
    hull_waves(s->height, s->log_gamma, COMPONENTS, m->omega, elevation);
    boresight_words(seed, &number, 1U, WAVES, 0U, COMPONENTS, word, 0, 1);
    for (int k = 0; k < COMPONENTS; ++k) {
        double answer[HULL_FREEDOMS][2];
        double sine;
        double cosine;
        bs_sincos(6.283185307179586 * ((double)(word[k] >> 11U) * 1.1102230246251565e-16), &sine, &cosine);
        m->omega[k] = hull_response(&s->hull, m->omega[k], s->waves, s->speed, answer);
        for (int i = 0; i < HULL_FREEDOMS; ++i) {
            m->amplitude[k][i][0] = elevation[k] * ((answer[i][0] * cosine) - (answer[i][1] * sine));
            m->amplitude[k][i][1] = elevation[k] * ((answer[i][0] * sine) + (answer[i][1] * cosine));
        }
    }
    m->of.count = COMPONENTS;
}

/* The slave's velocity and attitude at a time. */
static void slave_at(const motion *m, const common *all, const double q_b2m[4], double time, double v_n[3], double q[4])
{
    double rate[3];
    hull_ride(&m->of, time, v_n, q, rate);
    hull_carry(all->lever, q_b2m, rate, v_n, q);
}

/* The increments of one sample by inverting the strapdown: nav is carried on, to v_n and q where they are true.
 * returns 0, or what the strapdown refused, or -1 if none make this step */
static int inverted(va_nav *nav, const common *all, const double v_n[3], const double q[4], int first,
                    va_increments *increments)
{
    va_corrected_imu imu = { { 0 }, { 0 }, 0 };
    va_nav made = *nav;
    const double inverse[4] = { nav->q_b2n_wxyz[0], -nav->q_b2n_wxyz[1], -nav->q_b2n_wxyz[2], -nav->q_b2n_wxyz[3] };
    double left = 1.0;
    imu.dt = all->dt;
    for (int round = 0; (round < ROUNDS) && (left > ENOUGH); ++round) {
        double error_n[3];
        double turn[3];
        double step[3];
        if (first != 0) { /* those before the first are as the first */
            for (int i = 0; i < 3; ++i) {
                increments->dtheta_before[i] = increments->dtheta_ib_b[i];
                increments->dv_before[i] = increments->dv_b[i];
            }
        }
        const bs_status status = va_strapdown(nav, &imu, increments, made.lat_lon_height, made.v_n, made.q_b2n_wxyz);
        if (status != BS_OK) {
            return (int)status;
        }
        attitude_error(made.q_b2n_wxyz, q, error_n);
        hull_turned(inverse, error_n, turn);
        for (int i = 0; i < 3; ++i) {
            error_n[i] = v_n[i] - made.v_n[i];
        }
        hull_turned(inverse, error_n, step);
        left = 0.0;
        for (int i = 0; i < 3; ++i) {
            const double size = (v_n[i] < 0.0) ? -v_n[i] : v_n[i];
            const double part = ((step[i] < 0.0) ? -step[i] : step[i]) / ((size > 1.0) ? size : 1.0);
            const double angle = (turn[i] < 0.0) ? -turn[i] : turn[i];
            left = (part > left) ? part : left;
            left = (angle > left) ? angle : left;
            increments->dtheta_ib_b[i] = increments->dtheta_ib_b[i] + turn[i];
            increments->dv_b[i] = increments->dv_b[i] + step[i];
        }
    }
    *nav = made;
    convert(v_n, nav->v_n, 3);
    convert(q, nav->q_b2n_wxyz, 4);
    return (left > ENOUGH) ? -1 : 0;
}

/* The inverse of a matrix of six rows, which is lost. */
static void invert(double A[ALL][ALL], double D[ALL][ALL])
{
    for (int i = 0; i < ALL; ++i) {
        for (int j = 0; j < ALL; ++j) {
            D[i][j] = (i == j) ? 1.0 : 0.0;
        }
    }
    for (int k = 0; k < ALL; ++k) {
        int best = k;
        for (int i = k + 1; i < ALL; ++i) {
            best = ((A[i][k] * A[i][k]) > (A[best][k] * A[best][k])) ? i : best;
        }
        for (int j = 0; j < ALL; ++j) {
            const double a = A[best][j];
            const double d = D[best][j];
            A[best][j] = A[k][j];
            D[best][j] = D[k][j];
            A[k][j] = a;
            D[k][j] = d;
        }
        const double pivot = A[k][k];
        for (int j = 0; j < ALL; ++j) {
            A[k][j] = A[k][j] / pivot;
            D[k][j] = D[k][j] / pivot;
        }
        for (int i = 0; i < ALL; ++i) {
            const double times = (i == k) ? 0.0 : A[i][k];
            for (int j = 0; j < ALL; ++j) {
                A[i][j] = A[i][j] - (times * A[k][j]);
                D[i][j] = D[i][j] - (times * D[k][j]);
            }
        }
    }
}

/* The covariance of a slave that takes its master's report over, as transfer.first: H x is noise, so that the errors of
 * attitude and velocity are D (noise - H x of all others). */
static int begun(const common *all, const scene *s, const double *report, const double position[3], double *P)
{
    const int n = VA_N_STATES;
    va_corrected_imu imu = { { 0 }, { 0 }, 0 };
    va_mounting mounting;
    va_master master = { { 0 }, { 0 }, { 0 }, { 0 }, 0 };
    va_nav nav = { { 0 }, { 0 }, { 0 }, { 0 }, { 0 }, { BS_REAL(1.0), 0, 0, 0 }, 0 };
    double H[ALL * VA_N_STATES];
    double A[ALL][ALL];
    double D[ALL][ALL];
    convert(position, nav.lat_lon_height, 3);
    convert(report, nav.v_n, 3);
    convert(&report[3], nav.q_b2n_wxyz, 4);
    convert(all->lever, mounting.lever_b, 3);
    bs_status status = va_velocity_H(&nav, &imu, &mounting, &master, &H[0]);
    if (status == BS_OK) {
        status = va_dcm_H(&nav, &imu, &H[3 * n]);
    }
    for (int i = 0; i < ALL; ++i) {
        for (int j = 0; j < ALL; ++j) {
            A[i][j] = H[(i * n) + j];
        }
    }
    invert(A, D);
    for (int i = 0; i < (n * n); ++i) {
        P[i] = 0.0;
    }
    for (int k = ALL; k < n; ++k) {
        const double variance = s->sigma[k - ALL] * s->sigma[k - ALL];
        double by[ALL];
        P[(k * n) + k] = variance;
        for (int i = 0; i < ALL; ++i) {
            by[i] = 0.0;
            for (int j = 0; j < ALL; ++j) {
                by[i] = by[i] - (D[i][j] * H[(j * n) + k]);
            }
            P[(i * n) + k] = by[i] * variance;
            P[(k * n) + i] = P[(i * n) + k];
        }
        for (int i = 0; i < ALL; ++i) {
            for (int j = 0; j <= i; ++j) {
                P[(i * n) + j] = P[(i * n) + j] + ((by[i] * by[j]) * variance);
            }
        }
    }
    for (int i = 0; i < ALL; ++i) {
        for (int j = 0; j <= i; ++j) {
            for (int k = 0; k < ALL; ++k) { /* rows of the velocity, then of the attitude */
                const double sigma = (k < 3) ? all->velocity_noise : all->attitude_noise;
                P[(i * n) + j] = P[(i * n) + j] + ((D[i][k] * D[j][k]) * (sigma * sigma));
            }
            P[(j * n) + i] = P[(i * n) + j];
        }
        const double more = (i < 3) ? s->start_angle : s->start_velocity;
        P[(i * n) + i] = P[(i * n) + i] + (more * more);
    }
    return (int)status;
}

/* Sea `number`, to `out`, as sea.h says.
 * returns 0, or what the model refused, or -1 where no increments make this motion */
int sea_truth(const double *given, const double *setting, uint64_t seed, uint64_t number, double *out);
int sea_truth(const double *given, const double *setting, uint64_t seed, uint64_t number, double *out)
{
    const common *const all = (const common *)given;
    const scene *const s = (const scene *)setting;
    const size_t updates = (size_t)all->updates;
    const size_t samples = (size_t)all->samples;
    sea *const to = (sea *)out;
    double *const master = &out[sizeof(sea) / sizeof(double)];
    double *const ideal = &master[NODES * (updates + 1U) * PARTS];
    va_increments increments = { { 0 }, { 0 }, { 0 }, { 0 } };
    va_nav nav = { { 0 }, { 0 }, { 0 }, { 0 }, { 0 }, { BS_REAL(1.0), 0, 0, 0 }, 0 };
    motion m;
    int status = 0;
    if (s->motion == (double)SEA) {
        in_sea(s, seed, number, &m);
    } else {
        on_a_wave(s, &m);
    }
    m.of.omega = m.omega;
    m.of.amplitude = (const double(*)[HULL_FREEDOMS][2])m.amplitude;
    m.of.heading = s->heading;
    m.of.speed = (s->motion == (double)SEA) ? s->speed : 0.0;
    to->q_b2m[1] = 0.0;
    to->q_b2m[2] = 0.0;
    bs_sincos(s->mounting / 2.0, &to->q_b2m[3], &to->q_b2m[0]);
    to->position[0] = s->latitude;
    to->position[1] = 0.0;
    to->position[2] = 0.0;
    for (size_t i = 0U; i < NODES; ++i) { /* Chebyshev's */
        const double turn = bs_cos((3.141592653589793 * ((double)i + 0.5)) / (double)NODES);
        to->delays[i] = (1e-3 * (((2.0 * all->delay_ms[0]) + all->delay_ms[1]) + (all->delay_ms[1] * turn))) / 2.0;
        for (size_t k = 0U; k <= updates; ++k) {
            double *const pose = &master[((i * (updates + 1U)) + k) * PARTS];
            double rate[3];
            const double time = ((double)k * all->samples) * all->dt;
            hull_ride(&m.of, time - to->delays[i], &pose[0], &pose[3], rate);
        }
    }
    slave_at(&m, all, to->q_b2m, 0.0, to->v_n, to->q_b2n);
    convert(to->position, nav.lat_lon_height, 3);
    convert(to->v_n, nav.v_n, 3);
    convert(to->q_b2n, nav.q_b2n_wxyz, 4);
    for (size_t k = 0U; (k < (updates * samples)) && (status == 0); ++k) {
        slave_at(&m, all, to->q_b2m, (double)(k + 1U) * all->dt, to->v_n, to->q_b2n);
        status = inverted(&nav, all, to->v_n, to->q_b2n, (k == 0U) ? 1 : 0, &increments);
        for (int i = 0; i < 3; ++i) {
            ideal[(k * ALL) + 5U - (size_t)i] = increments.dtheta_ib_b[i];
            ideal[(k * ALL) + 2U - (size_t)i] = increments.dv_b[i];
            increments.dtheta_before[i] = increments.dtheta_ib_b[i];
            increments.dv_before[i] = increments.dv_b[i];
        }
        if (k == 0U) {
            double omega[3];
            for (int i = 0; i < 3; ++i) {
                omega[i] = increments.dtheta_ib_b[i] / all->dt;
            }
            hull_cross(omega, all->lever, to->swing);
        }
    }
    return (status != 0) ? status : begun(all, s, master, to->position, to->P);
}

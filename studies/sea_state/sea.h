/* sea.h - what truth.c writes and many.c reads: the scenario and the seas of `boresight many`, as doubles. */
#ifndef BORESIGHT_SEA_H
#define BORESIGHT_SEA_H

#include "boresight_math.h"
#include "velocity_attitude_filter.h"

#include "hull.h"
#include "run.h"

enum { NODES = 6, ALL = 6, PARTS = 7, DRAWN = 8 /* samples at a time */, SLAVE = 0, MASTER = 1, DELAY = 2, WAVES = 3 };

/* What `given` begins with. */
typedef struct {
    double updates;
    double settled; /* updates before NIS counts */
    double samples; /* of an update */
    double span;    /* samples of a rate */
    double seas;
    double together; /* runs of one sea that are neighbours */
    double dt;
    double gravity;
    double delay_ms[2]; /* the least, and how much more at most */
    double bias[ALL];   /* sigmas */
    double velocity_noise;
    double attitude_noise;
    double lever[3];
    double gyro_noise[3];
    double accel_noise[3];
    double mu_noise[3];
    double R[ALL];    /* of the attitude, of the velocity */
    double walk[DRAWN * ALL]; /* sigmas of samples, in the order of `ideal` */
} common;

/* Of a sea, behind that: these, and behind them the master's velocity and attitude (NODES, updates + 1, PARTS), then its
 * true samples, `ideal` (updates * samples, ALL), in each the components from the last to the first. */
typedef struct {
    double P[VA_N_STATES * VA_N_STATES];
    double position[3]; /* of the slave, at the start */
    double swing[3];    /* of the slave's velocity by the lever arm, at the start */
    double v_n[3];      /* at the end */
    double q_b2n[4];
    double q_b2m[4];
    double delays[NODES];
} sea;

static inline void normal(double q[4])
{
    const double norm = sqrt((((q[0] * q[0]) + (q[1] * q[1])) + (q[2] * q[2])) + (q[3] * q[3]));
    for (int i = 0; i < 4; ++i) {
        q[i] = q[i] / norm;
    }
}

static inline void convert(const double *from, bs_real *to, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = (bs_real)from[i];
    }
}

static inline void widen(const bs_real *from, double *to, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = (double)from[i];
    }
}

/* The turn that removes the error of an attitude, (3) rad, as rotation.attitude_error. */
static inline void attitude_error(const bs_real hat[4], const double q[4], double error[3])
{
    double p[4];
    widen(hat, p, 4);
    double w = (((q[0] * p[0]) + (q[1] * p[1])) + (q[2] * p[2])) + (q[3] * p[3]);
    const double v[3] = { (((q[1] * p[0]) - (q[0] * p[1])) + (q[3] * p[2])) - (q[2] * p[3]),
                          (((q[2] * p[0]) - (q[0] * p[2])) + (q[1] * p[3])) - (q[3] * p[1]),
                          (((q[3] * p[0]) - (q[0] * p[3])) + (q[2] * p[1])) - (q[1] * p[2]) };
    const double sign = (w < 0.0) ? -2.0 : 2.0;
    w = (w < 0.0) ? -w : w;
    const double length = sqrt(((v[0] * v[0]) + (v[1] * v[1])) + (v[2] * v[2]));
    const double scale = sign * ((length < (1e-8 * w)) ? (1.0 / w)
                                                       : ((double)bs_atan2((bs_real)length, (bs_real)w) / length));
    for (int i = 0; i < 3; ++i) {
        error[i] = scale * v[i];
    }
}

/* The delay of a run, and the weights of the master's poses for it. */
static inline double sea_delay(const common *all, const sea *true_, uint64_t seed, uint64_t run, double weight[NODES])
{
    uint64_t word;
    boresight_words(seed, &run, 1U, DELAY, 0U, 1U, &word, 0, 1);
    const double part = (double)(word >> 11U) * 1.1102230246251565e-16;
    const double delay = 1e-3 * (all->delay_ms[0] + (all->delay_ms[1] * part));
    const double *const at = true_->delays;
    for (int i = 0; i < NODES; ++i) {
        weight[i] = 1.0;
        for (int k = 0; k < NODES; ++k) {
            if (k != i) {
                weight[i] = weight[i] * ((delay - at[k]) / (at[i] - at[k]));
            }
        }
    }
    return delay;
}

/* What the master reports at an update. */
static inline void sea_report(const common *all, const double *master, const double weight[NODES], uint64_t seed,
                              uint64_t run, size_t update, double v[3], double q[4])
{
    static const double ones[ALL] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
    static const double none[ALL] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    const size_t updates = (size_t)all->updates;
    double pose[PARTS];
    double drawn[ALL];
    double turn[4];
    for (int i = 0; i < PARTS; ++i) {
        pose[i] = 0.0;
        for (size_t k = 0U; k < NODES; ++k) {
            pose[i] = pose[i] + (weight[k] * master[(((k * (updates + 1U)) + update) * PARTS) + (size_t)i]);
        }
    }
    normal(&pose[3]);
    boresight_normals(seed, &run, 1U, MASTER, ALL * (update + 1U), ALL, drawn, 0, 1, ones, none);
    turn[0] = 1.0;
    for (int i = 0; i < 3; ++i) {
        v[i] = pose[i] + (all->velocity_noise * drawn[i]);
        turn[1 + i] = (all->attitude_noise * drawn[3 + i]) / 2.0;
    }
    normal(turn);
    hull_product(turn, &pose[3], q);
}

/* The start of a slave, by its master's first report and with biases that are wrong: returns the delay. */
static inline double sea_begin(const common *all, const sea *true_, const double *master, uint64_t seed, uint64_t run,
                               double weight[NODES], va_nav *nav)
{
    static const double none[ALL] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    const double delay = sea_delay(all, true_, seed, run, weight);
    double bias[ALL];
    double v[3];
    double q[4];
    double swing[3];
    boresight_normals(seed, &run, 1U, MASTER, 0U, ALL, bias, 0, 1, all->bias, none);
    sea_report(all, master, weight, seed, run, 0U, v, q);
    hull_turned(q, true_->swing, swing);
    for (int i = 0; i < 3; ++i) {
        nav->v_n[i] = (bs_real)(v[i] + swing[i]);
    }
    convert(true_->position, nav->lat_lon_height, 3);
    convert(q, nav->q_b2n_wxyz, 4);
    convert(&bias[0], nav->gyro_bias, 3);
    convert(&bias[3], nav->accel_bias, 3);
    for (int i = 0; i < 4; ++i) {
        nav->q_b2m_wxyz[i] = (i == 0) ? BS_REAL(1.0) : BS_REAL(0.0);
    }
    nav->tau = BS_REAL(0.0);
    return delay;
}

/* Sample k, asked for one after the other, from its last component to the first; `drawn` keeps DRAWN of them. */
static inline const double *sea_sample(const common *all, const double *ideal, uint64_t seed, uint64_t run, size_t k,
                                       double drawn[DRAWN * ALL])
{
    if ((k % DRAWN) == 0U) {
        const size_t left = ((size_t)all->updates * (size_t)all->samples) - k;
        boresight_normals(seed, &run, 1U, SLAVE, ALL * k, ALL * ((left < DRAWN) ? left : DRAWN), drawn, 0, 1,
                          all->walk, &ideal[ALL * k]);
    }
    return &drawn[ALL * (k % DRAWN)];
}
#endif

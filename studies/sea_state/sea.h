/* sea.h - what truth.c writes and many.c reads: the scenario and the seas of `boresight many`, as doubles. */
#ifndef BORESIGHT_SEA_H
#define BORESIGHT_SEA_H

#include "boresight_math.h"
#include "velocity_attitude_filter.h"

#include "hull.h"

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
#endif

/* hull.h - a hull in waves as hull.py and sea.py have it, for experiments in C: by sines of our own, so that every
 * processor and every card has the same bits.  Of double precision.
 * Frames: n is NED at the hull's mean place, m the hull's axes, b those of a slave on it; Euler angles are roll, pitch,
 * yaw. */
#ifndef BORESIGHT_HULL_H
#define BORESIGHT_HULL_H

#include <math.h>
#include <stddef.h>

#include "boresight_math.h"

enum { HULL_SURGE, HULL_SWAY, HULL_HEAVE, HULL_ROLL, HULL_PITCH, HULL_YAW, HULL_FREEDOMS };

/* hull.Hull, in its order: m, s and 1. */
typedef struct {
    double length;
    double beam;
    double draught;
    double heave_period;
    double heave_damping;
    double pitch_period;
    double pitch_damping;
    double roll_period;
    double roll_damping;
} hull_shape;

/* Each freedom is Re sum_k amplitude_k exp(i omega_k t), in m and rad, about a steady course. */
typedef struct {
    size_t count;
    const double *omega;                          /* rad/s */
    const double (*amplitude)[HULL_FREEDOMS][2]; /* real and imaginary part */
    double heading;                               /* rad */
    double speed;                                 /* m/s */
} hull_motion;

static inline void hull_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = (a[1] * b[2]) - (a[2] * b[1]);
    out[1] = (a[2] * b[0]) - (a[0] * b[2]);
    out[2] = (a[0] * b[1]) - (a[1] * b[0]);
}

/* C of q times a vector. */
static inline void hull_turned(const double q[4], const double vector[3], double out[3])
{
    double twice[3];
    double more[3];
    hull_cross(&q[1], vector, twice);
    for (int i = 0; i < 3; ++i) {
        twice[i] = 2.0 * twice[i];
    }
    hull_cross(&q[1], twice, more);
    for (int i = 0; i < 3; ++i) {
        out[i] = (vector[i] + (q[0] * twice[i])) + more[i];
    }
}

/* Product of quaternions, C(p) C(q). */
static inline void hull_product(const double p[4], const double q[4], double out[4])
{
    out[0] = (((p[0] * q[0]) - (p[1] * q[1])) - (p[2] * q[2])) - (p[3] * q[3]);
    out[1] = (((p[0] * q[1]) + (p[1] * q[0])) + (p[2] * q[3])) - (p[3] * q[2]);
    out[2] = (((p[0] * q[2]) - (p[1] * q[3])) + (p[2] * q[0])) + (p[3] * q[1]);
    out[3] = (((p[0] * q[3]) + (p[1] * q[2])) - (p[2] * q[1])) + (p[3] * q[0]);
}

#ifndef BORESIGHT_FLOAT /* whose sines are those of single precision */
/* ---- Waves. ---- */

/* JONSWAP's spectrum of omega over its peak, of no scale; Pierson and Moskowitz's with log_gamma 0. */
static inline double hull_spectrum(double ratio, double log_gamma)
{
    const double r = (ratio > 0.1) ? ratio : 0.1; /* below, it is zero already */
    const double off = (r - 1.0) / ((r > 1.0) ? 0.09 : 0.07);
    const double fourth = (r * r) * (r * r);
    return (bs_exp(-1.25 / fourth) / (fourth * r)) * bs_exp(log_gamma * bs_exp(-0.5 * (off * off)));
}

/* How much more energy the peak brings, of that without it. */
static inline double hull_peak_energy(double log_gamma)
{
    double with_peak = 0.0;
    double without = 0.0;
    for (int i = 0; (log_gamma > 0.0) && (i <= 200000); ++i) {
        const double ratio = 0.2 + ((double)i * (39.8 / 200000.0));
        const double part = ((i == 0) || (i == 200000)) ? 0.5 : 1.0;
        with_peak = with_peak + (part * hull_spectrum(ratio, log_gamma));
        without = without + (part * hull_spectrum(ratio, 0.0));
    }
    return (log_gamma > 0.0) ? (with_peak / without) : 1.0;
}

/* sea.components: a fully developed sea of this significant height (m) as waves, rad/s and m. */
static inline void hull_waves(double height, double log_gamma, size_t count, double *omega, double *elevation)
{
    const size_t fine = 32U;
    const double step = 2.995732273553991 / (double)(count * fine); /* log(20), from half the peak to ten times it */
    const double peak = sqrt((4.0 * sqrt(0.0081 / 5.0)) * 9.80665 / height);
    const double scale = (5.0 / 16.0) / hull_peak_energy(log_gamma);
    double low = 0.5;
    for (size_t k = 0U; k < count; ++k) {
        double m0 = 0.0;
        double m2 = 0.0;
        for (size_t i = 1U; i <= fine; ++i) {
            const double high = 0.5 * bs_exp((double)((k * fine) + i) * step);
            const double at = (low + high) / 2.0;
            const double energy = (scale * hull_spectrum(at, log_gamma)) * (high - low);
            m0 = m0 + energy;
            m2 = m2 + (energy * (at * at));
            low = high;
        }
        omega[k] = peak * sqrt(m2 / m0);
        elevation[k] = height * sqrt(2.0 * m0);
    }
}

/* sin(x) / x: the mean of cos over -x to x. */
static inline double hull_mean_of_wave(double x)
{
    return (x == 0.0) ? 1.0 : (bs_sin(x) / x);
}

/* 3 (sin x - x cos x) / x^3: the best straight line through sin over -x to x, of its slope at 0. */
static inline double hull_slope_of_wave(double x)
{
    if (((x < 0.0) ? -x : x) < 1e-2) {
        return 1.0 - ((x * x) / 10.0);
    }
    return (3.0 * (bs_sin(x) - (x * bs_cos(x)))) / ((x * x) * x);
}

/* An oscillator's answer to a wave, times `by`, times a complex number. */
static inline void hull_oscillate(double omega, double period, double damping, const double by[2], double out[2])
{
    const double ratio = (omega * period) / 6.283185307179586;
    const double re = 1.0 - (ratio * ratio);
    const double im = (2.0 * damping) * ratio;
    const double norm = (re * re) + (im * im);
    out[0] = ((by[0] * re) + (by[1] * im)) / norm;
    out[1] = ((by[1] * re) - (by[0] * im)) / norm;
}

/* hull.response: the frequency of encounter, and the freedoms for an elevation of 1 m at the centre.  towards: where
 * the waves run to from the bow, rad. */
static inline double hull_response(const hull_shape *hull, double omega, double towards, double speed,
                                   double answer[HULL_FREEDOMS][2])
{
    const double along = bs_cos(towards);
    const double across = bs_sin(towards);
    const double k = (omega * omega) / 9.80665;
    const double k_x = k * along;
    const double k_y = k * across;
    const double encounter = omega - (speed * k_x);
    const double x = (k_x * hull->length) / 2.0;
    const double y = (k_y * hull->beam) / 2.0;
    const double depth = bs_exp(-(k * hull->draught));
    const double height = (hull_mean_of_wave(x) * hull_mean_of_wave(y)) * depth;
    const double turn_x = (hull_slope_of_wave(x) * hull_mean_of_wave(y)) * depth;
    const double turn_y = (hull_mean_of_wave(x) * hull_slope_of_wave(y)) * depth;
    const double still = ((encounter < 1e-9) && (encounter > -1e-9)) ? 1e-9 : encounter;
    const double orbit = -(omega / still) * height;
    const double heave[2] = { -height, 0.0 };       /* downwards */
    const double roll[2] = { 0.0, k_y * turn_y };   /* the water rises to the right: a negative roll */
    const double pitch[2] = { 0.0, -(k_x * turn_x) }; /* it rises ahead: nose up */
    answer[HULL_SURGE][0] = 0.0;
    answer[HULL_SURGE][1] = orbit * along;
    answer[HULL_SWAY][0] = 0.0;
    answer[HULL_SWAY][1] = orbit * across;
    hull_oscillate(encounter, hull->heave_period, hull->heave_damping, heave, answer[HULL_HEAVE]);
    hull_oscillate(encounter, hull->roll_period, hull->roll_damping, roll, answer[HULL_ROLL]);
    hull_oscillate(encounter, hull->pitch_period, hull->pitch_damping, pitch, answer[HULL_PITCH]);
    answer[HULL_YAW][0] = -(((omega / still) * k_x) * (across * turn_x));
    answer[HULL_YAW][1] = 0.0;
    return encounter;
}

/* ---- Poses. ---- */

/* hull.ride: velocity (m/s) and attitude of the hull, and the rate of its axes against n in them (rad/s). */
static inline void hull_ride(const hull_motion *motion, double time, double v_n[3], double q_m2n[4], double rate_m[3])
{
    double angle[3] = { 0.0, 0.0, 0.0 };
    double rate[HULL_FREEDOMS] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    double half_s[3];
    double half_c[3];
    double s[2];
    double c[2];
    const double north = bs_cos(motion->heading);
    const double east = bs_sin(motion->heading);
    for (size_t k = 0U; k < motion->count; ++k) {
        const double(*const part)[2] = motion->amplitude[k];
        double sine;
        double cosine;
        bs_sincos(motion->omega[k] * time, &sine, &cosine);
        for (int i = 0; i < HULL_FREEDOMS; ++i) {
            rate[i] = rate[i] - (motion->omega[k] * ((part[i][0] * sine) + (part[i][1] * cosine)));
        }
        for (int i = 0; i < 3; ++i) {
            angle[i] = angle[i] + ((part[HULL_ROLL + i][0] * cosine) - (part[HULL_ROLL + i][1] * sine));
        }
    }
    angle[2] = angle[2] + motion->heading;
    const double forward = rate[HULL_SURGE] + motion->speed;
    v_n[0] = (forward * north) - (rate[HULL_SWAY] * east);
    v_n[1] = (forward * east) + (rate[HULL_SWAY] * north);
    v_n[2] = rate[HULL_HEAVE];
    for (int i = 0; i < 3; ++i) {
        bs_sincos(angle[i] / 2.0, &half_s[i], &half_c[i]);
    }
    for (int i = 0; i < 2; ++i) {
        bs_sincos(angle[i], &s[i], &c[i]);
    }
    const double roll[4] = { half_c[0], half_s[0], 0.0, 0.0 };
    const double pitch[4] = { half_c[1], 0.0, half_s[1], 0.0 };
    const double yaw[4] = { half_c[2], 0.0, 0.0, half_s[2] };
    double both[4];
    hull_product(yaw, pitch, both);
    hull_product(both, roll, q_m2n);
    const double level = rate[HULL_YAW] * c[1]; /* yaw's part across the roll axis */
    rate_m[0] = rate[HULL_ROLL] - (rate[HULL_YAW] * s[1]);
    rate_m[1] = (rate[HULL_PITCH] * c[0]) + (level * s[0]);
    rate_m[2] = (level * c[0]) - (rate[HULL_PITCH] * s[0]);
}

/* hull.carried: the same of a slave, lever_b from the master to it in its own axes (m), mounted by q_b2m. */
static inline void hull_carry(const double lever_b[3], const double q_b2m[4], const double rate_m[3], double v_n[3],
                              double q[4])
{
    const double q_m2n[4] = { q[0], q[1], q[2], q[3] };
    double lever_m[3];
    double turning[3];
    double more[3];
    hull_turned(q_b2m, lever_b, lever_m);
    hull_cross(rate_m, lever_m, turning);
    hull_turned(q_m2n, turning, more);
    for (int i = 0; i < 3; ++i) {
        v_n[i] = v_n[i] + more[i];
    }
    hull_product(q_m2n, q_b2m, q);
}
#endif
#endif

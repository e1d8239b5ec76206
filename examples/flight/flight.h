/* flight.h - transfer alignment in flight: what runs at each tick of the slave, and what a message of the master does.
 *
 * The slave ticks at 400 Hz.  The covariance is carried every FLIGHT_EVERY ticks, 50 Hz, and up to date before a message.
 * The master's messages are late.  The slave's last ticks are kept, and a message is held against the tick that is
 * nearest to when the master is believed to have measured; what is left, half a tick, is the model's `lag`. */
#ifndef FLIGHT_H
#define FLIGHT_H

#include "velocity_attitude_filter.h"

enum {
    FLIGHT_PAST = 64,  /* ticks kept, a power of two: 160 ms */
    FLIGHT_HALF = 4,   /* ticks: a rate is the mean over twice this, a rate of change the difference over as much */
    FLIGHT_EVERY = 8   /* ticks for one step of the covariance */
};
#define FLIGHT_ASTRAY 5U /* messages in a row with a row of the same measurement beyond the gate, after which the flight begins anew */
#define FLIGHT_GATE BS_REAL(6.0) /* sigmas beyond which a row of a message is left out */

/* What is known beforehand, as it stands in a recording: doubles alone. */
typedef struct {
    double dt;                  /* s, one tick */
    double lever_b[3];          /* m, from the master to the slave, in the slave's axes */
    double gyro_noise;          /* rad/sqrt(s) */
    double accel_noise;         /* m/s/sqrt(s) */
    double velocity_sigma;      /* m/s, of the master's messages */
    double attitude_sigma;      /* rad */
    double mounting_sigma[3];   /* rad, about the master's axes; the mounting is believed to be straight */
    double start_angle_sigma;   /* rad, by which the first message's attitude is old */
    double start_velocity_sigma; /* m/s, that and the lever arm's velocity */
    double gyro_bias_sigma;     /* rad/s */
    double accel_bias_sigma;    /* m/s^2 */
    double tau_sigma;           /* s, of the delay, which is believed to be zero */
} flight_setup;

/* One message, as it stands in a recording. */
typedef struct {
    double waited; /* s, from its arrival to the tick that takes it */
    double position[3];
    double v_m_n[3];
    double q_m2n_wxyz[4];
} flight_message;

typedef struct {
    bs_real v_n[3];
    bs_real q_b2n_wxyz[4];
    bs_real dtheta[3]; /* of the interval that ends here, biases in it */
    bs_real dv[3];
} flight_tick;

typedef struct {
    flight_setup setup;
    va_noise noise;
    va_mounting mounting;
    va_filter filter;
    flight_tick past[FLIGHT_PAST];
    unsigned int newest;  /* where in past */
    int fresh;            /* ticks since the last correction, which those before it did not get; below FLIGHT_PAST */
    int behind;           /* ticks that the covariance has to be carried */
    int flying;           /* the first message has come */
    unsigned int begun;
    unsigned int taken, in_part, refused; /* messages */
    unsigned int held; /* ticks whose increments were no numbers, or beyond the model's range */
    bs_real dense[VA_N_STATES * VA_N_STATES];
} flight;

/* What is worth a line. */
typedef struct {
    double heading_deg, heading_sigma_mil;
    double misalignment_deg[3]; /* rotation vector of the mounting, in the master's axes */
    double delay_ms, delay_sigma_ms;
} flight_line;

void flight_begin(flight *f, const flight_setup *setup);

/* One interval of the slave.
 * returns BS_OK; BS_NOT_READY before the first message; else why the increments were refused: those before are used
 * again, and if they too are refused, or the covariance, the flight waits for a message to begin anew */
bs_status flight_slave(flight *f, const double dtheta[3], const double dv[3]);

/* One message, behind the tick that takes it.  The first one begins the flight.
 * returns BS_OK; BS_NOT_READY: less than 4 FLIGHT_HALF ticks since the last one; else why it, or a part of it, was
 * refused: the flight goes on with the rest.  If the filter is no longer sound, the next message begins anew. */
bs_status flight_master(flight *f, const flight_message *message);

/* returns BS_OK; BS_NOT_READY before the first message; or why there are no sigmas, and nothing is written */
bs_status flight_report(flight *f, flight_line *line);

#endif

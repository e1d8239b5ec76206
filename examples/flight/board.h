/* board.h - a recording, and what its flight asks of the machine: host.c, or cortex_m.c. */
#ifndef BOARD_H
#define BOARD_H

#include "velocity_attitude_live.h"

typedef struct { /* what is known beforehand */
    double dt;                                         /* s, one sample */
    double lever_b[3];                                 /* m, from the master to the slave */
    double gyro_noise[3], accel_noise[3];              /* rad/sqrt(s), m/s/sqrt(s) */
    double velocity_variance[3], attitude_variance[3]; /* (m/s)^2, rad^2, of the messages */
    double sigma[VA_N_STATES];                         /* at the start */
} flight_head;

typedef struct {
    double kind; /* 0 a sample of the slave, 1 a message of the master */
    double at;   /* us of the slave's clock: the end of the interval, or when it arrived */
    union {
        struct { double dtheta[3], dv[3]; } sample;
        struct { double position[3], v_m_n[3], q_m2n_wxyz[4]; } message;
    } of;
} flight_record;

extern flight_head head;
extern va_live aboard;

void take(const flight_record *record);

/* After the last sample of a second: the flight, and what has happened.  At the end: the counts and
 * the digest. */
void report(const flight_record *record);
void report_end(void);

/* Hand a sample to the sensors' interrupt; while there is no room for it, the background runs. */
void board_sample(const va_sample *sample);

/* Run the background until the interrupt has taken every sample. */
void board_wait(void);

#endif

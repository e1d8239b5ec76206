/* two.h - what both halves exchange: plain doubles, no type of either export. */
#ifndef TWO_H
#define TWO_H

enum { ERRORS = 15 };

/* As ah_nav: rad and m, m/s in ENU, body to ENU, rad/s, m/s^2. */
typedef struct {
    double lon_lat_height[3];
    double v_n[3];
    double q_b2n_wxyz[4];
    double gyro_bias[3];
    double accel_bias[3];
} navigation;

/* navigation.c, in double.  Increments over dt of a body at rest, as large as those of the step before.
 * Both return a bs_status. */
int navigation_step(navigation *nav, const double dtheta[3], const double dv[3], double dt);
int navigation_correct(navigation *nav, const double x[ERRORS]);
const char *navigation_identity(void);

/* errors.c, in float.  All return a bs_status; errors_at_rest gives the errors that it has found in x, and the
 * sigma of the velocity to the east. */
int errors_begin(const navigation *nav);
int errors_step(const navigation *nav, const double omega_ib_b[3], const double f_b[3], double dt);
int errors_at_rest(const navigation *nav, double x[ERRORS], double *sigma);
const char *errors_identity(void);

#endif

/* errors.c - the half that sees the export in float: the errors and their covariance as UD factors. */
#include "two.h"

#include <math.h>

#include "azimuth_hold_filter.h"

static ah_filter filter;

static void narrow(const double *from, bs_real *to, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = (bs_real)from[i];
    }
}

static ah_nav as_ah(const navigation *nav)
{
    ah_nav made;
    narrow(nav->lon_lat_height, made.lon_lat_height, 3);
    narrow(nav->v_n, made.v_n, 3);
    narrow(nav->q_b2n_wxyz, made.q_b2n_wxyz, 4);
    narrow(nav->gyro_bias, made.gyro_bias, 3);
    narrow(nav->accel_bias, made.accel_bias, 3);
    return made;
}

int errors_begin(const navigation *nav)
{
    /* of position, velocity, attitude, gyro and accelerometer biases; rad, m, m/s, rad/s, m/s^2 */
    static const bs_real sigma[ERRORS] = { 1e-7F, 1e-7F, 1.0F,  0.1F,  0.1F,  0.1F,  1e-3F, 1e-3F,
                                           1e-2F, 1e-5F, 1e-5F, 1e-5F, 1e-2F, 1e-2F, 1e-2F };
    const ah_nav start = as_ah(nav);
    return (int)ah_filter_init_sigmas(&filter, &start, sigma);
}

int errors_step(const navigation *nav, const double omega_ib_b[3], const double f_b[3], double dt)
{
    static const ah_noise noise = { { 1e-6F, 1e-6F, 1e-6F }, { 1e-4F, 1e-4F, 1e-4F }, { 0.0F, 0.0F, 0.0F }, { 0.0F, 0.0F, 0.0F } };
    ah_corrected_imu imu;
    narrow(f_b, imu.f_b, 3);
    narrow(omega_ib_b, imu.omega_ib_b, 3);
    imu.dt = (bs_real)dt;
    filter.nav = as_ah(nav); /* what the errors are of is carried in double */
    return (int)ah_filter_propagate(&filter, &imu, &noise);
}

int errors_at_rest(const navigation *nav, double x[ERRORS], double *sigma)
{
    static const bs_real R[3] = { 1e-4F, 1e-4F, 1e-4F };
    ah_innovation innovation;
    bs_real variance;
    bs_status status;
    filter.nav = as_ah(nav);
    status = ah_filter_measure_zupt(&filter, R, NULL, &innovation);
    if (status == BS_OK) {
        status = ah_filter_variance(&filter, AH_IX_DV_E, &variance);
    }
    if (status == BS_OK) {
        for (int i = 0; i < ERRORS; ++i) {
            x[i] = (double)filter.x[i];
            filter.x[i] = 0.0F; /* the navigation is corrected by it */
        }
        *sigma = sqrt((double)variance);
    }
    return (int)status;
}

const char *errors_identity(void)
{
    return ah_identity();
}

/* navigation.c - the half that sees the export in double: position to a micrometre. */
#include "two.h"

#include "azimuth_hold.h"

static void copy(const double *from, double *to, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = from[i];
    }
}

static ah_nav as_ah(const navigation *nav)
{
    ah_nav made;
    copy(nav->lon_lat_height, made.lon_lat_height, 3);
    copy(nav->v_n, made.v_n, 3);
    copy(nav->q_b2n_wxyz, made.q_b2n_wxyz, 4);
    copy(nav->gyro_bias, made.gyro_bias, 3);
    copy(nav->accel_bias, made.accel_bias, 3);
    return made;
}

int navigation_step(navigation *nav, const double dtheta[3], const double dv[3], double dt)
{
    const ah_nav before = as_ah(nav);
    ah_corrected_imu imu = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, 0.0 };
    ah_increments increments;
    imu.dt = dt;
    copy(dtheta, increments.dtheta_ib_b, 3);
    copy(dv, increments.dv_b, 3);
    copy(dtheta, increments.dtheta_before, 3);
    copy(dv, increments.dv_before, 3);
    return (int)ah_strapdown(&before, &imu, &increments, nav->lon_lat_height, nav->v_n, nav->q_b2n_wxyz);
}

int navigation_correct(navigation *nav, const double x[ERRORS])
{
    const ah_nav before = as_ah(nav);
    return (int)ah_feedback(x, &before, nav->lon_lat_height, nav->v_n, nav->q_b2n_wxyz, nav->gyro_bias, nav->accel_bias);
}

const char *navigation_identity(void)
{
    return ah_identity();
}

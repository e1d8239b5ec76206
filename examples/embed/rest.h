/* rest.h - what each of these examples flies: the strapdown at rest for a second, 100 steps of 10 ms. */
#ifndef REST_H
#define REST_H

#include "strapdown.h"

/* returns 0 where the arithmetic is as it is written, each step answers, and nothing has moved by a metre per second */
static inline int rest(void)
{
    sd_nav nav = { { 0 }, { 0 }, { 0 } };
    sd_nav next = nav;
    sd_imu imu = { { 0 }, { 0 }, { 0 }, { 0 }, 0 };
    bs_status status = bs_probe();
    nav.lon_lat_height[1] = BS_REAL(0.8);
    nav.q_b2n_wxyz[0] = BS_REAL(1.0); /* body axes east, north, up */
    imu.dt = BS_REAL(0.01);
    imu.dv_b[2] = BS_REAL(0.0981); /* m/s: what an accelerometer feels at rest */
    imu.dv_before[2] = imu.dv_b[2];
    for (int k = 0; (k < 100) && (status == BS_OK); ++k) {
        status = sd_step(&nav, &imu, next.lon_lat_height, next.v_n, next.q_b2n_wxyz);
        nav = next;
    }
    return ((status == BS_OK) && (BS_FABS(nav.v_n[2]) < BS_REAL(1.0))) ? 0 : 1;
}

#endif

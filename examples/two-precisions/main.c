/* main.c - a body at rest for a minute: navigation in double, its errors in float.
 * It sees neither export.  Exit status 0 if the body is found at rest. */
#include "two.h"

#include <math.h>
#include <stdio.h>

int main(void)
{
    const double dt = 0.01;
    const double latitude = 0.8;
    const double rate = 7.292115e-5;
    const double omega[3] = { 0.0, rate * cos(latitude), rate * sin(latitude) };
    const double force[3] = { 0.005, 0.0, 9.8090 }; /* with a bias to the east */
    navigation nav = { { 0.2, 0.8, 100.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    double x[ERRORS];
    double sigma = 0.0;
    int status = errors_begin(&nav);

    (void)printf("navigation: %s\nerrors:     %s\n", navigation_identity(), errors_identity());
    (void)printf("%4s %18s %14s %14s\n", "s", "longitude rad", "v east m/s", "sigma m/s");
    for (int k = 1; (k <= 6000) && (status == 0); ++k) {
        double dtheta[3];
        double dv[3];
        double f_b[3];
        for (int i = 0; i < 3; ++i) {
            f_b[i] = force[i] - nav.accel_bias[i];
            dtheta[i] = (omega[i] - nav.gyro_bias[i]) * dt;
            dv[i] = f_b[i] * dt;
        }
        status = navigation_step(&nav, dtheta, dv, dt);
        if ((status == 0) && ((k % 10) == 0)) {
            status = errors_step(&nav, omega, f_b, 10.0 * dt);
        }
        if ((status == 0) && ((k % 100) == 0)) {
            status = errors_at_rest(&nav, x, &sigma);
            if (status == 0) {
                status = navigation_correct(&nav, x);
            }
        }
        if ((status == 0) && ((k % 1000) == 0)) {
            (void)printf("%4d %18.14f %14.3e %14.3e\n", k / 100, nav.lon_lat_height[0], nav.v_n[0], sigma);
        }
    }
    (void)printf("status %d\n", status);
    return ((status == 0) && (fabs(nav.v_n[0]) < 4.0 * sigma)) ? 0 : 1;
}

/* float_covariance.c - the time loops of the study float-covariance, around the generated C of azimuth-hold.
 * Compiled once in double and once with BORESIGHT_FLOAT.  What comes in and goes out is double; the covariance, the
 * transition, the gain and the estimate are bs_real.
 * The forms that are not shipped, from the textbook and over full matrices, are written out here. */
#include "azimuth_hold_filter.h"

enum {
    N = AH_N_STATES,
    MOTION = 13, /* position, v_n, q_b2n_wxyz, f_b */
    ROWS = 4     /* velocity e, n, u; azimuth */
};

enum { UD = 0, JOSEPH = 1, JOSEPH_EXPANDED = 2, SYMMETRIZED = 3, STANDARD = 4 };

static const unsigned short STATE_OF_ROW[ROWS] = { AH_IX_DV_E, AH_IX_DV_N, AH_IX_DV_U, AH_IX_PHI_U };
static const bs_real ONE[1] = { BS_REAL(1.0) };

typedef struct {
    bs_real F[AH_N_F];
    bs_real Qc[AH_N_QC];
    bs_real Phi[AH_N_PHI];
    bs_real Q[AH_N_PACKED];
    bs_real work[AH_N_WORK];
} scratch;

/* Carries an error of the navigation over one step; in the study the one that was compiled in double. */
typedef void carrier(const double motion[MOTION], const double noise[12], double dt, double e[N]);

static void convert(const double *from, bs_real *to, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = (bs_real)from[i];
    }
}

static void copy(const bs_real *from, bs_real *to, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = from[i];
    }
}

static bs_status transition(const double motion[MOTION], const double noise[12], double dt, scratch *s)
{
    ah_nav nav = { { 0 }, { 0 }, { 0 }, { 0 }, { 0 } };
    ah_corrected_imu imu = { { 0 }, { 0 }, 0 };
    ah_noise density;
    bs_status status;
    convert(motion, nav.lon_lat_height, 3);
    convert(&motion[3], nav.v_n, 3);
    convert(&motion[6], nav.q_b2n_wxyz, 4);
    convert(&motion[10], imu.f_b, 3);
    convert(noise, density.gyro_noise, 3);
    convert(&noise[3], density.accel_noise, 3);
    convert(&noise[6], density.gyro_bias_noise, 3);
    convert(&noise[9], density.accel_bias_noise, 3);
    status = ah_F_nz(&nav, &imu, s->F);
    if (status == BS_OK) {
        status = ah_Qc_nz(&nav, &density, s->Qc);
    }
    if (status == BS_OK) {
        ah_discretize(s->F, s->Qc, (bs_real)dt, s->Phi, s->Q, s->work);
    }
    return status;
}

void carry(const double motion[MOTION], const double noise[12], double dt, double e[N]);
void carry(const double motion[MOTION], const double noise[12], double dt, double e[N])
{
    scratch s;
    bs_real x[N];
    convert(e, x, N);
    if (transition(motion, noise, dt, &s) == BS_OK) {
        ah_predict_state(s.Phi, x);
        for (int i = 0; i < N; ++i) {
            e[i] = (double)x[i];
        }
    }
}

/* P = Phi P Phi' + Q over full matrices: Phi times each column, and then times each row. */
static void full_predict(bs_real P[N * N], const scratch *s)
{
    bs_real Q[N * N];
    bs_real along[N];
    ah_joseph_dense(s->Q, Q);
    for (int j = 0; j < N; ++j) {
        for (int i = 0; i < N; ++i) {
            along[i] = P[(i * N) + j];
        }
        ah_predict_state(s->Phi, along);
        for (int i = 0; i < N; ++i) {
            P[(i * N) + j] = along[i];
        }
    }
    for (int i = 0; i < N; ++i) {
        ah_predict_state(s->Phi, &P[i * N]);
        for (int j = 0; j < N; ++j) {
            P[(i * N) + j] += Q[(i * N) + j];
        }
    }
}

/* One scalar measurement of a single state over the full matrix, by the textbook. */
static void full_update(int form, bs_real P[N * N], bs_real x[N], bs_row *row)
{
    const int k = row->at[0];
    bs_real g[N]; /* P h */
    bs_real K[N];
    row->nu = row->z - x[k];
    row->S = P[k * (N + 1)] + row->R;
    for (int i = 0; i < N; ++i) {
        g[i] = P[(i * N) + k];
        K[i] = g[i] / row->S;
        x[i] += K[i] * row->nu;
    }
    if (form == JOSEPH_EXPANDED) { /* (I - K h') P (I - K h')' + K R K', multiplied out */
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j < N; ++j) {
                P[(i * N) + j] = (P[(i * N) + j] - ((K[i] * g[j]) + (g[i] * K[j]))) + (row->S * (K[i] * K[j]));
            }
        }
        return;
    }
    bs_real across[N];
    for (int j = 0; j < N; ++j) {
        across[j] = P[(k * N) + j];
    }
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j < N; ++j) {
            P[(i * N) + j] -= K[i] * across[j];
        }
    }
    if (form == SYMMETRIZED) {
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j < i; ++j) {
                const bs_real mean = BS_REAL(0.5) * (P[(i * N) + j] + P[(j * N) + i]);
                P[(i * N) + j] = mean;
                P[(j * N) + i] = mean;
            }
        }
    }
}

/* The covariance over `steps` steps of `dt`, updated after every `update_every`, and, if e is given, the estimate.
 * in   motion: MOTION numbers a step; noise: root densities; sigma: at the start; R: a row's variance, 0 leaves it out
 *      drawn: what the noise adds to the error in a step, N numbers a step; seen: errors of the measurement, ROWS an update
 *      carry: how the error goes over a step
 * out  packed: after each update the numbers that carry the covariance, N N of them (UD and JOSEPH fill AH_N_PACKED)
 *      least: the smallest D, or the smallest variance, in all steps since the update before
 *      e: N numbers, the error at the start, in; left: N numbers an update, the error that is left after the feedback
 * returns the first update that was refused, counted from 1, or 0; less than 0 for a start or a motion that was refused */
int fly(int form, int steps, int update_every, double dt, const double *motion, const double noise[12],
        const double sigma[N], const double R[ROWS], const double *drawn, const double *seen, carrier *carry_e,
        double *packed, double *least, double *e, double *left);
int fly(int form, int steps, int update_every, double dt, const double *motion, const double noise[12],
        const double sigma[N], const double R[ROWS], const double *drawn, const double *seen, carrier *carry_e,
        double *packed, double *least, double *e, double *left)
{
    const int shipped = (form == UD) || (form == JOSEPH);
    const int numbers = shipped ? (int)AH_N_PACKED : (N * N);
    int refused = 0;
    int updates = 0;
    scratch s;
    bs_real P[N * N] = { 0 };
    bs_real start[N * N] = { 0 };
    bs_real x[N] = { 0 };
    double smallest = 1e300;
    for (int i = 0; i < N; ++i) {
        start[i * (N + 1)] = (bs_real)(sigma[i] * sigma[i]);
        P[i * (N + 1)] = shipped ? BS_REAL(0.0) : start[i * (N + 1)];
    }
    if ((form == UD) && (ah_ud_init(start, P, s.work) != BS_OK)) {
        return -1;
    }
    if ((form == JOSEPH) && (ah_joseph_init(start, P, s.work) != BS_OK)) {
        return -1;
    }
    for (int step = 1; step <= steps; ++step) {
        const double *const now = &motion[(step - 1) * MOTION];
        if (transition(now, noise, dt, &s) != BS_OK) {
            return -2;
        }
        if (form == UD) {
            ah_ud_predict(P, s.Phi, s.Q, s.Q, s.work);
            copy(s.Q, P, AH_N_PACKED);
        } else if (form == JOSEPH) {
            ah_joseph_predict(P, s.Phi, s.Q, s.Q, s.work);
            copy(s.Q, P, AH_N_PACKED);
        } else {
            full_predict(P, &s);
        }
        if (e != 0) {
            carry_e(now, noise, dt, e);
            for (int i = 0; i < N; ++i) {
                e[i] += drawn[((step - 1) * N) + i];
            }
        }
        if ((step % update_every) == 0) {
            for (int k = 0; k < (int)ROWS; ++k) {
                bs_row row = { ONE, &STATE_OF_ROW[k], 1, 0, (bs_real)R[k], 0, 0, 0, 1, 0 };
                bs_status status = BS_OK;
                if (e != 0) { /* the innovation is a difference of two numbers in double, and then small */
                    row.z = (bs_real)(e[STATE_OF_ROW[k]] + seen[(updates * ROWS) + k]);
                }
                if (R[k] <= 0.0) {
                    continue;
                }
                if (form == UD) {
                    status = ah_ud_update(P, x, &row);
                } else if (form == JOSEPH) {
                    status = ah_joseph_update(P, x, &row);
                } else {
                    full_update(form, P, x, &row);
                    status = (row.S > BS_REAL(0.0)) ? BS_OK : BS_NOT_POSITIVE;
                }
                if ((status != BS_OK) && (refused == 0)) {
                    refused = updates + 1;
                }
            }
        }
        for (int i = 0; i < N; ++i) {
            const double value = (double)P[shipped ? (((i * (i + 1)) / 2) + i) : (i * (N + 1))];
            smallest = ((value < smallest) || !(value <= 1e300)) ? value : smallest; /* NaN becomes the smallest, and stays */
        }
        if ((step % update_every) == 0) {
            for (int i = 0; i < numbers; ++i) {
                packed[(updates * N * N) + i] = (double)P[i];
            }
            for (int i = 0; (e != 0) && (i < N); ++i) {
                e[i] -= (double)x[i]; /* fed back to a navigation in double */
                x[i] = BS_REAL(0.0);
                left[(updates * N) + i] = e[i];
            }
            least[updates] = smallest;
            smallest = 1e300;
            ++updates;
        }
    }
    return refused;
}

/* Navigation in double, compiled in double: a step of the strapdown and the feedback of the filter.  Its numbers are
 * those of ah_nav: position, v_n, q_b2n_wxyz, gyro_bias, accel_bias. */
enum { NAV = 16, VELOCITY = 3, ATTITUDE = 6, GYRO_BIAS = 10, ACCEL_BIAS = 13 };

typedef bs_status stepper(const double nav[10], const double imu[13], double position[3], double v_n[3], double q[4]);
typedef bs_status corrector(const double x[N], const double nav[NAV], double position[3], double v_n[3], double q[4],
                            double gyro_bias[3], double accel_bias[3]);

static void tell(const double nav[NAV], ah_nav *told)
{
    convert(nav, told->lon_lat_height, 3);
    convert(&nav[VELOCITY], told->v_n, 3);
    convert(&nav[ATTITUDE], told->q_b2n_wxyz, 4);
    convert(&nav[GYRO_BIAS], told->gyro_bias, 3);
    convert(&nav[ACCEL_BIAS], told->accel_bias, 3);
}

/* The whole filter beside a strapdown: predicted every `predict_every` steps of dt, updated every `update_every`.
 * in   increments: dtheta and dv with their errors, 6 numbers a step; noise, sigma, R as above; q_ref of the azimuth;
 *      in_float: whether position, velocity and attitude are kept in single precision from one step to the next
 * in, out  nav
 * out  kept: nav after each update; P: N N numbers after each update
 * returns 0, or the step at which something was refused */
int navigate(int steps, int predict_every, int update_every, double dt, const double *increments, const double noise[12],
             const double sigma[N], const double R[ROWS], const double q_ref[4], int in_float, stepper *step_nav,
             corrector *correct_nav, double nav[NAV], double *kept, double *P);
int navigate(int steps, int predict_every, int update_every, double dt, const double *increments, const double noise[12],
             const double sigma[N], const double R[ROWS], const double q_ref[4], int in_float, stepper *step_nav,
             corrector *correct_nav, double nav[NAV], double *kept, double *P)
{
    ah_filter filter;
    double before[6] = { 0 };
    double dv_sum[3] = { 0 };
    int updates = 0;
    ah_nav start;
    ah_corrected_imu imu = { { 0 }, { 0 }, 0 };
    ah_noise density;
    ah_reference reference;
    bs_real dense[N * N] = { 0 };
    bs_real variance[ROWS];
    bs_status status;
    convert(noise, density.gyro_noise, 3);
    convert(&noise[3], density.accel_noise, 3);
    convert(&noise[6], density.gyro_bias_noise, 3);
    convert(&noise[9], density.accel_bias_noise, 3);
    convert(q_ref, reference.q_ref_wxyz, 4);
    convert(R, variance, ROWS);
    for (int i = 0; i < N; ++i) {
        dense[i * (N + 1)] = (bs_real)(sigma[i] * sigma[i]);
    }
    tell(nav, &start);
    status = ah_filter_init(&filter, &start, dense);
    for (int step = 1; (step <= steps) && (status == BS_OK); ++step) {
        double now[13];
        double next[NAV] = { 0 };
        for (int i = 0; i < 3; ++i) {
            now[i] = increments[((step - 1) * 6) + i] - (nav[GYRO_BIAS + i] * dt);
            now[3 + i] = increments[((step - 1) * 6) + 3 + i] - (nav[ACCEL_BIAS + i] * dt);
            dv_sum[i] += now[3 + i];
        }
        for (int i = 0; i < 6; ++i) {
            now[6 + i] = (step > 1) ? before[i] : now[i];
        }
        now[12] = dt;
        for (int i = 0; i < 6; ++i) {
            before[i] = now[i];
        }
        status = step_nav(nav, now, next, &next[VELOCITY], &next[ATTITUDE]);
        for (int i = 0; i < (int)GYRO_BIAS; ++i) {
            nav[i] = in_float ? (double)(float)next[i] : next[i];
        }
        if ((status == BS_OK) && ((step % predict_every) == 0)) {
            tell(nav, &filter.nav);
            imu.dt = (bs_real)(dt * predict_every);
            for (int i = 0; i < 3; ++i) {
                imu.f_b[i] = (bs_real)(dv_sum[i] / (dt * predict_every));
                dv_sum[i] = 0.0;
            }
            status = ah_filter_propagate(&filter, &imu, &density);
        }
        if ((status == BS_OK) && ((step % update_every) == 0)) {
            ah_innovation innovation;
            double x[N];
            tell(nav, &filter.nav);
            status = ah_filter_measure_zupt(&filter, variance, NULL, &innovation);
            if (status == BS_OK) {
                status = ah_filter_measure_azimuth(&filter, &reference, &variance[3], NULL, &innovation);
            }
            for (int i = 0; i < N; ++i) { /* the filter's own correction would do this in bs_real */
                x[i] = (double)filter.x[i];
                filter.x[i] = BS_REAL(0.0);
            }
            if (status == BS_OK) {
                status = correct_nav(x, nav, next, &next[VELOCITY], &next[ATTITUDE], &next[GYRO_BIAS], &next[ACCEL_BIAS]);
            }
            for (int i = 0; i < (int)NAV; ++i) {
                nav[i] = next[i];
                kept[(updates * NAV) + i] = next[i];
            }
            (void)ah_filter_covariance(&filter, dense);
            for (int i = 0; i < (N * N); ++i) {
                P[(updates * N * N) + i] = (double)dense[i];
            }
            ++updates;
        }
        if (status != BS_OK) {
            return step;
        }
    }
    return (status == BS_OK) ? 0 : -1;
}

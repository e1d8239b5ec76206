/* many.c - one run of `boresight many`: a slave's filter at sea from its start to its final errors, in the C of
 * velocity-attitude.  Operation by operation the same as many.py and matching.py, which fly many runs side by side. */
#include "sea.h"

#define MIL 0.0009817477042468104 /* rad */

enum { MOST_SPAN = 16, FEW = 20 };

/* A run as it flies. */
typedef struct {
    const common *all;
    const sea *true_;
    const double *master;
    const double *ideal;
    uint64_t seed;
    uint64_t run;
    size_t updates;
    size_t samples;
    double weight[NODES]; /* of the master's poses, for this run's delay */
    double delay;
    double nis;
    double drawn[DRAWN * ALL]; /* samples, in each the components from the last to the first */
    va_increments increments;
    double recent[2 * MOST_SPAN * ALL]; /* samples at the end of an update, from the newest on */
    double few[3][FEW];                 /* forces of some samples, so many apart, from the newest on */
    size_t spacing;
    size_t n_few;
    size_t left; /* of the few, still to come in this update */
    bs_real P[VA_N_STATES * VA_N_STATES]; /* at the start, and at the end */
    va_filter filter;
} flight;

static double sum(double *value, size_t n)
{
    while (n > 1U) {
        const size_t half = n / 2U;
        const double last = value[2U * half < n ? 2U * half : 0U];
        for (size_t i = 0U; i < half; ++i) {
            value[i] = value[i] + value[half + i];
        }
        if ((n % 2U) != 0U) {
            value[0] = value[0] + last;
        }
        n = half;
    }
    return value[0];
}

/* e' P^-1 e by P = L D L'; below the diagonal P becomes L. */
static double nees(double P[VA_N_STATES * VA_N_STATES], const double error[VA_N_STATES])
{
    double y[VA_N_STATES];
    double total = 0.0;
    for (int j = 0; j < VA_N_STATES; ++j) {
        double d = P[(j * VA_N_STATES) + j];
        y[j] = error[j];
        for (int k = 0; k < j; ++k) {
            const double l = P[(j * VA_N_STATES) + k];
            d = d - ((l * l) * P[(k * VA_N_STATES) + k]);
            y[j] = y[j] - (l * y[k]);
        }
        P[(j * VA_N_STATES) + j] = d;
        for (int i = j + 1; i < VA_N_STATES; ++i) {
            double l = P[(i * VA_N_STATES) + j];
            for (int k = 0; k < j; ++k) {
                l = l - ((P[(i * VA_N_STATES) + k] * P[(j * VA_N_STATES) + k]) * P[(k * VA_N_STATES) + k]);
            }
            P[(i * VA_N_STATES) + j] = l / d;
        }
        total = total + ((y[j] * y[j]) / d);
    }
    return total;
}

/* The columns of a run that has ended: errors, sigmas, the heading's error, NEES, NIS. */
static void finish(const va_nav *nav, const bs_real P[VA_N_STATES * VA_N_STATES], const sea *true_, double delay,
                   double nis, double row[])
{
    double *const sigma = &row[VA_N_STATES];
    double dense[VA_N_STATES * VA_N_STATES];
    attitude_error(nav->q_b2n_wxyz, true_->q_b2n, &row[0]);
    for (int i = 0; i < 3; ++i) {
        row[3 + i] = (double)nav->v_n[i] - true_->v_n[i];
    }
    widen(nav->gyro_bias, &row[6], 3);
    widen(nav->accel_bias, &row[9], 3);
    attitude_error(nav->q_b2m_wxyz, true_->q_b2m, &row[12]);
    row[15] = (double)nav->tau - delay;
    for (int i = 0; i < VA_N_STATES; ++i) {
        sigma[i] = sqrt((double)P[(i * VA_N_STATES) + i]);
    }
    widen(P, dense, VA_N_STATES * VA_N_STATES);
    row[32] = ((row[2] < 0.0) ? -row[2] : row[2]) / MIL;
    row[33] = nees(dense, row);
    row[34] = nis;
}

/* The delay, the biases and the first report; the filter begins. */
static bs_status begin(flight *f)
{
    va_nav nav;
    f->delay = sea_begin(f->all, f->true_, f->master, f->seed, f->run, f->weight, &nav);
    convert(f->true_->P, f->P, VA_N_STATES * VA_N_STATES);
    return va_filter_init(&f->filter, &nav, f->P);
}

/* The next sample, noise and all, and the strapdown over it. */
static bs_status strap(flight *f, size_t update, size_t i)
{
    const common *const all = f->all;
    const size_t k = (update * f->samples) + i;
    const size_t old = (f->samples - 1U) - i; /* samples behind it in this update */
    const size_t step = f->spacing;
    va_corrected_imu imu = { { 0 }, { 0 }, 0 };
    va_increments *const increments = &f->increments;
    const double *const sample = sea_sample(all, f->ideal, f->seed, f->run, k, f->drawn);
    for (int c = 0; c < 3; ++c) {
        increments->dtheta_before[c] = increments->dtheta_ib_b[c];
        increments->dv_before[c] = increments->dv_b[c];
    }
    for (int c = 0; c < 3; ++c) {
        increments->dtheta_ib_b[c] = (bs_real)sample[5 - c];
        increments->dv_b[c] = (bs_real)sample[2 - c];
    }
    for (int c = 0; (c < 3) && (k == 0U); ++c) { /* nothing is known before the first */
        increments->dtheta_before[c] = increments->dtheta_ib_b[c];
        increments->dv_before[c] = increments->dv_b[c];
    }
    for (int c = 0; (c < ALL) && (old < (2U * (size_t)all->span)); ++c) {
        f->recent[(ALL * old) + (size_t)c] = sample[5 - c];
    }
    if ((f->left > 0U) && (old == ((step / 2U) + ((f->left - 1U) * step)))) {
        --f->left;
        for (int c = 0; c < 3; ++c) {
            f->few[c][f->left] = sample[2 - c];
        }
    }
    imu.dt = (bs_real)all->dt;
    return va_filter_strapdown(&f->filter, &imu, increments);
}

/* The covariance over the whole interval, with the mean of the force over it; half of its samples are still to come. */
static bs_status predict(flight *f, size_t update)
{
    const common *const all = f->all;
    const size_t half = f->samples / 2U;
    va_corrected_imu imu = { { 0 }, { 0 }, 0 };
    va_noise noise = { { 0 }, { 0 }, { 0 }, { 0 }, { 0 }, 0 };
    for (size_t n = 0U; n < f->n_few; ++n) {
        const size_t old = (f->spacing / 2U) + (n * f->spacing);
        if (old < (f->samples - half)) {
            const size_t k = ALL * ((update * f->samples) + ((f->samples - 1U) - old));
            double force[3];
            boresight_normals(f->seed, &f->run, 1U, SLAVE, k, 3U, force, 0, 1, all->walk, &f->ideal[k]);
            for (int c = 0; c < 3; ++c) {
                f->few[c][n] = force[2 - c];
            }
        }
    }
    for (int c = 0; c < 3; ++c) {
        imu.f_b[c] = (bs_real)((sum(f->few[c], f->n_few) / ((double)f->n_few * all->dt)) - f->filter.nav.accel_bias[c]);
    }
    imu.dt = (bs_real)((double)f->samples * all->dt);
    convert(all->gyro_noise, noise.gyro_noise, 3);
    convert(all->accel_noise, noise.accel_noise, 3);
    convert(all->mu_noise, noise.mu_noise, 3);
    return va_filter_propagate(&f->filter, &imu, &noise);
}

/* How the slave turns, and how its master is accelerated, by the last samples. */
static void moving(const flight *f, double omega[3], double a_n[3])
{
    const common *const all = f->all;
    const size_t span = (size_t)all->span;
    const double length = all->span * all->dt;
    double change[ALL];
    double rates[ALL];
    double alpha[3];
    double force[3];
    double across[3];
    double twice[3];
    double q[4];
    for (size_t i = 0U; i < ALL; ++i) {
        double later[MOST_SPAN];
        double earlier[MOST_SPAN];
        for (size_t k = 0U; k < span; ++k) {
            later[k] = f->recent[(ALL * k) + i];
            earlier[k] = f->recent[(ALL * (span + k)) + i];
        }
        const double last = sum(later, span) / length;
        change[i] = last - (sum(earlier, span) / length);
        rates[i] = last + (change[i] / 2.0);
    }
    for (int i = 0; i < 3; ++i) {
        omega[i] = rates[i] - (double)f->filter.nav.gyro_bias[i];
        force[i] = rates[3 + i] - (double)f->filter.nav.accel_bias[i];
        alpha[i] = change[i] / length;
    }
    hull_cross(alpha, all->lever, across);
    hull_cross(omega, all->lever, a_n);
    hull_cross(omega, a_n, twice);
    for (int i = 0; i < 3; ++i) {
        force[i] = (force[i] - across[i]) - twice[i];
    }
    widen(f->filter.nav.q_b2n_wxyz, q, 4);
    hull_turned(q, force, a_n);
    a_n[2] = a_n[2] + all->gravity;
}

/* Attitude and velocity of the master, and the correction. */
static bs_status match(flight *f, size_t update, double *nis)
{
    va_corrected_imu imu = { { 0 }, { 0 }, 0 };
    va_master master = { { 0 }, { 0 }, { 0 }, { 0 }, 0 };
    va_mounting mounting;
    va_innovation innovation;
    bs_real R[ALL];
    double omega[3];
    double a_n[3];
    double v[3];
    double q[4];
    moving(f, omega, a_n);
    sea_report(f->all, f->master, f->weight, f->seed, f->run, update, v, q);
    convert(omega, imu.omega_ib_b, 3);
    convert(a_n, master.a_n, 3);
    convert(v, master.v_m_n, 3);
    convert(q, master.q_m2n_wxyz, 4);
    convert(f->all->lever, mounting.lever_b, 3);
    convert(f->all->R, R, ALL);
    master.lag = f->filter.nav.tau;
    bs_status status = va_filter_measure_dcm(&f->filter, &imu, &master, &R[0], NULL, &innovation);
    if (bs_good(status)) {
        *nis = (double)innovation.nis;
        status = va_filter_measure_velocity(&f->filter, &imu, &mounting, &master, &R[3], NULL, &innovation);
    }
    if (bs_good(status)) {
        *nis = *nis + (double)innovation.nis;
        status = va_filter_correct(&f->filter);
    }
    return status;
}

/* From one update to the next. */
static bs_status fly(flight *f, size_t update)
{
    double nis = 0.0;
    bs_status status = BS_OK;
    f->left = f->n_few;
    for (size_t i = 0U; (i < f->samples) && (status == BS_OK); ++i) {
        if (i == (f->samples / 2U)) { /* in the middle, where the covariance is linearised */
            status = predict(f, update - 1U);
            status = bs_good(status) ? BS_OK : status;
        }
        if (status == BS_OK) {
            status = strap(f, update - 1U, i);
        }
    }
    if (status == BS_OK) {
        status = match(f, update, &nis);
    }
    if (update > (size_t)f->all->settled) {
        f->nis = f->nis + nis;
    }
    return status;
}

int boresight_run(const double *given, uint64_t seed, uint64_t run, double *row)
{
    static const va_increments nothing = { { 0 }, { 0 }, { 0 }, { 0 } };
    const common *const all = (const common *)given;
    const size_t updates = (size_t)all->updates;
    const size_t samples = (size_t)all->samples;
    const size_t head = sizeof(sea) / sizeof(double);
    const size_t pose = NODES * (updates + 1U) * PARTS;
    const size_t number = (size_t)((run / (uint64_t)all->together) % (uint64_t)all->seas);
    const double *const own = &given[(sizeof(common) / sizeof(double)) +
                                     (number * (head + pose + (updates * samples * ALL)))];
    flight f;
    f.all = all;
    f.true_ = (const sea *)own;
    f.master = &own[head];
    f.ideal = &own[head + pose];
    f.seed = seed;
    f.run = run;
    f.updates = updates;
    f.samples = samples;
    f.nis = 0.0;
    f.spacing = ((samples / 10U) > 1U) ? (samples / 10U) : 1U;
    f.n_few = (((samples - 1U) - (f.spacing / 2U)) / f.spacing) + 1U; /* 10 to 19 */
    f.increments = nothing;
    bs_status status = begin(&f);
    for (size_t update = 1U; (update <= updates) && bs_good(status); ++update) {
        status = fly(&f, update);
    }
    if (bs_good(status)) {
        status = va_filter_covariance(&f.filter, f.P);
    }
    if (bs_good(status)) {
        finish(&f.filter.nav, f.P, f.true_, f.delay, f.nis / (all->updates - all->settled), row);
        return (int)BS_OK;
    }
    for (int i = 0; i < 35; ++i) {
        row[i] = (double)NAN;
    }
    return (int)status;
}

/* The columns of n runs that were flown side by side: nav (n, 21) and P (n, 16, 16), and what is true of all. */
void sea_rows(size_t n, const bs_real *nav, const bs_real *P, const double *true_, const double *delay,
              const double *nis, double *rows);
void sea_rows(size_t n, const bs_real *nav, const bs_real *P, const double *true_, const double *delay,
              const double *nis, double *rows)
{
    const size_t each = VA_N_STATES * VA_N_STATES;
    for (size_t i = 0U; i < n; ++i) {
        finish((const va_nav *)&nav[i * (sizeof(va_nav) / sizeof(bs_real))], &P[i * each], (const sea *)true_, delay[i],
               nis[i], &rows[i * 35U]);
    }
}

/* hours.c - one run of the live loop in health, at sea: what many.c flies by the plain filter, message by message, and how
 * often each event comes. */
#include "sea.h"
#include "velocity_attitude_live.h"

enum { EVENTS = 20, EACH_US = 10000, LATE = 5 /* samples from an instant to its message */ };

/* All that the loop says by now, by code; `row` has the events, and behind them what was not taken. */
static void count_events(va_live *live, double row[])
{
    bs_event event;
    while (va_live_next_event(live, &event) == BS_OK) {
        row[event.code] = row[event.code] + 1.0;
    }
}

static void send(va_live *live, int64_t at, uint16_t measurement, double sigma, const double *v, const double *q,
                 const common *all)
{
    va_message message = {
        BS_LIVE_VERSION, sizeof(va_message), 0, BS_ALL_ROWS, 0, { 0 }, { { 0 } }, { { 0 }, { 0 }, { 0 }, { 0 }, 0 }
    };
    message.measurement = measurement;
    message.at = at;
    for (int i = 0; i < 3; ++i) {
        message.variance[i] = (bs_real)(sigma * sigma);
        message.mounting.lever_b[i] = (bs_real)all->lever[i];
        message.master.v_m_n[i] = (bs_real)v[i];
    }
    convert(q, message.master.q_m2n_wxyz, 4);
    (void)va_live_message(live, &message, NULL);
}

int boresight_run(const double *given, uint64_t seed, uint64_t run, double *row)
{
    const common *const all = (const common *)given;
    const sea *const true_ = (const sea *)&given[sizeof(common) / sizeof(double)];
    const double *const master = &given[(sizeof(common) + sizeof(sea)) / sizeof(double)];
    const size_t updates = (size_t)all->updates;
    const size_t samples = (size_t)all->samples;
    const double *const ideal = &master[NODES * (updates + 1U) * PARTS];
    static va_live live; /* one run at a time */
    va_live_rules rules;
    va_live_counts counts;
    va_carried carried;
    va_sample sample = { 0 };
    bs_real sigma[VA_N_STATES];
    bs_real P[VA_N_STATES * VA_N_STATES];
    double weight[NODES];
    double drawn[DRAWN * ALL];
    double v[3];
    double q[4];
    for (int i = 0; i < (EVENTS + 2); ++i) {
        row[i] = 0.0;
    }
    (void)sea_begin(all, true_, master, seed, run, weight, &carried.nav);
    convert(true_->P, P, VA_N_STATES * VA_N_STATES);
    for (int i = 0; i < VA_N_STATES; ++i) {
        sigma[i] = BS_REAL(1e-3);
    }
    bs_status status = va_live_defaults(&rules);
    convert(all->gyro_noise, rules.noise.gyro_noise, 3);
    convert(all->accel_noise, rules.noise.accel_noise, 3);
    convert(all->mu_noise, rules.noise.mu_noise, 3);
    if (status == BS_OK) {
        status = va_live_begin(&live, &rules, 0, &carried, sigma);
    }
    if (status == BS_OK) {
        status = va_live_set_covariance(&live, P);
    }
    for (size_t k = 0U; (k < (updates * samples)) && (status == BS_OK); ++k) {
        const double *const sensed = sea_sample(all, ideal, seed, run, k, drawn);
        sample.at = (int64_t)(k + 1U) * EACH_US;
        sample.serial = (uint32_t)k + 1U;
        sample.dt = (bs_real)all->dt;
        for (size_t c = 0U; c < 3U; ++c) {
            sample.dtheta_ib_b[c] = (bs_real)sensed[5U - c];
            sample.dv_b[c] = (bs_real)sensed[2U - c];
        }
        status = va_live_sample(&live, &sample);
        const size_t update = ((k + 1U) - LATE) / samples;
        if (((k + 1U) > samples) && ((((k + 1U) - LATE) % samples) == 0U)) {
            const int64_t at = (int64_t)(update * samples) * EACH_US;
            sea_report(all, master, weight, seed, run, update, v, q);
            send(&live, at, VA_MEASUREMENT_VELOCITY, all->velocity_noise, v, q, all);
            send(&live, at, VA_MEASUREMENT_DCM, all->attitude_noise, v, q, all);
        }
        while (va_live_background(&live) == BS_OK) {
        }
        count_events(&live, row);
    }
    if ((status == BS_OK) && (va_live_counted(&live, &counts) == BS_OK)) {
        row[EVENTS] = (double)counts.fate[BS_MSG_TAKEN];
        for (int i = BS_MSG_IN_PART; i < BS_MSG_FATES; ++i) {
            row[EVENTS + 1] = row[EVENTS + 1] + (double)counts.fate[i];
        }
    }
    return (int)status;
}

/* main.c - flies a recording: flight FILE.  What it prints: report.c.  Exit status 0 if it flew to
 * the end.  A recording is doubles, little-endian: a flight_head, then a flight_record each. */
#include <stdio.h>

#include "board.h"

va_live aboard;
flight_head head;

static void convert(bs_real *out, const double *in, int n)
{
    for (int i = 0; i < n; ++i) {
        out[i] = (bs_real)in[i];
    }
}

/* The slave is taken for as its master is, and the sigmas say how wrong that may be. */
static void begin(const flight_record *record, int64_t at)
{
    va_carried carried = { .nav = { .q_b2m_wxyz = { BS_REAL(1.0) } } };
    bs_real sigma[VA_N_STATES];
    va_live_rules rules;

    (void)va_live_defaults(&rules);
    rules.latency = 8U; /* samples: a measurement takes its time on a small core */
    convert(rules.noise.gyro_noise, head.gyro_noise, 3);
    convert(rules.noise.accel_noise, head.accel_noise, 3);
    convert(carried.nav.lat_lon_height, record->of.message.position, 3);
    convert(carried.nav.v_n, record->of.message.v_m_n, 3);
    convert(carried.nav.q_b2n_wxyz, record->of.message.q_m2n_wxyz, 4);
    convert(sigma, head.sigma, VA_N_STATES);
    (void)va_live_begin(&aboard, &rules, at, &carried, sigma);
}

void take(const flight_record *record)
{
    static va_sample sample;
    va_message message = { .version = BS_LIVE_VERSION, .size = (uint16_t)sizeof(va_message),
                           .rows = BS_ALL_ROWS, .at = (int64_t)record->at };

    if (record->kind <= 0.0) {
        sample.at = (int64_t)record->at;
        sample.dt = (bs_real)head.dt;
        convert(sample.dtheta_ib_b, record->of.sample.dtheta, 3);
        convert(sample.dv_b, record->of.sample.dv, 3);
        board_sample(&sample);
        return;
    }
    board_wait(); /* a message comes behind the sample that stands before it in the recording */
    convert(message.mounting.lever_b, head.lever_b, 3);
    convert(message.master.v_m_n, record->of.message.v_m_n, 3);
    convert(message.master.q_m2n_wxyz, record->of.message.q_m2n_wxyz, 4);
    if (aboard.state != BS_LIVE_FLYING) {
        begin(record, sample.at);
    } else {
        message.measurement = VA_MEASUREMENT_VELOCITY;
        convert(message.variance, head.velocity_variance, 3);
        (void)va_live_message(&aboard, &message, NULL);
        message.measurement = VA_MEASUREMENT_DCM;
        convert(message.variance, head.attitude_variance, 3);
        (void)va_live_message(&aboard, &message, NULL);
    }
}

int main(int argc, char **argv)
{
    flight_record record;
    FILE *const file = (argc == 2) ? fopen(argv[1], "rb") : NULL;
    if ((file == NULL) || (fread(&head, sizeof head, 1, file) != 1U)) {
        (void)printf("give the name of a recording, as make_recording.py writes it\n");
        return 2;
    }
    while (fread(&record, sizeof record, 1, file) == 1U) {
        take(&record);
        report(&record);
    }
    report_end();
    (void)fclose(file);
    return (aboard.state == BS_LIVE_FLYING) ? 0 : 1;
}

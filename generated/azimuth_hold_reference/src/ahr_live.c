

/* ahr_live.c - the live loop of azimuth hold with the error of its reference, 16 states.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty. */
#include "azimuth_hold_reference_live.h"

BS_EXACT_BEGIN

#if BORESIGHT_UD
#define INIT ahr_ud_init
#define ADD ahr_ud_add
#define DENSE ahr_ud_dense
#else
#define INIT ahr_joseph_init
#define ADD ahr_joseph_add
#define DENSE ahr_joseph_dense
#endif

#define N AHR_N_STATES
#define RING AHR_LIVE_RING
#define WAITING AHR_LIVE_WAITING
#define AT(live, n) (&(live)->past[(n) & (RING - 1U)])
#define KEPT (RING - (RING / 4U)) /* samples that a message may be old */
#define MARGIN 4U             /* samples that may come while the oldest one is read */
#define MOST_BRIDGED 16       /* samples that one gap becomes */
#define INFORMED BS_REAL(12.0)         /* the information on a state must be so many times what
                                        * errors of H seem to give */
#define FADING BS_REAL(0.9)     /* from one message to the next, of the information on the delay */
#define BENDING BS_REAL(1e-3)   /* s, sigma of the delay above which its second order is looked
                                 * at */
#define LEAST_TURN BS_REAL(2e-4) /* rad, of a correction that turns the covariance */
#define MOST_STEPS 16           /* in which an error is carried to now */
#define AT_ONCE 4             /* pieces of a measurement in one call of the background */
#define TRIES 4               /* how often a reader begins again while sample writes */
#define SHORTEST BS_REAL(1e-06) /* s, of a step; what is shorter goes with the next one */
#define LONGEST 9000000       /* us */
#define FARTHEST (INT64_MAX / 8) /* us; sums of a few cannot overflow */
#define MOST_ROWS 3

/* Of a measurement under way. */
#define IDLE 0U
#define INFORM 1U
#define WIDEN 2U
#define UPDATE 3U
#define FORGET 4U
#define SETTLE 5U
#define POST 6U

#define FREE 0U
#define PUT 1U
#define ADMITTED 2U
#define DUE 3U
#define REFUSED 4U
#define STAMPED 5U

#define BY_SAMPLE 0
#define BY_BACKGROUND 1

static bs_real seconds(int64_t us)
{
    return (bs_real)us * BS_REAL(1e-6);
}

/* Of an interval; of 32 bits, where they hold it, for which an FPU has an instruction. */
static int64_t microseconds(bs_real s)
{
    return (int64_t)(int32_t)((s * BS_REAL(1e6)) + BS_REAL(0.5));
}

static int64_t lesser(int64_t a, int64_t b)
{
    return (a < b) ? a : b;
}

static int64_t greater(int64_t a, int64_t b)
{
    return (a > b) ? a : b;
}

static void copy(bs_real *to, const bs_real *from, int n)
{
    for (int i = 0; i < n; ++i) {
        to[i] = from[i];
    }
}

static void clear(unsigned char *bytes, size_t n)
{
    for (size_t i = 0U; i < n; ++i) {
        bytes[i] = 0U;
    }
}

static void note_event(ahr_live *live, int by, bs_event_code code, int which, int64_t value)
{
    ahr_events *const events = &live->events[by];
    bs_event *const event = &events->event[events->written % AHR_LIVE_EVENTS];
    event->code = (unsigned char)code;
    event->which = (unsigned char)which;
    event->sample = live->count;
    event->value = (int32_t)greater(lesser(value, INT32_MAX), INT32_MIN);
    BS_LIVE_BARRIER();
    events->written += 1U;
}

static void lose(ahr_live *live, int by, int64_t why)
{
    live->state = BS_LIVE_LOST;
    note_event(live, by, BS_EVENT_LOST, 0, why);
}

/* ---- navigation */

/* What the strapdown moves, out of what is kept of a sample, and into it. */
static void recall(ahr_carried *at, const ahr_past *past)
{
    copy(at->nav.lon_lat_height, past->lon_lat_height, 3);
    copy(at->nav.v_n, past->v_n, 3);
    copy(at->nav.q_b2n_wxyz, past->q_b2n_wxyz, 4);
}

static void keep(ahr_past *past, const ahr_carried *at)
{
    copy(past->lon_lat_height, at->nav.lon_lat_height, 3);
    copy(past->v_n, at->nav.v_n, 3);
    copy(past->q_b2n_wxyz, at->nav.q_b2n_wxyz, 4);
}

/* Carry `at` over a part of an interval, of what is shorter than SHORTEST over none or that;
 * before: what the sensors delivered in the interval before it. */
static bs_status carry(const ahr_live *live,
                       ahr_carried *at,
                       const ahr_past *now,
                       const bs_real before[AHR_N_SENSED],
                       bs_real until)
{
    const bs_real least = SHORTEST / now->dt;
    const bs_real part = (until < least) ? least : until;
    ahr_carried next;
    bs_status status;
    ahr_corrected_imu corrected_imu = { .f_b = { BS_REAL(0.0) } };
    ahr_increments increments = { .dtheta_ib_b = { BS_REAL(0.0) } };
    corrected_imu.dt = now->dt * part;
    increments.dtheta_ib_b[0] = now->sensed[0] * part;
    increments.dtheta_ib_b[1] = now->sensed[1] * part;
    increments.dtheta_ib_b[2] = now->sensed[2] * part;
    increments.dv_b[0] = now->sensed[3] * part;
    increments.dv_b[1] = now->sensed[4] * part;
    increments.dv_b[2] = now->sensed[5] * part;
    increments.dtheta_before[0] = before[0] * part;
    increments.dtheta_before[1] = before[1] * part;
    increments.dtheta_before[2] = before[2] * part;
    increments.dv_before[0] = before[3] * part;
    increments.dv_before[1] = before[4] * part;
    increments.dv_before[2] = before[5] * part;
    (void)live;
    (void)before;
    if (until < (BS_REAL(0.5) * least)) {
        return BS_OK;
    }
    status = ahr_strapdown(&at->nav, &corrected_imu, &increments, next.nav.lon_lat_height,
                           next.nav.v_n, next.nav.q_b2n_wxyz);
    if (status == BS_OK) {
        copy(at->nav.lon_lat_height, next.nav.lon_lat_height, 3);
        copy(at->nav.v_n, next.nav.v_n, 3);
        copy(at->nav.q_b2n_wxyz, next.nav.q_b2n_wxyz, 4);
    }
    return status;
}

/* Take the errors x out of `at`. */
static bs_status correct(const ahr_live *live, const bs_real x[N], ahr_carried *at)
{
    ahr_carried next = *at;
    bs_status status;
    (void)live;
    status = ahr_feedback(x, &at->nav, &at->reference, next.nav.lon_lat_height, next.nav.v_n,
                          next.nav.q_b2n_wxyz, next.nav.gyro_bias, next.nav.accel_bias,
                          &next.reference.reference_error);
    if (status == BS_OK) {
        *at = next;
    }
    return status;
}

/* What the loop knows of corrected_imu from the means of the sensors over `span` seconds. */
static void fill_corrected_imu(ahr_corrected_imu *corrected_imu,
                               const ahr_carried *at,
                               const bs_real mean[AHR_N_SENSED],
                               bs_real span)
{
    (void)at;
    (void)mean;
    (void)span;
    corrected_imu->f_b[0] = -at->nav.accel_bias[0] + mean[3];
    corrected_imu->f_b[1] = -at->nav.accel_bias[1] + mean[4];
    corrected_imu->f_b[2] = -at->nav.accel_bias[2] + mean[5];
    corrected_imu->omega_ib_b[0] = -at->nav.gyro_bias[0] + mean[0];
    corrected_imu->omega_ib_b[1] = -at->nav.gyro_bias[1] + mean[1];
    corrected_imu->omega_ib_b[2] = -at->nav.gyro_bias[2] + mean[2];
    corrected_imu->dt = span;
}

static ahr_carried carried_of(const ahr_filter *filter)
{
    ahr_carried found;
    found.nav = filter->nav;
    found.reference = filter->reference;
    return found;
}

/* ---- the past */

/* The interval that ends with sample n, or a part of it. */
static bs_status carry_by(const ahr_live *live, ahr_carried *at, uint32_t n, bs_real part)
{
    const ahr_past *const last = AT(live, n - 1U);
    const ahr_past *const now = AT(live, n);
    return carry(live, at, now, (last->dt > BS_REAL(0.0)) ? last->sensed : now->sensed, part);
}

static uint32_t oldest_kept(const ahr_live *live)
{
    return (live->count < (RING - MARGIN)) ? 0U : (live->count - (RING - MARGIN));
}

/* Before this instant nothing is measured any more. */
static int64_t oldest_instant(const ahr_live *live, uint32_t count)
{
    const int64_t by_rule = AT(live, count)->at - (int64_t)live->rules.oldest_us;
    return (count < KEPT) ? by_rule : greater(by_rule, AT(live, count - KEPT)->at);
}

/* The newest sample of those from `first` to `last` that does not end behind t; `first`, if all
 * do. */
static uint32_t find(const ahr_live *live, int64_t t, uint32_t first, uint32_t last)
{
    uint32_t low = first;
    uint32_t high = last;
    while (low < high) {
        const uint32_t middle = low + ((high - low + 1U) / 2U);
        if (AT(live, middle)->at <= t) {
            low = middle;
        } else {
            high = middle - 1U;
        }
    }
    return low;
}

/* The part of the interval that ends with sample n which lies before t. */
static bs_real part_until(const ahr_live *live, uint32_t n, int64_t t)
{
    const int64_t begin = AT(live, n - 1U)->at;
    const int64_t end = AT(live, n)->at;
    bs_real part = BS_REAL(0.0);
    if (t >= end) {
        part = BS_REAL(1.0);
    } else if (t > begin) {
        part = seconds(t - begin) / seconds(end - begin);
    } else {
        /* it begins behind t */
    }
    return part;
}

/* The navigation as it was flown at t, within the samples to `last`. */
static bs_status flown_at(const ahr_live *live, int64_t t, uint32_t last, ahr_carried *at)
{
    const uint32_t n = find(live, t, oldest_kept(live), last);
    const bs_real part = (n < last) ? part_until(live, n + 1U, t) : BS_REAL(0.0);
    *at = live->flown;
    recall(at, AT(live, n));
    return (part > BS_REAL(0.0)) ? carry_by(live, at, n + 1U, part) : BS_OK;
}

/* What the sensors deliver a second, from one instant to another within the samples to `last`; zero
 * where that is no time.
 * returns the seconds between them by the samples' own dt */
static bs_real mean_between(const ahr_live *live,
                            int64_t from,
                            int64_t to,
                            uint32_t last,
                            bs_real mean[AHR_N_SENSED])
{
    bs_real span = BS_REAL(0.0);
    for (int i = 0; i < AHR_N_SENSED; ++i) {
        mean[i] = BS_REAL(0.0);
    }
    for (uint32_t n = find(live, from, oldest_kept(live), last) + 1U; (n <= last) &&
         (AT(live, n - 1U)->at < to); ++n) {
        const ahr_past *const past = AT(live, n);
        const bs_real part = part_until(live, n, to) - part_until(live, n, from);
        span += part * past->dt;
        for (int i = 0; i < 3; ++i) {
            mean[i] += part * past->sensed[i];
        }
        for (int i = 3; i < 6; ++i) {
            mean[i] += part * past->sensed[i];
        }
    }
    for (int i = 0; i < AHR_N_SENSED; ++i) {
        mean[i] = (span > BS_REAL(0.0)) ? (mean[i] / span) : BS_REAL(0.0);
    }
    return span;
}

/* Of these seconds those in which samples were missing, or known no better. */
static bs_real missing_between(const ahr_live *live, int64_t from, int64_t to, uint32_t last)
{
    bs_real missing = BS_REAL(0.0);
    for (uint32_t n = find(live, from, oldest_kept(live), last) + 1U; (n <= last) &&
         (AT(live, n - 1U)->at < to); ++n) {
        if ((AT(live, n)->stepped % 2) != 0) {
            missing += (part_until(live, n, to) - part_until(live, n, from)) * AT(live, n)->dt;
        }
    }
    return missing;
}

/* ---- sample */

static bs_status check_sample(const ahr_sample *sample)
{
    bs_status status = bs_check_each(&sample->dt, BS_REAL(1e-06), BS_REAL(10.0), 1);
    if (status == BS_OK) {
        status = bs_check_each(sample->dtheta_ib_b, BS_REAL(-0.5), BS_REAL(0.5), 3);
    }
    if (status == BS_OK) {
        status = bs_check_each(sample->dv_b, BS_REAL(-100.0), BS_REAL(100.0), 3);
    }
    if ((status == BS_OK) && ((sample->at > FARTHEST) || (sample->at < -FARTHEST))) {
        status = BS_OUT_OF_RANGE;
    }
    return status;
}

/* Corrections that are due. */
static void take_corrections(ahr_live *live, uint32_t n, ahr_carried *at)
{
    while ((live->applied != live->posted) &&
           ((int32_t)(live->mail[live->applied % WAITING].due - n) <= 0)) {
        ahr_correction *const mail = &live->mail[live->applied % WAITING];
        mail->took = (correct(live, mail->x, at) == BS_OK) ? 1U : 0U;
        mail->when = n;
        if (mail->took == 0U) {
            /* [BS-L-032] */
            live->counts.corrections_refused += 1U;
            note_event(live, BY_SAMPLE, BS_EVENT_CORRECTION_REFUSED, 0, 0);
        }
        BS_LIVE_BARRIER();
        live->applied += 1U;
    }
}

/* One interval that follows the newest: sensed stands in its place already. */
static bs_status fly(ahr_live *live, int64_t at, bs_real dt, bool missing)
{
    const uint32_t n = live->count + 1U;
    ahr_past *const past = AT(live, n);
    const ahr_past *const last = AT(live, n - 1U);
    ahr_carried next = live->now;
    bs_status status;
    past->at = at;
    past->dt = dt;
    past->stepped = (2 * (int32_t)(greater(lesser(live->stepped, 1000000000), -1000000000) / 2)) +
        (missing ? 1 : 0);
    live->stepped = 0;
    status = carry_by(live, &next, n, BS_REAL(1.0));
    if ((status != BS_OK) && (last->dt > BS_REAL(0.0))) {
        for (int i = 0; i < 3; ++i) {
            past->sensed[i] = last->sensed[i] * (dt / last->dt);
        }
        for (int i = 3; i < 6; ++i) {
            past->sensed[i] = last->sensed[i] * (dt / last->dt);
        }
        past->stepped += missing ? 0 : 1;
        /* [BS-L-027] */
        live->counts.held += 1U;
        note_event(live, BY_SAMPLE, BS_EVENT_HELD, 0, (int64_t)status);
        status = carry_by(live, &next, n, BS_REAL(1.0));
    }
    if (status != BS_OK) {
        lose(live, BY_SAMPLE, (int64_t)status);
        return status;
    }
    take_corrections(live, n, &next);
    keep(past, &next);
    live->now = next;
    BS_LIVE_BARRIER();
    live->count = n;
    return BS_OK;
}

/* What is missing between the newest interval and one that begins `late` behind its end. */
static bs_status bridge(ahr_live *live, const ahr_sample *sample, int64_t late, int64_t span)
{
    const int64_t parts = greater(1, lesser(MOST_BRIDGED, (late + (span / 2)) / greater(1, span)));
    const ahr_past last = *AT(live, live->count);
    const bs_real dt = seconds(late) / (bs_real)parts;
    const bs_real own = BS_REAL(0.5) * (dt / sample->dt);
    bs_status status = BS_OK;
    (void)own;
    for (int64_t k = 1; (k <= parts) && (status == BS_OK); ++k) {
        ahr_past *const past = AT(live, live->count + 1U);
        past->sensed[0] = own * sample->dtheta_ib_b[0];
        past->sensed[1] = own * sample->dtheta_ib_b[1];
        past->sensed[2] = own * sample->dtheta_ib_b[2];
        past->sensed[3] = own * sample->dv_b[0];
        past->sensed[4] = own * sample->dv_b[1];
        past->sensed[5] = own * sample->dv_b[2];
        /* the mean of the rates before and behind; of those behind, where there are none before */
        for (int i = 0; i < 3; ++i) {
            past->sensed[i] += (last.dt > BS_REAL(0.0)) ? (BS_REAL(0.5) *
                                                           (last.sensed[i] * (dt / last.dt)))
                : past->sensed[i];
        }
        for (int i = 3; i < 6; ++i) {
            past->sensed[i] += (last.dt > BS_REAL(0.0)) ? (BS_REAL(0.5) *
                                                           (last.sensed[i] * (dt / last.dt)))
                : past->sensed[i];
        }
        live->counts.missing += 1U;
        status = fly(live, last.at + ((late * k) / parts), dt, true);
    }
    return status;
}

/* A kind of message of which none that could be waited for has come for long is reported, once; one
 * kind a sample. */
static void watch_silence(ahr_live *live, int64_t now)
{
    const uint32_t kind = live->count % (uint32_t)AHR_N_MEASUREMENTS;
    if ((live->came[kind] == 1U) && (live->rules.silent_us > 0) &&
        ((now - live->measured[kind]) > (int64_t)live->rules.silent_us)) {
        live->came[kind] = 2U;
        /* [BS-L-035] */
        live->counts.silences += 1U;
        note_event(live, BY_SAMPLE, BS_EVENT_SILENT, (int)kind, now - live->measured[kind]);
    }
}

/* Messages whose turn has come. */
static void admit(ahr_live *live)
{
    const int64_t now = AT(live, live->count)->at;
    for (uint32_t i = 0U; i < WAITING; ++i) {
        ahr_waiting *const one = &live->waiting[i];
        if (one->state == STAMPED) {
            const uint32_t kind = one->message.measurement;
            int64_t stamp = one->message.at + one->clock;
            one->at = stamp;
            one->fate = BS_MSG_WAITING;
            if ((live->came[kind] != 0U) && (live->measured[kind] == stamp)) {
                /* [BS-L-006] */
                one->fate = BS_MSG_TWICE;
            } else if (one->at < oldest_instant(live, live->count)) {
                /* [BS-L-004] */
                one->fate = BS_MSG_OLD;
            } else if (one->at > (now + (int64_t)live->rules.ahead_us)) {
                /* [BS-L-007] */
                one->fate = BS_MSG_AHEAD;
            } else {
                live->measured[kind] = stamp;
                live->came[kind] = 1U;
            }
            BS_LIVE_BARRIER();
            one->state = (one->fate == BS_MSG_WAITING) ? ADMITTED : REFUSED;
        }
        if ((one->state == ADMITTED) && (now >= (one->at + (int64_t)live->rules.hold_us))) {
            one->due = live->count;
            BS_LIVE_BARRIER();
            one->state = DUE;
        }
    }
    watch_silence(live, now);
}

bs_status ahr_live_sample(ahr_live *live, const ahr_sample *sample)
{
    bs_status status;
    int64_t late;
    int64_t span;
    int64_t jitter;
    bool missing = false;
    /* [AHR-L-002] */
    if ((live == NULL) || (sample == NULL)) {
        return BS_NULL_POINTER;
    }
    if (live->state != BS_LIVE_FLYING) {
        return BS_NOT_READY;
    }
    /* [AHR-L-013] */
    status = check_sample(sample);
    if (status != BS_OK) {
        /* [BS-L-026] */
        live->counts.bad += 1U;
        note_event(live, BY_SAMPLE, BS_EVENT_BAD_SAMPLE, 0, (int64_t)status);
        return status;
    }
    if ((sample->at == live->stamp) && (live->counts.samples > 0U)) {
        /* [BS-L-025] */
        live->counts.repeated += 1U;
        note_event(live, BY_SAMPLE, BS_EVENT_REPEATED, 0, 0);
        return BS_OK;
    }
    live->sequence += 1U;
    BS_LIVE_BARRIER();
    for (uint32_t i = 0U; i < WAITING; ++i) { /* in the clock of the sample before they came */
        if (live->waiting[i].state == PUT) {
            live->waiting[i].clock = live->clock;
            live->waiting[i].state = STAMPED;
        }
    }
    span = microseconds(sample->dt);
    jitter = (live->rules.jitter_us > 0) ? (int64_t)live->rules.jitter_us : (span / 2);
    late = ((sample->at + live->clock) - span) - AT(live, live->count)->at;
    if ((late < -jitter) ||
        ((late > jitter) && (sample->serial != 0U) && (sample->serial == (live->serial + 1U)))) {
        live->clock -= late;
        live->stepped += late;
        /* [BS-L-024] */
        live->counts.clock_steps += 1U;
        note_event(live, BY_SAMPLE, BS_EVENT_CLOCK, 0, late);
        late = 0;
    }
    if (late > (int64_t)live->rules.bridge_us) {
        /* [BS-L-029] [AHR-L-012] */
        lose(live, BY_SAMPLE, late);
        status = BS_NOT_READY;
    } else if (late > jitter) {
        note_event(live, BY_SAMPLE, BS_EVENT_GAP, 0, late);
        live->stepped += (sample->serial == 0U) ? late : 0; /* or the clock has stepped */
        /* [AHR-L-011] [BS-L-023] */
        status = bridge(live, sample, late, span);
    } else {
        /* it begins where the last one ended */
    }
    if (status == BS_OK) {
        bs_real *const sensed = AT(live, live->count + 1U)->sensed;
        sensed[0] = sample->dtheta_ib_b[0];
        sensed[1] = sample->dtheta_ib_b[1];
        sensed[2] = sample->dtheta_ib_b[2];
        sensed[3] = sample->dv_b[0];
        sensed[4] = sample->dv_b[1];
        sensed[5] = sample->dv_b[2];
        for (int i = 0; i < 3; ++i) {
            const bs_real full = live->rules.full_scale[i] * sample->dt;
            if ((full > BS_REAL(0.0)) && (BS_FABS(sensed[i]) >= full)) {
                if (!missing) {
                    /* [BS-L-028] */
                    live->counts.saturated += 1U;
                    note_event(live, BY_SAMPLE, BS_EVENT_SATURATED, i, 0);
                }
                missing = true;
            }
        }
        for (int i = 3; i < 6; ++i) {
            const bs_real full = live->rules.full_scale[i] * sample->dt;
            if ((full > BS_REAL(0.0)) && (BS_FABS(sensed[i]) >= full)) {
                if (!missing) {
                    /* [BS-L-028] */
                    live->counts.saturated += 1U;
                    note_event(live, BY_SAMPLE, BS_EVENT_SATURATED, i, 0);
                }
                missing = true;
            }
        }
        /* [AHR-L-010] */
        status = fly(live, greater(sample->at + live->clock, AT(live, live->count)->at + 1),
                     sample->dt, missing);
    }
    if (status == BS_OK) {
        live->stamp = sample->at;
        live->serial = sample->serial;
        live->counts.samples += 1U;
        admit(live);
    }
    BS_LIVE_BARRIER();
    live->sequence += 1U;
    return status;
}

/* ---- messages */

bs_status ahr_live_message(ahr_live *live, const ahr_message *message, bs_msg_fate *fate)
{
    bs_msg_fate found = BS_MSG_REFUSED;
    bs_status status = BS_OUT_OF_RANGE;
    ahr_waiting *room = NULL;
    /* [AHR-L-002] */
    if ((live == NULL) || (message == NULL)) {
        return BS_NULL_POINTER;
    }
    if (live->state != BS_LIVE_FLYING) {
        /* [BS-L-010] */
        found = BS_MSG_NOT_READY;
        status = BS_NOT_READY;
    } else if ((message->version == BS_LIVE_VERSION) &&
               (message->size == (uint16_t)sizeof(ahr_message)) &&
               (message->measurement < (uint16_t)AHR_N_MEASUREMENTS) && (message->at <= FARTHEST) &&
               (message->at >= -FARTHEST)) {
        for (uint32_t i = 0U; i < WAITING; ++i) {
            if ((room == NULL) && (live->waiting[i].state == FREE)) {
                room = &live->waiting[i];
            }
        }
        /* [BS-L-009] */
        found = (room == NULL) ? BS_MSG_FULL : BS_MSG_WAITING;
    } else {
        /* no message of this loop */
    }
    if (room != NULL) {
        room->message = *message;
        room->order = live->order;
        live->order += 1U;
        BS_LIVE_BARRIER();
        /* [AHR-L-016] */
        room->state = PUT;
        status = BS_OK;
    } else {
        /* [AHR-L-041] [AHR-L-017] [BS-L-008] */
        live->counts.fate[found] += 1U;
        note_event(live, BY_BACKGROUND, BS_EVENT_MESSAGE, (int)message->measurement,
                   (int64_t)found);
    }
    if (fate != NULL) {
        /* [AHR-L-017] */
        *fate = found;
    }
    return status;
}

static void finish(ahr_live *live, ahr_waiting *one, bs_msg_fate fate)
{
    live->counts.fate[fate] += 1U;
    if (fate != BS_MSG_TAKEN) {
        note_event(live, BY_BACKGROUND, BS_EVENT_MESSAGE, (int)one->message.measurement,
                   (int64_t)fate);
    }
    BS_LIVE_BARRIER();
    one->state = FREE;
}

/* Of the messages that are due the first: by the sample that made them so, by when they were
 * measured, by their coming. */
static ahr_waiting *first_due(ahr_live *live)
{
    ahr_waiting *first = NULL;
    for (uint32_t i = 0U; i < WAITING; ++i) {
        ahr_waiting *const one = &live->waiting[i];
        if (one->state == DUE) {
            if (first == NULL) {
                first = one;
            } else if (one->due != first->due) {
                first = ((int32_t)(one->due - first->due) < 0) ? one : first;
            } else if (one->at != first->at) {
                first = (one->at < first->at) ? one : first;
            } else {
                first = ((int32_t)(one->order - first->order) < 0) ? one : first;
            }
        }
    }
    return first;
}

/* ---- the covariance */

#define BENT 6

/* Errors of a rotation do not add: what two feedbacks take out, first x and then y, is x + y + B(x)
 * y, B(x)_ij = b x_k. */
static const unsigned char bent[BENT][3] = {
    { 6U, 7U, 8U },
    { 6U, 8U, 7U },
    { 7U, 6U, 8U },
    { 7U, 8U, 6U },
    { 8U, 6U, 7U },
    { 8U, 7U, 6U },
};
static const bs_real bends[BENT] = { BS_REAL(0.5), BS_REAL(-0.5), BS_REAL(-0.5), BS_REAL(0.5),
                                     BS_REAL(0.5), BS_REAL(-0.5) };

static void compose(bs_real x[N], const bs_real y[N])
{
    bs_real more[N] = { BS_REAL(0.0) };
    for (int q = 0; q < BENT; ++q) {
        more[bent[q][0]] += bends[q] * (x[bent[q][2]] * y[bent[q][1]]);
    }
    for (int i = 0; i < N; ++i) {
        x[i] += y[i] + more[i];
    }
}

/* What is left of x behind a feedback of y: (I - B(y)) (x - y). */
static void take_out(bs_real x[N], const bs_real y[N])
{
    bs_real left[N];
    for (int i = 0; i < N; ++i) {
        left[i] = x[i] - y[i];
        x[i] = left[i];
    }
    for (int q = 0; q < BENT; ++q) {
        x[bent[q][0]] -= bends[q] * (y[bent[q][2]] * left[bent[q][1]]);
    }
}

/* The covariance of what is left behind a feedback of y, T P T' with T = I - B(y); where y turns by
 * less than LEAST_TURN it is as it was. */
static void turn_covariance(ahr_live *live, const bs_real y[N])
{
    ahr_filter *const filter = &live->filter;
    bs_real *const dense = &filter->work[AHR_N_PACKED];
    bs_real most = BS_REAL(0.0);
    for (int q = 0; q < BENT; ++q) {
        const bs_real size = BS_FABS(y[bent[q][2]]);
        most = (size > most) ? size : most;
    }
    if (most < LEAST_TURN) {
        return;
    }
    DENSE(filter->P, dense);
    for (int side = 0; side < 2; ++side) { /* rows, then columns */
        const int along = (side == 0) ? 1 : N;
        const int across = (side == 0) ? N : 1;
        for (int c = 0; c < N; ++c) {
            bs_real more[N] = { BS_REAL(0.0) };
            for (int q = 0; q < BENT; ++q) {
                more[bent[q][0]] -= bends[q] *
                    (y[bent[q][2]] * dense[((int)bent[q][1] * across) + (c * along)]);
            }
            for (int i = 0; i < N; ++i) {
                dense[(i * across) + (c * along)] += more[i];
            }
        }
    }
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j < i; ++j) {
            dense[(j * N) + i] = dense[(i * N) + j];
        }
    }
    (void)INIT(dense, filter->P, filter->work); /* or P stays as it is */
}

/* x is what the filter's navigation errs by, taken out of the navigation that was flown. */
static bs_status set_filter(ahr_live *live, const ahr_carried *flown)
{
    ahr_carried best = *flown;
    bs_status status = correct(live, live->x, &best);
    if (status == BS_OK) {
        status = ahr_filter_set_nav(&live->filter, &best.nav, &best.reference, BS_REFUSE);
    }
    return status;
}

/* Over some seconds, x as the last step of the covariance carries it; in `most` pieces at most. */
static void carry_error(const ahr_live *live, bs_real x[N], bs_real span, int most)
{
    bs_real next[N];
    /* in its steps */
    bs_real part = (live->Phi_dt > BS_REAL(0.0)) ? (span / live->Phi_dt) : BS_REAL(0.0);
    const int steps = (part >= (bs_real)most) ? most : (1 + (int)part);
    part = (part > BS_REAL(0.0)) ? (part / (bs_real)steps) : BS_REAL(0.0);
    for (int k = 0; k < steps; ++k) {
        copy(next, x, N);
        ahr_predict_state(live->Phi, next);
        for (int i = 0; i < N; ++i) {
            x[i] += part * (next[i] - x[i]);
        }
    }
}

/* Whether the covariance has come by a correction: x is what is left. */
static bool pass(ahr_live *live)
{
    const ahr_correction *const mail = &live->mail[live->passed % WAITING];
    if ((live->passed == live->applied) || ((int32_t)(mail->when - live->behind) > 0)) {
        return false;
    }
    if (mail->took != 0U) {
        recall(&live->flown, AT(live, live->behind));
        (void)correct(live, mail->x, &live->flown); /* what no strapdown moves; as it was taken
                                                     * before */
        take_out(live->x, mail->x);
    }
    live->passed += 1U;
    return true;
}

/* What is left of x goes to now: due at a sample that is known. */
static void post(ahr_live *live, uint32_t made_due)
{
    ahr_correction *const mail = &live->mail[live->posted % WAITING];
    const ahr_past *const then = AT(live, made_due);
    const int64_t due = then->at + ((int64_t)live->rules.latency * microseconds(then->dt));
    int64_t at = live->at;
    if ((live->posted - live->passed) >= WAITING) {
        return; /* it goes with the next one */
    }
    copy(mail->x, live->x, N);
    /* what those before it take out is not taken out once more */
    for (uint32_t k = live->passed; k != live->posted; ++k) {
        const ahr_correction *const other = &live->mail[k % WAITING];
        if (other->at > at) {
            carry_error(live, mail->x, seconds(other->at - at), MOST_STEPS);
            at = other->at;
        }
        for (int i = 0; i < N; ++i) {
            mail->x[i] -= other->x[i];
        }
    }
    carry_error(live, mail->x, seconds(due - at), MOST_STEPS);
    /* [AHR-L-040] */
    mail->due = made_due + live->rules.latency;
    mail->at = due;
    mail->took = 0U;
    if ((int32_t)(mail->due - live->count) <= 0) {
        /* [BS-L-031] */
        live->counts.corrections_late += 1U;
        note_event(live, BY_BACKGROUND, BS_EVENT_CORRECTION_LATE, 0,
                   (int64_t)(live->count - mail->due));
    }
    live->counts.corrections += 1U;
    BS_LIVE_BARRIER();
    live->posted += 1U;
}


/* The states may have moved for some seconds in a way that nothing is known of. */
static void open_states(ahr_live *live)
{
    bs_real variance[N];
    bs_status status;
    for (int i = 0; i < N; ++i) {
        const bs_real sigma = live->rules.open[i] * live->unknown;
        variance[i] = sigma * sigma;
    }
    live->unknown = BS_REAL(0.0);
    live->opening = 0U;
    status = ahr_filter_inflate(&live->filter, 0, N, variance);
    if (!bs_good(status)) {
        lose(live, BY_BACKGROUND, (int64_t)status);
    }
}

/* Carry the covariance to t, which lies in no interval behind the one that follows `behind`s
 * step. */
static void advance(ahr_live *live, int64_t t, uint32_t last)
{
    const ahr_carried *at = NULL;
    ahr_carried middle;
    bs_real mean[AHR_N_SENSED];
    const bs_real span = mean_between(live, live->since, t, last, mean);
    bs_status status = BS_OK;
    if (span >= SHORTEST) {
        status = flown_at(live, live->since + ((t - live->since) / 2), last, &middle);
        if (status == BS_OK) {
            status = set_filter(live, &middle);
        }
    }
    if ((status == BS_OK) && (span >= SHORTEST)) {
    ahr_corrected_imu corrected_imu = { .f_b = { BS_REAL(0.0) } };
    ahr_noise noise = live->rules.noise;
        middle = carried_of(&live->filter);
        at = &middle;
    fill_corrected_imu(&corrected_imu, at, mean, span);
        (void)at;
        copy(live->filter.x, live->x, N);
        status = ahr_filter_propagate(&live->filter, &corrected_imu, &noise);
        if (bs_good(status)) {
            copy(live->x, live->filter.x, N);
            copy(live->Phi, live->filter.Phi, AHR_N_PHI);
            live->Phi_dt = span;
            live->unknown += missing_between(live, live->since, t, last);
            live->opening = (live->unknown > BS_REAL(0.0)) ? 1U : 0U;
            live->since = t;
            status = BS_OK;
        }
    }
    if (status != BS_OK) {
        lose(live, BY_BACKGROUND, (int64_t)status);
        return;
    }
    live->at = t;
    while ((live->behind != last) && (AT(live, live->behind + 1U)->at <= t)) {
        live->behind += 1U;
    }
}

/* The next sample that a step of the covariance ends at, whatever comes. */
static uint32_t next_end(const ahr_live *live)
{
    const uint32_t every = live->rules.every;
    return live->behind + (every - (live->behind % every));
}

/* Where the next step of the covariance ends on its way to `goal`: at a message, at every so many
 * samples, and where a correction was taken. */
static int64_t step_end(const ahr_live *live, int64_t goal, uint32_t last)
{
    const uint32_t next = next_end(live);
    int64_t end = ((int32_t)(next - last) <= 0) ? lesser(goal, AT(live, next)->at) : goal;
    for (uint32_t k = live->passed; k != live->applied; ++k) {
        const uint32_t when = live->mail[k % WAITING].when;
        if ((int32_t)(when - live->behind) > 0) {
            end = lesser(end, AT(live, when)->at);
        }
    }
    return lesser(end, greater(live->since + LONGEST, live->at + 1));
}

/* ---- one measurement, piece by piece */

/* Which errors are varied to see what they do to H: a state; N and more: a sensor. */
static const unsigned short varied[] = { 1U, 6U, 7U, 8U, 0U };
static const unsigned short varied_from[AHR_N_MEASUREMENTS + 1] = { 0U, 0U, 4U, 4U };
static const unsigned short rows_of[AHR_N_MEASUREMENTS] = { 3U, 3U, 1U };
/* among those of all kinds */
static const unsigned short first_row[AHR_N_MEASUREMENTS] = { 0U, 3U, 6U };
static const unsigned short next_variance[AHR_N_MEASUREMENTS] = { 1U, 1U, 1U };

/* What the functions of a measurement read beside the navigation. */
typedef struct {
    ahr_corrected_imu corrected_imu;
} inputs;

static void fill(const ahr_live *live,
                 const ahr_message *message,
                 const ahr_carried *at,
                 const bs_real mean[AHR_N_SENSED],
                 bs_real span,
                 inputs *in)
{
    (void)live;
    (void)message;
    (void)at;
    (void)mean;
    (void)span;
    clear((unsigned char *)&in->corrected_imu, sizeof(in->corrected_imu));
    fill_corrected_imu(&in->corrected_imu, at, mean, span);
}

/* H as it is there, dense. */
static bs_status H_of(const ahr_live *live,
                      uint16_t kind,
                      const ahr_carried *at,
                      const inputs *in,
                      bs_real H[MOST_ROWS * N])
{
    (void)live;
    (void)at;
    (void)in;
    switch (kind) {
    case AHR_MEASUREMENT_ZUPT:
        return ahr_zupt_H(H);
    case AHR_MEASUREMENT_ZARU:
        return ahr_zaru_H(&at->nav, H);
    case AHR_MEASUREMENT_AZIMUTH:
        return ahr_azimuth_H(H);
    default:
        return BS_OUT_OF_RANGE;
    }
}

/* The instants that the rates about that of the message are taken between. */
static int64_t rates_from(const ahr_live *live)
{
    return greater(live->at - (int64_t)live->rules.half_us, AT(live, oldest_kept(live))->at);
}

static int64_t rates_to(const ahr_live *live, uint32_t last)
{
    return lesser(live->at + (int64_t)live->rules.half_us, AT(live, last)->at);
}

/* What is read of the past, once; the filter gets the navigation of the message's instant. */
static bs_status prepare(ahr_live *live, const ahr_waiting *one)
{
    ahr_measuring *const m = &live->measuring;
    const ahr_message *const message = &one->message;
    const int64_t from = rates_from(live);
    const int64_t to = rates_to(live, one->due);
    ahr_carried then;
    inputs in;
    bs_status status;
    clear((unsigned char *)m, sizeof(*m));
    m->span = mean_between(live, from, to, one->due, m->mean);
    m->apart = seconds(to - from);
    copy(m->variance, message->variance, 3);
    status = flown_at(live, live->at, one->due, &then);
    if (status == BS_OK) {
        status = set_filter(live, &then);
    }
    if (status == BS_OK) {
        status = ahr_filter_sigmas(&live->filter, m->before);
    }
    if ((status == BS_OK) && (m->span > BS_REAL(0.0))) {
        then = carried_of(&live->filter);
        fill(live, message, &then, m->mean, m->span, &in);
        m->stage = (H_of(live, message->measurement, &then, &in, m->H) == BS_OK) ? INFORM : WIDEN;
    } else {
        m->stage = WIDEN;
    }
    return status;
}

/* How much one error of H alone seems to inform on each state, in parts of its unit squared: H is
 * made of rates, which have the noise of the sensors in them, and stands on states that are not
 * known. */
static void inform(ahr_live *live, const ahr_message *message, int what)
{
    /* of its box, that a state may err by */
    static const bs_real most[N] = { BS_REAL(0.007853981633974483), BS_REAL(0.007853981633974483),
                                     BS_REAL(900.0), BS_REAL(90.0), BS_REAL(90.0), BS_REAL(90.0),
                                     BS_REAL(0.45), BS_REAL(0.45), BS_REAL(0.45),
                                     BS_REAL(0.015707963267948967), BS_REAL(0.015707963267948967),
                                     BS_REAL(0.015707963267948967), BS_REAL(0.9), BS_REAL(0.9),
                                     BS_REAL(0.9), BS_REAL(0.45) };
    const bs_real density[AHR_N_SENSED] = { live->rules.noise.gyro_noise[0],
                                            live->rules.noise.gyro_noise[1],
                                            live->rules.noise.gyro_noise[2],
                                            live->rules.noise.accel_noise[0],
                                            live->rules.noise.accel_noise[1],
                                            live->rules.noise.accel_noise[2] };
    ahr_measuring *const m = &live->measuring;
    const uint16_t kind = message->measurement;
    ahr_carried at = carried_of(&live->filter);
    bs_real mean[AHR_N_SENSED];
    bs_real H[MOST_ROWS * N];
    inputs in;
    copy(mean, m->mean, AHR_N_SENSED);
    if (what < N) {
        bs_real x[N] = { BS_REAL(0.0) };
        x[what] = (m->before[what] < most[what]) ? m->before[what] : most[what];
        (void)correct(live, x, &at);
    } else {
        const int j = (what - N) % AHR_N_SENSED;
        mean[j] += density[j] / BS_SQRT(m->span);
    }
    fill(live, message, &at, mean, m->span, &in);
    if (H_of(live, kind, &at, &in, H) == BS_OK) {
        for (int i = 0; i < (int)rows_of[kind]; ++i) {
            const bs_real weight = BS_REAL(1.0) / message->variance[i * (int)next_variance[kind]];
            for (int j = 0; j < N; ++j) {
                const bs_real off = H[(i * N) + j] - m->H[(i * N) + j];
                m->seeming[j] += weight * (off * off);
            }
        }
    }
}

/* The filter takes it. */
static bs_status update(ahr_live *live, const ahr_message *message, ahr_innovation *innovation)
{
    ahr_measuring *const m = &live->measuring;
    const ahr_carried at = carried_of(&live->filter);
    bs_gates gates = live->rules.gates;
    inputs in;
    gates.rows &= message->rows;
    if ((live->rules.astray != 0U) && (live->astray[message->measurement] >= live->rules.astray)) {
        gates.options |= BS_INFLATE;
        gates.joint = BS_REAL(0.0);
    }
    fill(live, message, &at, m->mean, m->span, &in);
    switch (message->measurement) {
    case AHR_MEASUREMENT_ZUPT:
        return ahr_filter_measure_zupt(&live->filter, m->variance, &gates, innovation);
    case AHR_MEASUREMENT_ZARU:
        return ahr_filter_measure_zaru(&live->filter, &in.corrected_imu, m->variance, &gates,
                                       innovation);
    case AHR_MEASUREMENT_AZIMUTH:
        return ahr_filter_measure_azimuth(&live->filter, m->variance, &gates, innovation);
    default:
        return BS_OUT_OF_RANGE;
    }
}

/* How much of the gain of each state is taken back: where errors of H alone may have made a good
 * part of the information.  1 of a considered state, which has none.
 * returns BS_OK; whether there is any, and whether the gain is the best one */
static bs_status doubt(ahr_live *live,
                       const ahr_message *message,
                       bs_real parts[N],
                       bool *any,
                       bool *best)
{
    ahr_measuring *const m = &live->measuring;
    const ahr_innovation *const innovation = &live->judged.innovation;
    const uint16_t kind = message->measurement;
    bs_real after[N];
    bs_real noise = BS_REAL(0.0); /* part of R in the variance of the innovation */
    const bs_status status = ahr_filter_sigmas(&live->filter, after);
    *any = false;
    *best = true;
    for (int i = 0; i < MOST_ROWS; ++i) {
        if (((innovation->used >> (unsigned int)i) & 1U) != 0U) {
            const bs_real part = message->variance[i * (int)next_variance[kind]] / innovation->S[i];
            noise = (part > noise) ? part : noise;
        }
    }
    for (int j = 0; (j < N) && (status == BS_OK); ++j) {
        const bs_real was = m->before[j] * m->before[j];
        const bs_real is = after[j] * after[j];
        /* beside an innovation that other states make uncertain, errors of H tell less */
        const bs_real beside = (is > (noise * was)) ? ((noise * was) / is) : BS_REAL(1.0);
        const bs_real seeming = beside * m->seeming[j];
        const bs_real by_errors = seeming * (was * is);
        bs_real part = ((INFORMED * by_errors) > (was - is)) ? BS_REAL(1.0) : BS_REAL(0.0);
        parts[j] = ((by_errors > BS_REAL(0.0)) && (was > is)) ? part : BS_REAL(0.0);
        *any = *any || (parts[j] > BS_REAL(0.0));
        if (live->filter.considered[j] != 0U) {
            parts[j] = BS_REAL(1.0);
        }
        *best = *best && ((parts[j] <= BS_REAL(0.0)));
    }
    return status;
}

/* An entry of P, of its form, i not below j. */
static bs_real entry(const bs_real *P, int i, int j)
{
#if BORESIGHT_UD
    bs_real sum = BS_REAL(0.0);
    for (int k = i; k < N; ++k) {
        const bs_real *const column = &P[(k * (k + 1)) / 2];
        const bs_real u = (i == k) ? BS_REAL(1.0) : column[i];
        const bs_real w = (j == k) ? BS_REAL(1.0) : column[j];
        sum += u * (column[k] * w);
    }
    return sum;
#else
    return P[((i * (i + 1)) / 2) + j];
#endif
}

/* Innovations of a filter that is right have a mean square of 1, in parts of their sigmas, and have
 * nothing to do with the last one.  Where that is as unlikely as one in 1e8, over one window or
 * several, an event says so; once, until it is not so any more. */
static void judge_window(ahr_live *live, uint16_t kind, int level)
{
    static const unsigned short messages[AHR_LIVE_LEVELS] = { 64U, 256U, 1024U };
    static const bs_real bounds[AHR_LIVE_LEVELS][3] = { /* of mean squares, and of the square of a
                                                         * correlation */
        { BS_REAL(0.2913), BS_REAL(2.364), BS_REAL(0.4037) },
        { BS_REAL(0.5733), BS_REAL(1.592), BS_REAL(0.1206) },
        { BS_REAL(0.7671), BS_REAL(1.274), BS_REAL(0.03158) },
    };
    const bs_real n = (bs_real)messages[level];
    const unsigned int bits = 0xFU << (unsigned int)(4 * level);
    unsigned int found = 0U;
    for (int i = 0; i < (int)rows_of[kind]; ++i) {
        const ahr_sums *const sums = &live->sums[(int)first_row[kind] + i][level];
        const bs_real limit = bounds[level][2] * sums->squares;
        /* [BS-L-036] [BS-L-037] [BS-L-038] [BS-L-039] */
        const bool unlikely[4] = { sums->squares > (bounds[level][1] * n),
                                   sums->squares < (bounds[level][0] * n),
                                   (sums->products * sums->products) > (limit * sums->squares),
                                   (sums->sum * sums->sum) > (limit * n) };
        for (int k = 0; k < 4; ++k) {
            const unsigned int bit = 1U << (unsigned int)((4 * level) + k);
            if (unlikely[k] && ((found & bit) == 0U)) {
                found |= bit;
                live->counts.unlikely += 1U;
                if ((live->unlikely[kind] & bit) == 0U) {
                    note_event(live, BY_BACKGROUND, (bs_event_code)((int)BS_EVENT_LARGE + k),
                               (int)kind, (32 * (int64_t)messages[level]) + i);
                }
            }
        }
    }
    live->unlikely[kind] = (uint16_t)((live->unlikely[kind] & ~bits) | found);
}

/* An innovation is added to its window, and a window that is full to the next longer one. */
static void watch(ahr_live *live, uint16_t kind)
{
    const ahr_innovation *const innovation = &live->judged.innovation;
    bool full = true;
    for (int i = 0; i < (int)rows_of[kind]; ++i) {
        const int row = (int)first_row[kind] + i;
        const bool used = ((innovation->used >> (unsigned int)i) & 1U) != 0U;
        const bs_real e = used ? (innovation->nu[i] / BS_SQRT(innovation->S[i])) : BS_REAL(0.0);
        live->sums[row][0].squares += e * e;
        live->sums[row][0].products += e * live->last[row];
        live->sums[row][0].sum += e;
        live->last[row] = e;
    }
    for (int level = 0; (level < AHR_LIVE_LEVELS) && full; ++level) {
        live->windowed[kind][level] = (uint16_t)(live->windowed[kind][level] + 1U);
        full = live->windowed[kind][level] >= ((level == 0) ? 64U : 4U);
        if (full) {
            judge_window(live, kind, level);
            live->windowed[kind][level] = 0U;
            for (int i = 0; i < (int)rows_of[kind]; ++i) {
                ahr_sums *const sums = live->sums[(int)first_row[kind] + i];
                if ((level + 1) < AHR_LIVE_LEVELS) {
                    sums[level + 1].squares += sums[level].squares;
                    sums[level + 1].products += sums[level].products;
                    sums[level + 1].sum += sums[level].sum;
                }
                clear((unsigned char *)&sums[level], sizeof(sums[level]));
            }
        }
    }
}

/* Take that back: of a gain (I - L) K in place of the best one K the covariance is
 * P + L (P before - P) L'.  L has the parts on its diagonal. */
static bs_status forget(ahr_live *live, const ahr_message *message)
{
    ahr_filter *const filter = &live->filter;
    bs_real *const dense = &filter->work[AHR_N_PACKED];
    bs_real parts[N];
    bool any = false;
    bool best = true;
    const bs_status status = doubt(live, message, parts, &any, &best);
    if (best) { /* else innovations that belong together are no fault */
        watch(live, message->measurement);
    }
    if (any) {
        DENSE(filter->P, dense);
        for (int i = 0; i < N; ++i) {
            for (int j = 0; j <= i; ++j) {
                const bs_real part = parts[i] * parts[j];
                bs_real more = (part > BS_REAL(0.0)) ? (part *
                                                        (entry(filter->Q, i, j) -
                                                         dense[(i * N) + j])) : BS_REAL(0.0);
                dense[(i * N) + j] += more;
                dense[(j * N) + i] = dense[(i * N) + j];
            }
        }
        if (INIT(dense, filter->P, filter->work) == BS_OK) { /* or P and x stay as they are */
            for (int i = 0; i < N; ++i) {
                filter->x[i] -= (parts[i] * filter->x[i]);
            }
        }
    }
    return status;
}

/* What the state has to do with what was measured, and the rows that were asked for and were not
 * taken. */
static bs_msg_fate judge(ahr_live *live, const ahr_message *message, unsigned int used)
{
    static const unsigned int all[AHR_N_MEASUREMENTS] = { 7U, 7U, 1U };
    const uint16_t kind = message->measurement;
    const unsigned int asked = message->rows & live->rules.gates.rows & all[kind];
    /* [BS-L-001] [BS-L-002] [BS-L-003] */
    const bs_msg_fate fate = (used == asked) ? BS_MSG_TAKEN
        : ((used == 0U) ? BS_MSG_GATED : BS_MSG_IN_PART);
    live->misfits += 1U;
    if (fate == BS_MSG_TAKEN) {
        live->astray[kind] = 0U;
        live->misfits = 0U;
    } else if (live->astray[kind] < 65535U) {
        live->astray[kind] = (uint16_t)(live->astray[kind] + 1U);
        if (live->astray[kind] == live->rules.astray) {
            /* [BS-L-030] */
            note_event(live, BY_BACKGROUND, BS_EVENT_ASTRAY, (int)kind,
                       (int64_t)live->rules.astray);
            if (live->misfits >= live->astray[kind]) { /* nor did any other: it is the navigation
                                                        * that is wrong, as if samples had been
                                                        * missing for a second */
                live->unknown += BS_REAL(1.0);
                live->opening = 1U;
            }
        }
    } else {
        /* it has been reported */
    }
    return fate;
}

/* The next piece of a measurement. */
static void measure(ahr_live *live, ahr_waiting *one)
{
    ahr_measuring *const m = &live->measuring;
    const uint16_t kind = one->message.measurement;
    ahr_innovation innovation = { .used = 0U };
    bs_status status = BS_OK;
    switch (m->stage) {
    case IDLE:
        status = prepare(live, one);
        m->slot = (uint16_t)(one - live->waiting);
        break;
    case INFORM:
        for (int k = 0; (k < AT_ONCE) && ((varied_from[kind] + m->done) < varied_from[kind + 1U]);
             ++k) {
            inform(live, &one->message, (int)varied[varied_from[kind] + m->done]);
            m->done = (uint16_t)(m->done + 1U);
        }
        m->stage = ((varied_from[kind] + m->done) < varied_from[kind + 1U]) ? INFORM : WIDEN;
        break;
    case WIDEN:
        m->done = 0U;
        m->stage = UPDATE;
        break;
    case UPDATE:
        status = update(live, &one->message, &innovation);
        if (bs_good(status)) {
            one->fate = judge(live, &one->message, innovation.used);
            live->judged.count += 1U;
            live->judged.measurement = kind;
            live->judged.order = one->order;
            live->judged.fate = one->fate;
            live->judged.at = live->at;
            live->judged.innovation = innovation;
            m->stage = (innovation.used != 0U) ? FORGET : IDLE;
            status = BS_OK;
        }
        break;
    case FORGET:
        status = forget(live, &one->message);
        m->stage = SETTLE;
        break;
    case SETTLE:
        turn_covariance(live, live->filter.x);
        compose(live->x, live->filter.x);
        m->stage = POST;
        break;
    default:
        post(live, one->due);
        m->stage = IDLE;
        break;
    }
    if (status != BS_OK) {
        one->fate = BS_MSG_REFUSED;
        m->stage = IDLE;
    }
    if (m->stage == IDLE) {
        finish(live, one, one->fate);
    }
}

/* ---- background */

/* Samples were overwritten before the covariance had come by them: it goes on where they begin, and
 * knows as much less as if they had been missing. */
static void catch_up(ahr_live *live)
{
    const uint32_t count = live->count;
    const uint32_t lost = count - (RING - (2U * MARGIN));
    if ((count - live->behind) > (RING - (2U * MARGIN))) {
        /* [BS-L-033] */
        live->counts.overruns += 1U;
        note_event(live, BY_BACKGROUND, BS_EVENT_OVERRUN, 0, (int64_t)(lost - live->behind));
        live->unknown += seconds(AT(live, lost)->at - live->at);
        live->opening = 1U;
        live->behind = lost;
        live->at = AT(live, lost)->at;
        live->since = live->at;
    }
}

bs_status ahr_live_background(ahr_live *live)
{
    ahr_waiting *due;
    int64_t goal;
    uint32_t last;
    /* [AHR-L-002] */
    if (live == NULL) {
        return BS_NULL_POINTER;
    }
    if (live->state != BS_LIVE_FLYING) {
        return BS_NOT_READY;
    }
    for (uint32_t i = 0U; i < WAITING; ++i) {
        if (live->waiting[i].state == REFUSED) {
            finish(live, &live->waiting[i], live->waiting[i].fate);
        }
    }
    if (live->measuring.stage != IDLE) {
        measure(live, &live->waiting[live->measuring.slot]);
        return BS_OK;
    }
    if (live->opening != 0U) {
        open_states(live);
        return BS_OK;
    }
    catch_up(live);
    if (pass(live)) {
        return BS_OK;
    }
    last = live->count;
    BS_LIVE_BARRIER();
    due = first_due(live);
    if (due != NULL) {
        if (due->at < live->at) {
            /* [BS-L-005] */
            finish(live, due, BS_MSG_LATE);
            return BS_OK;
        }
        if (due->at == live->at) {
            /* [AHR-L-014] */
            measure(live, due);
            return BS_OK;
        }
        goal = due->at;
        last = due->due;
    } else {
        goal = oldest_instant(live, last);
        for (uint32_t i = 0U; i < WAITING; ++i) {
            if (live->waiting[i].state == ADMITTED) {
                goal = lesser(goal, live->waiting[i].at);
            }
        }
        if (((int32_t)(next_end(live) - last) > 0) || (AT(live, next_end(live))->at > goal)) {
            return BS_NOT_READY;
        }
        goal = AT(live, next_end(live))->at;
    }
    advance(live, step_end(live, goal, last), last);
    return BS_OK;
}

/* ---- begin */

bs_status ahr_live_defaults(ahr_live_rules *rules)
{
    static const bs_real open[N] = { BS_REAL(0.0008726646259971648), BS_REAL(0.0008726646259971648),
                                     BS_REAL(100.0), BS_REAL(10.0), BS_REAL(10.0), BS_REAL(10.0),
                                     BS_REAL(0.05), BS_REAL(0.05), BS_REAL(0.05), BS_REAL(0.0),
                                     BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0), BS_REAL(0.0),
                                     BS_REAL(0.0), BS_REAL(0.0) };
    /* [AHR-L-002] */
    if (rules == NULL) {
        return BS_NULL_POINTER;
    }
    clear((unsigned char *)rules, sizeof(*rules));
    rules->bridge_us = 100000;
    rules->oldest_us = 500000;
    rules->ahead_us = 100000;
    rules->half_us = 20000;
    rules->silent_us = 5000000;
    /* [AHR-L-001] */
    rules->every = 4U;
    rules->latency = 4U;
    rules->astray = 5U;
    rules->gates.rows = BS_ALL_ROWS;
    rules->gates.gate = BS_REAL(6.0);
    copy(rules->open, open, N);
    return BS_OK;
}

static bs_status check_rules(const ahr_live_rules *rules)
{
    const int32_t us[6] = { rules->jitter_us, rules->bridge_us, rules->oldest_us, rules->hold_us,
                            rules->ahead_us, rules->half_us };
    bs_status status = bs_check_each(rules->open, BS_REAL(0.0), BS_REAL(1e12), N);
    if (status == BS_OK) {
        status = bs_check_each(rules->full_scale, BS_REAL(0.0), BS_REAL(1e12), AHR_N_SENSED);
    }
    for (int i = 0; (i < 6) && (status == BS_OK); ++i) {
        status = ((us[i] < 0) || (us[i] > 10000000)) ? BS_OUT_OF_RANGE : BS_OK;
    }
    /* [AHR-L-004] */
    if ((status == BS_OK) &&
        ((rules->every == 0U) || (rules->every > (RING / 4U)) || (rules->latency == 0U) ||
         (rules->latency > RING) || (rules->hold_us > rules->oldest_us) ||
         (rules->silent_us < 0))) {
        status = BS_OUT_OF_RANGE;
    }
    return status;
}

bs_status ahr_live_begin(ahr_live *live,
                         const ahr_live_rules *rules,
                         int64_t at,
                         const ahr_carried *carried,
                         const bs_real sigma[N])
{
    bs_status status;
    /* [AHR-L-002] */
    if ((live == NULL) || (rules == NULL) || (carried == NULL) || (sigma == NULL)) {
        return BS_NULL_POINTER;
    }
    status = ((at > FARTHEST) || (at < -FARTHEST)) ? BS_OUT_OF_RANGE : check_rules(rules);
    if (status == BS_OK) {
        status = ahr_filter_init_sigmas(&live->filter, &carried->nav, &carried->reference, sigma);
    }
    if (status != BS_OK) {
        return status;
    }
    clear((unsigned char *)live, sizeof(*live));
    status = ahr_filter_init_sigmas(&live->filter, &carried->nav, &carried->reference, sigma);
    live->rules = *rules;
    /* [AHR-L-003] */
    live->now = *carried;
    live->flown = *carried;
    live->stamp = at;
    live->at = at;
    live->since = at;
    live->past[0].at = at;
    keep(&live->past[0], carried);
    live->state = BS_LIVE_FLYING;
    note_event(live, BY_BACKGROUND, BS_EVENT_BEGUN, 0, 0);
    return status;
}

/* Whether it has begun and no sample has come. */
static bool fresh(const ahr_live *live)
{
    return (live->state == BS_LIVE_FLYING) && (live->count == 0U);
}

bs_status ahr_live_set_covariance(ahr_live *live, const bs_real P[N * N])
{
    /* [AHR-L-002] */
    if ((live == NULL) || (P == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [AHR-L-005] [AHR-L-006] */
    return fresh(live) ? ahr_filter_init(&live->filter, &live->now.nav, &live->now.reference, P)
        : BS_NOT_READY;
}

bs_status ahr_live_consider(ahr_live *live, const unsigned char considered[N])
{
    /* [AHR-L-002] */
    if ((live == NULL) || (considered == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [AHR-L-006] [AHR-L-007] */
    return fresh(live) ? ahr_filter_consider(&live->filter, considered) : BS_NOT_READY;
}

/* ---- outputs */

bs_status ahr_live_output(const ahr_live *live, int64_t at, ahr_output *output)
{
    ahr_output found = { .at = at };
    ahr_past newest;
    bs_status status = BS_NOT_READY;
    /* [AHR-L-002] */
    if ((live == NULL) || (output == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [AHR-L-022] */
    if ((at > FARTHEST) || (at < -FARTHEST)) {
        return BS_OUT_OF_RANGE;
    }
    for (int k = 0; (k < TRIES) && (status != BS_OK); ++k) {
        const uint32_t sequence = live->sequence;
        BS_LIVE_BARRIER();
        found.state = live->state;
        found.carried = live->now;
        newest = *AT(live, live->count);
        newest.at -= live->clock;
        BS_LIVE_BARRIER();
        status = (((sequence & 1U) == 0U) && (sequence == live->sequence)) ? BS_OK : BS_NOT_READY;
    }
    if (status == BS_OK) {
        const int64_t ahead = at - newest.at;
        /* [AHR-L-021] */
        if ((found.state != BS_LIVE_FLYING) || (ahead > (int64_t)live->rules.oldest_us) ||
            (ahead < 0)) {
            status = BS_NOT_READY;
        } else if ((ahead > 0) && (newest.dt > BS_REAL(0.0))) {
            status = carry(live, &found.carried, &newest, newest.sensed,
                           seconds(ahead) / newest.dt);
        } else {
            /* it is the instant of the newest sample */
        }
    }
    if (status == BS_OK) {
        /* [AHR-L-020] */
        *output = found;
    }
    return status;
}
bs_status ahr_live_sigmas(const ahr_live *live, bs_real sigma[N], int64_t *at)
{
    bs_status status;
    /* [AHR-L-002] */
    if ((live == NULL) || (sigma == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [AHR-L-023] */
    status = (live->state == BS_LIVE_EMPTY) ? BS_NOT_READY
        : ahr_filter_sigmas(&live->filter, sigma);
    if ((status == BS_OK) && (at != NULL)) {
        *at = live->at - live->clock;
    }
    return status;
}


bs_status ahr_live_covariance(const ahr_live *live, bs_real P[N * N], int64_t *at)
{
    bs_status status;
    /* [AHR-L-002] */
    if ((live == NULL) || (P == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [AHR-L-023] */
    status = (live->state == BS_LIVE_EMPTY) ? BS_NOT_READY
        : ahr_filter_covariance(&live->filter, P);
    if ((status == BS_OK) && (at != NULL)) {
        *at = live->at - live->clock;
    }
    return status;
}

bs_status ahr_live_counted(const ahr_live *live, ahr_live_counts *counts)
{
    /* [AHR-L-002] */
    if ((live == NULL) || (counts == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [AHR-L-024] */
    *counts = live->counts;
    return BS_OK;
}

bs_status ahr_live_measured(const ahr_live *live, ahr_measured *measured)
{
    /* [AHR-L-002] */
    if ((live == NULL) || (measured == NULL)) {
        return BS_NULL_POINTER;
    }
    *measured = live->judged;
    measured->at -= live->clock;
    return (live->judged.count == 0U) ? BS_NOT_READY : BS_OK;
}

bs_status ahr_live_next_event(ahr_live *live, bs_event *event)
{
    ahr_events *from = NULL;
    /* [AHR-L-002] */
    if ((live == NULL) || (event == NULL)) {
        return BS_NULL_POINTER;
    }
    for (int by = 0; by < 2; ++by) {
        ahr_events *const events = &live->events[by];
        const uint32_t unread = events->written - events->read;
        if (unread > AHR_LIVE_EVENTS) {
            live->counts.events_lost += unread - AHR_LIVE_EVENTS;
            events->read = events->written - AHR_LIVE_EVENTS;
        }
        if (events->read != events->written) {
            const bs_event *const one = &events->event[events->read % AHR_LIVE_EVENTS];
            if ((from == NULL) ||
                ((int32_t)(one->sample - from->event[from->read % AHR_LIVE_EVENTS].sample) < 0)) {
                from = events;
            }
        }
    }
    if (from == NULL) {
        return BS_NOT_READY;
    }
    /* [AHR-L-026] */
    *event = from->event[from->read % AHR_LIVE_EVENTS];
    from->read += 1U;
    return BS_OK;
}

size_t ahr_live_size(void)
{
    /* [AHR-L-035] */
    return sizeof(ahr_live);
}

size_t ahr_live_snapshot_size(void)
{
    /* [AHR-L-035] */
    return sizeof(unsigned char[AHR_LIVE_SNAPSHOT_SIZE]);
}

/* ---- a snapshot */

static int copy_bytes(unsigned char *to, const unsigned char *from, size_t n)
{
    for (size_t i = 0U; i < n; ++i) {
        to[i] = from[i];
    }
    return (int)n;
}

static void write_header(unsigned char *to)
{
    static const unsigned char magic[4] = { 0x42U, 0x53U, 0x4CU, 0x53U }; /* "BSLS" */
    static const char hash[] = AHR_MODEL_HASH;
    const unsigned short one = 1U;
    (void)copy_bytes(to, magic, sizeof(magic));
    to[4] = (unsigned char)BS_LIVE_VERSION;
    to[5] = (unsigned char)sizeof(bs_real);
    to[6] = BORESIGHT_UD;
    /* 1 where the least byte comes first */
    (void)copy_bytes(&to[7], (const unsigned char *)&one, 1U);
    (void)copy_bytes(&to[8], (const unsigned char *)hash, 64U);
}

/* CRC-32 (IEEE 802.3) of all that stands before it, its least byte first. */
static void write_checksum(const unsigned char *bytes, unsigned char checksum[BS_SNAPSHOT_CHECKSUM])
{
    uint32_t left = 0xFFFFFFFFU;
    for (int i = 0; i < (AHR_LIVE_SNAPSHOT_SIZE - BS_SNAPSHOT_CHECKSUM); ++i) {
        left ^= (uint32_t)bytes[i];
        for (int bit = 0; bit < 8; ++bit) {
            left = ((left & 1U) != 0U) ? ((left >> 1U) ^ 0xEDB88320U) : (left >> 1U);
        }
    }
    left ^= 0xFFFFFFFFU;
    for (int i = 0; i < BS_SNAPSHOT_CHECKSUM; ++i) {
        checksum[i] = (unsigned char)(left & 0xFFU);
        left >>= 8U;
    }
}

bs_status ahr_live_snapshot(const ahr_live *live, unsigned char bytes[AHR_LIVE_SNAPSHOT_SIZE])
{
    bs_status status = BS_NOT_READY;
    /* [AHR-L-002] */
    if ((live == NULL) || (bytes == NULL)) {
        return BS_NULL_POINTER;
    }
    for (int k = 0; (k < TRIES) && (status != BS_OK); ++k) {
        const uint32_t sequence = live->sequence;
        BS_LIVE_BARRIER();
        (void)copy_bytes(&bytes[BS_SNAPSHOT_HEAD], (const unsigned char *)live, sizeof(*live));
        BS_LIVE_BARRIER();
        status = (((sequence & 1U) == 0U) && (sequence == live->sequence)) ? BS_OK : BS_NOT_READY;
    }
    write_header(bytes);
    /* [AHR-L-030] */
    write_checksum(bytes, &bytes[BS_SNAPSHOT_HEAD + (int)sizeof(*live)]);
    return status;
}

/* Whether no number of a loop leads beyond its own memory, and no instant beyond what can be
 * summed. */
static bs_status check_live(const ahr_live *live)
{
    bs_status status = check_rules(&live->rules);
    bool good = (live->state <= BS_LIVE_LOST) && ((live->sequence & 1U) == 0U);
    good = good && ((live->count - live->behind) < RING) &&
        ((live->applied - live->passed) <= WAITING);
    good = good && ((live->posted - live->applied) <= WAITING) &&
        ((live->posted - live->passed) <= WAITING);
    good = good && (live->clock <= (4 * (FARTHEST / 2))) && (live->clock >= -(4 * (FARTHEST / 2)));
    good = good && (live->at <= (4 * (FARTHEST / 2))) && (live->at >= -(4 * (FARTHEST / 2)));
    good = good && (live->measuring.stage <= POST) && (live->measuring.slot < WAITING);
    good = good && (live->since <= live->at) && (live->since >= -(4 * (FARTHEST / 2)));
    for (uint32_t i = 0U; i < WAITING; ++i) {
        const ahr_waiting *const one = &live->waiting[i];
        good = good && (one->state <= STAMPED) && (one->fate < BS_MSG_FATES) &&
            (one->message.measurement < (uint16_t)AHR_N_MEASUREMENTS);
        good = good && ((live->count - one->due) <= live->count);
    }
    return good ? status : BS_OUT_OF_RANGE;
}

bs_status ahr_live_restore(ahr_live *live, const unsigned char bytes[AHR_LIVE_SNAPSHOT_SIZE])
{
    unsigned char wanted[BS_SNAPSHOT_HEAD];
    unsigned char checksum[BS_SNAPSHOT_CHECKSUM];
    bs_status status = bs_probe();
    /* [AHR-L-002] */
    if ((live == NULL) || (bytes == NULL)) {
        return BS_NULL_POINTER;
    }
    write_header(wanted);
    for (int i = 0; i < BS_SNAPSHOT_HEAD; ++i) {
        /* [AHR-L-031] */
        status = (bytes[i] == wanted[i]) ? status : BS_OUT_OF_RANGE;
    }
    write_checksum(bytes, checksum);
    for (int i = 0; i < BS_SNAPSHOT_CHECKSUM; ++i) {
        /* [AHR-L-032] */
        status = (bytes[AHR_LIVE_SNAPSHOT_SIZE - BS_SNAPSHOT_CHECKSUM + i] == checksum[i]) ? status
            : BS_OUT_OF_RANGE;
    }
    if (status == BS_OK) {
        (void)copy_bytes((unsigned char *)live, &bytes[BS_SNAPSHOT_HEAD], sizeof(*live));
        /* [AHR-L-033] */
        status = check_live(live);
        if (status != BS_OK) { /* no snapshot wrote this: nothing is known any more */
            clear((unsigned char *)live, sizeof(*live));
        }
    }
    return status;
}

bs_status ahr_live_digest(const ahr_live *live, unsigned char digest[BS_DIGEST_SIZE])
{
    bs_digest made;
    const uint32_t *counted;
    /* [AHR-L-002] */
    if ((live == NULL) || (digest == NULL)) {
        return BS_NULL_POINTER;
    }
    (void)bs_digest_begin(&made);
    (void)bs_digest_reals(&made, live->now.nav.lon_lat_height, 3);
    (void)bs_digest_reals(&made, live->now.nav.v_n, 3);
    (void)bs_digest_reals(&made, live->now.nav.q_b2n_wxyz, 4);
    (void)bs_digest_reals(&made, live->now.nav.gyro_bias, 3);
    (void)bs_digest_reals(&made, live->now.nav.accel_bias, 3);
    (void)bs_digest_reals(&made, live->now.reference.q_ref_wxyz, 4);
    (void)bs_digest_reals(&made, &live->now.reference.reference_error, 1);
    (void)bs_digest_reals(&made, live->x, N);
    (void)ahr_filter_digest(&live->filter, &made);
    for (uint32_t k = live->passed; k != live->posted; ++k) {
        (void)bs_digest_reals(&made, live->mail[k % WAITING].x, N);
    }
    counted = (const uint32_t *)&live->counts;
    for (size_t i = 0U; i < (sizeof(live->counts) / sizeof(uint32_t)); ++i) {
        for (unsigned int k = 0U; k < 4U; ++k) {
            bs_digest_byte(&made, (unsigned char)((counted[i] >> (8U * k)) & 0xFFU));
        }
    }
    /* [AHR-L-034] */
    return bs_digest_end(&made, digest);
}

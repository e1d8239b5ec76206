/* attack.c - calls the functions of one filter in random order with good, hostile and no numbers, and judges after each
 * call what the filter's header says of its status.  attack_calls.h is printed from the manifest and the header of the
 * filter: its structs and their boxes, and for each function how its arguments are drawn and how it is called.
 * attack CALLS SEED prints how often each function answered what, and each kind of break with its first call. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boresight_filter.h"

/* A field of a struct of numbers: where it begins, how long it is, the range of its norm or zeros. */
typedef struct {
    int start;
    int size;
    double least;
    double most;
} attack_field;

/* A struct that consists of numbers, with its box. */
typedef struct {
    bs_real *values;
    int size;
    const double *low;
    const double *high;
    const attack_field *fields;
    int count;
} attack_struct;

/* How numbers are drawn; of a hostile call one number of a struct, or all of them, are beyond all reason. */
enum { GENTLE, ANYWHERE, CORNER, TINY, ONE_HOSTILE, ALL_HOSTILE };

/* What a filter is put through from one beginning to the next; coasting is nothing but propagation. */
enum { REALISTIC, WILD, COASTING };

static uint64_t attack_state;
static int mode;
static int regime;

static uint64_t drawn(void)
{
    uint64_t z;
    attack_state += 0x9E3779B97F4A7C15U;
    z = attack_state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

static int below(int n)
{
    return (int)(drawn() % (uint64_t)n);
}

static double share(void)
{
    return (double)(drawn() >> 11U) * 1.1102230246251565e-16;
}

/* In (0, 1], as likely in each octave down to 2^-octaves. */
static double octaves(int count)
{
    static const double power[8] = { 1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0078125 };
    const int k = below(count);
    double value = power[k % 8] * (1.0 - (0.5 * share()));
    for (int i = 0; i < k / 8; ++i) {
        value *= 0.00390625;
    }
    return value;
}

static bs_real hostile(void)
{
    static const double values[] = { 0.0, -0.0, 1.0, -1.0, 1e-30, -1e-30, 1e30, -1e30, 3e38, -3e38, 1e9, -1e9 };
    volatile double zero = 0.0;
    const int which = below(16);
    double value = zero / zero;
    if (which < 12) {
        value = values[which];
    } else if (which < 14) {
        value = ((which == 12) ? 1.0 : -1.0) / zero;
    }
    return (bs_real)value;
}

static bs_real in_box(double value, double low, double high)
{
    return (bs_real)((value < low) ? low : ((value > high) ? high : value));
}

static bs_real number(double low, double high)
{
    const double centre = ((low <= 0.0) && (high >= 0.0)) ? 0.0 : (low + high) / 2.0;
    double value = 0.0;
    switch (mode) {
    case ANYWHERE:
        value = low + ((high - low) * share());
        break;
    case CORNER:
        value = (below(2) != 0) ? low : high;
        break;
    case TINY:
        value = ((below(2) != 0) ? 1.0 : -1.0) * ((below(2) != 0) ? 1e-40 : 1.2e-38) * share();
        break;
    default:
        if (low > 0.0) { /* a length of time */
            value = (regime == COASTING) ? (high * (1.0 - (0.5 * share()))) : (high * octaves(24));
        } else if (low < 0.0) {
            value = centre + (((high - low) / 2.0) * octaves(24) * ((below(2) != 0) ? 1.0 : -1.0));
        } else {
            value = high * octaves(24);
        }
        break;
    }
    return in_box(value, low, high);
}

static void draw_struct(const attack_struct *given)
{
    for (int i = 0; i < given->size; ++i) {
        given->values[i] = (mode == ALL_HOSTILE) ? hostile() : number(given->low[i], given->high[i]);
    }
    if (mode < TINY || mode == ONE_HOSTILE) {
        for (int f = 0; f < given->count; ++f) {
            const attack_field *const field = &given->fields[f];
            double sum = 0.0;
            double length = 1.0;
            double wanted = 0.0;
            if (field->most <= 0.0) {
                continue;
            }
            given->values[field->start] += (bs_real)0.01; /* of zeros there is no direction */
            for (int i = 0; i < field->size; ++i) {
                sum += (double)given->values[field->start + i] * (double)given->values[field->start + i];
            }
            for (int i = 0; i < 40; ++i) { /* a root without a library */
                length = (length + (sum / length)) / 2.0;
            }
            wanted = field->least + ((field->most - field->least) * ((mode == CORNER) ? (double)below(2) : share()));
            for (int i = 0; i < field->size; ++i) {
                given->values[field->start + i] = (bs_real)((double)given->values[field->start + i] / length * wanted);
            }
        }
    }
    if (mode == ONE_HOSTILE) {
        given->values[below(given->size)] = hostile();
    }
}

/* Numbers that have no box but a size. */
static void draw_numbers(bs_real *values, int n, double size, int sign)
{
    for (int i = 0; i < n; ++i) {
        const double value = size * octaves(40) * (((sign != 0) && (below(2) != 0)) ? -1.0 : 1.0);
        values[i] = (mode == ALL_HOSTILE) ? hostile() : (bs_real)value;
    }
    if (mode == ONE_HOSTILE) {
        values[below(n)] = hostile();
    }
}

/* Variances of m rows, or with `full` a covariance of them. */
static void draw_noise(bs_real *R, int m, int full)
{
    if (full == 0) {
        draw_numbers(R, m, 1e3, 0);
        return;
    }
    draw_numbers(R, m * m, 1e3, 0);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < m; ++j) {
            if ((i != j) && (mode < ONE_HOSTILE)) {
                R[(i * m) + j] = (bs_real)0.0;
            }
        }
    }
}

static void draw_bytes(unsigned char *bytes, size_t n)
{
    for (size_t i = 0U; i < n; ++i) {
        bytes[i] = (unsigned char)((mode < ONE_HOSTILE) ? ((below(8) == 0) ? 1 : 0) : below(256));
    }
}

static int draw_int(int most)
{
    static const int values[] = { -2147483647, -1, 0, 1, 2147483647 };
    return (mode < ONE_HOSTILE) ? (1 + below(most)) : values[below(5)];
}

static unsigned int draw_rows(void)
{
    return (below(4) != 0) ? BS_ALL_ROWS : (unsigned int)(drawn() & 0xFFU);
}

static bs_real draw_gate(void)
{
    static const double values[] = { 0.0, 0.0, 5.0, 5.0, 1.0, 0.001 };
    return (mode < ONE_HOSTILE) ? (bs_real)values[below(6)] : hostile();
}

static void draw_gates(bs_gates *gates)
{
    gates->rows = draw_rows();
    gates->gate = draw_gate();
    gates->joint = draw_gate();
    gates->iterations = draw_int(4);
    gates->options = (unsigned int)below((mode < ONE_HOSTILE) ? 4 : 6);
}

static void draw_sigmas(bs_real *sigma, int n, const double *high)
{
    for (int i = 0; i < n; ++i) {
        sigma[i] = (mode == ALL_HOSTILE) ? hostile() : (bs_real)(high[i] * octaves((regime == WILD) ? 40 : 20));
    }
    if (regime == WILD) {
        sigma[below(n)] *= (bs_real)1e3;
    }
    if (mode == ONE_HOSTILE) {
        sigma[below(n)] = hostile();
    }
}

/* A covariance: of independent states, or of sums of a few sources; or what is none. */
static void draw_covariance(bs_real *P, int n, const double *high)
{
    bs_real sigma[64];
    const int saved = mode;
    const int dependent = below(2);
    mode = GENTLE;
    draw_sigmas(sigma, n, high);
    for (int i = 0; i < (n * n); ++i) {
        P[i] = (bs_real)0.0;
    }
    for (int i = 0; i < n; ++i) {
        P[(i * n) + i] = sigma[i] * sigma[i];
    }
    for (int k = 0; (k < 3) && (dependent != 0); ++k) {
        double part[64];
        for (int i = 0; i < n; ++i) {
            part[i] = (double)sigma[i] * ((2.0 * share()) - 1.0);
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                P[(i * n) + j] += (bs_real)(part[i] * part[j]);
            }
        }
    }
    mode = saved;
    if (mode == ONE_HOSTILE) {
        P[below(n * n)] = hostile();
    } else if (mode == ALL_HOSTILE) {
        for (int i = 0; i < (n * n); ++i) {
            P[i] = hostile();
        }
    }
}

static int finite(const bs_real *values, int n)
{
    int all = 1;
    for (int i = 0; i < n; ++i) {
        all = all && ((values[i] - values[i]) <= (bs_real)0.0);
    }
    return all;
}

/* Of the rows that a measurement has taken. */
static int rows_finite(const bs_real *nu, const bs_real *S, unsigned int used)
{
    int all = 1;
    for (unsigned int i = 0U; (used >> i) != 0U; ++i) {
        all = all && ((((used >> i) & 1U) == 0U) || (finite(&nu[i], 1) && finite(&S[i], 1)));
    }
    return all;
}

/* The same in blocks along the diagonal. */
static void draw_blocks(bs_real *blocks, const int *sizes, int count, const double *high)
{
    for (int i = 0; i < count; ++i) {
        draw_covariance(blocks, sizes[i], high);
        blocks = &blocks[sizes[i] * sizes[i]];
        high = &high[sizes[i]];
    }
}

/* A covariance of some states, if there are any such. */
static void draw_block(bs_real *block, int first, int count, int n, const double *high)
{
    const int some = (first >= 0) && (count >= 1) && (count <= (n - first));
    draw_covariance(block, (some != 0) ? count : n, (some != 0) ? &high[first] : high);
}

/* Bytes that another call has left, of which a hostile one changes one. */
static void change_byte(unsigned char *bytes, size_t n)
{
    if (mode >= ONE_HOSTILE) {
        bytes[below((int)n)] = (unsigned char)below(256);
    }
}

#include "attack_calls.h"

/* ------------------------------------------------------------------------------------------------ the judge */

enum {
    UNKNOWN_STATUS,
    NULL_TAKEN,
    NAV_WRITTEN,
    X_WRITTEN,
    P_WRITTEN,
    NAV_NOT_FINITE,
    NAV_BEYOND,
    X_NOT_FINITE,
    P_NOT_FINITE,
    NEGATIVE,
    OUTPUT_NOT_FINITE,
    ROWS_STAY,
    BREAKS
};
static const char *const words[BREAKS] = {
    "a status that there is not",     "a null pointer is taken",     "refused, and nav is written",
    "refused, and x is written",      "refused, and P is written",   "OK, and nav is not finite",
    "OK, and nav is out of its box",  "OK, and x is not finite",     "OK, and P is not finite",
    "OK, and a variance is negative", "OK, and an output is not finite", "refused, and the innovation is written",
};

static attack_filter was; /* before the call */
static int64_t answers[ATTACK_FUNCTIONS][16];
static int64_t broken[ATTACK_FUNCTIONS][BREAKS][2];
static int64_t first_broken[ATTACK_FUNCTIONS][BREAKS][2];

static int negative_variance(void)
{
    int found = 0;
    for (int j = 0; j < ATTACK_N; ++j) { /* column after column of the upper triangle; of UD its diagonal is D */
        found = found || (filter.P[((j * (j + 3)) / 2)] < (bs_real)0.0);
    }
    return found;
}

static int nav_beyond(void)
{
    int found = 0;
    for (int s = 0; s < ATTACK_CARRIED; ++s) {
        const attack_struct *const box = &carried[s];
        for (int i = 0; i < box->size; ++i) {
            found = found || (box->values[i] < (bs_real)box->low[i]) || (box->values[i] > (bs_real)box->high[i]);
        }
        for (int f = 0; f < box->count; ++f) {
            const attack_field *const field = &box->fields[f];
            double sum = 0.0;
            for (int i = 0; i < field->size; ++i) {
                sum += (double)box->values[field->start + i] * (double)box->values[field->start + i];
            }
            /* the sum is rounded in the filter's own precision */
            if (field->most > 0.0) {
                found = found || (sum < (field->least * field->least * (1.0 - ATTACK_ROUNDING)));
                found = found || (sum > (field->most * field->most * (1.0 + ATTACK_ROUNDING)));
            }
        }
    }
    return found;
}

static int carried_differs(void)
{
    int found = 0;
    for (int s = 0; s < ATTACK_CARRIED; ++s) {
        const size_t offset = (size_t)((const unsigned char *)carried[s].values - (const unsigned char *)&filter);
        const unsigned char *const old = (const unsigned char *)&was + offset;
        found = found || (memcmp(carried[s].values, old, (size_t)carried[s].size * sizeof(bs_real)) != 0);
    }
    return found;
}

static int nav_finite(void)
{
    int all = 1;
    for (int s = 0; s < ATTACK_CARRIED; ++s) {
        all = all && finite(carried[s].values, carried[s].size);
    }
    return all;
}

/* Counts what the call has broken of the header's sentence; how many things that is. */
static int judge(int function, int status, int null, int spoilt, int64_t call)
{
    int found[BREAKS] = { 0 };
    int count = 0;
    const int taken = (status == (int)BS_OK) || (status == ATTACK_AT_CEILING);
    found[UNKNOWN_STATUS] = (status < 0) || (status > ATTACK_LAST_STATUS);
    found[NULL_TAKEN] = (null >= 0) && (status != (int)BS_NULL_POINTER);
    if (taken && (reads[function] != 0)) {
        found[OUTPUT_NOT_FINITE] = !outputs_finite(function); /* of what it does not read it says nothing */
    } else if (taken) {
        found[NAV_NOT_FINITE] = !nav_finite();
        found[NAV_BEYOND] = nav_beyond();
        if ((navigates[function] == 0) || (spoilt == 0)) {
            found[X_NOT_FINITE] = !finite(filter.x, ATTACK_N);
            found[P_NOT_FINITE] = !finite(filter.P, ATTACK_PACKED);
            found[NEGATIVE] = negative_variance();
        }
        found[OUTPUT_NOT_FINITE] = !outputs_finite(function);
    } else {
        found[NAV_WRITTEN] = carried_differs();
        found[X_WRITTEN] = memcmp(filter.x, was.x, sizeof(was.x)) != 0;
        found[P_WRITTEN] = memcmp(filter.P, was.P, sizeof(was.P)) != 0;
        found[ROWS_STAY] = (null < 0) && rows_stay(function);
    }
    for (int k = 0; k < BREAKS; ++k) {
        if (found[k]) {
            if (broken[function][k][spoilt] == 0) {
                first_broken[function][k][spoilt] = call;
            }
            ++broken[function][k][spoilt];
            ++count;
        }
    }
    return count;
}

/* A number of what the filter holds, or a byte of it, is changed behind its back. */
static void spoil(void)
{
    const int which = below(4);
    if ((which == 0) && (ATTACK_CARRIED > 0)) { /* a total state carries no nav */
        const attack_struct *const box = &carried[below(ATTACK_CARRIED > 0 ? ATTACK_CARRIED : 1)];
        box->values[below(box->size)] = hostile();
    } else if (which == 1) {
        filter.x[below(ATTACK_N)] = hostile();
    } else if (which == 2) {
        filter.P[below(ATTACK_PACKED)] = hostile();
    } else {
        ((unsigned char *)&filter)[below((int)sizeof(filter))] = (unsigned char)below(256);
    }
}

static void draw_mode(void)
{
    const int luck = below(1000);
    if (regime != WILD) {
        mode = (luck < 2) ? ONE_HOSTILE : GENTLE;
    } else {
        mode = (luck < 400)   ? GENTLE
               : (luck < 650) ? ANYWHERE
               : (luck < 800) ? CORNER
               : (luck < 870) ? TINY
               : (luck < 950) ? ONE_HOSTILE
                              : ALL_HOSTILE;
    }
}

/* A filter that is sound, in a new regime; whether the answer to that was sound too is judged as any other. */
static int64_t begin(void)
{
    int status = -1;
    regime = (below(64) == 0) ? COASTING : below(COASTING);
    (void)memset(&filter, 0, sizeof(filter));
    for (int i = 0; (i < 1000) && (status != (int)BS_OK); ++i) {
        mode = GENTLE;
        prepare(ATTACK_INIT);
        status = (int)called(ATTACK_INIT, &filter, -1);
    }
    return (regime == COASTING) ? 8192 : (1 << below(12)); /* nearly a day, of steps of up to 10 s */
}

static int drawn_function(void)
{
    int total = 0;
    int left;
    int function = 0;
    for (int i = 0; i < ATTACK_FUNCTIONS; ++i) {
        total += ((regime == COASTING) && (coasts[i] == 0)) ? 0 : weights[i];
    }
    left = below(total);
    while (function < (ATTACK_FUNCTIONS - 1)) {
        left -= ((regime == COASTING) && (coasts[function] == 0)) ? 0 : weights[function];
        if (left < 0) {
            break;
        }
        ++function;
    }
    return function;
}

int main(int argc, char **argv)
{
    const int64_t calls = (argc > 1) ? (int64_t)atoll(argv[1]) : 0;
    int64_t left = 0; /* calls until the filter begins anew */
    int spoilt = 0;
    attack_state = (argc > 2) ? (uint64_t)atoll(argv[2]) : 0U;
    for (int64_t call = 0; call < calls; ++call) {
        int function;
        int null = -1;
        int status;
        if (left <= 0) {
            left = begin();
            spoilt = 0;
        }
        --left;
        if ((regime == WILD) && (below(300) == 0)) {
            spoil();
            spoilt = 1;
            left = (left < 12) ? left : 12;
        }
        function = drawn_function();
        draw_mode();
        prepare(function);
        if (below(200) == 0) {
            null = below(pointers[function]);
        }
        was = filter;
        status = (int)called(function, (null == 0) ? NULL : &filter, null);
        ++answers[function][(status >= 0) && (status < 16) ? status : 15];
        if ((begins[function] != 0) && (status == (int)BS_OK)) {
            spoilt = 0;
        }
        if (judge(function, status, null, spoilt, call) != 0) {
            left = 0;
        }
    }
    for (int i = 0; i < ATTACK_FUNCTIONS; ++i) {
        for (int s = 0; s < 16; ++s) {
            if (answers[i][s] != 0) {
                (void)printf("answer\t%s\t%d\t%lld\n", names[i], s, (long long)answers[i][s]);
            }
        }
        for (int k = 0; k < BREAKS; ++k) {
            for (int s = 0; s < 2; ++s) {
                if (broken[i][k][s] != 0) {
                    (void)printf("%s\t%s: %s\t%lld\t%lld\n", (s != 0) ? "spoilt" : "breaks", names[i], words[k],
                                 (long long)broken[i][k][s], (long long)first_broken[i][k][s]);
                }
            }
        }
    }
    return 0;
}

/* Random numbers that depend on a seed and a run alone: Philox 4x64-10, whose words are those of numpy.random.Philox,
 * and normal numbers of them by Box and Muller, with equal bits on every machine and at every width of the lanes. */
#include <stdint.h>
#include <string.h>

#include "boresight_lanes.h"

#ifndef BORESIGHT_ONE_LANE /* whose own header has these without extensions of gcc and clang */
__extension__ typedef unsigned __int128 product;
typedef unsigned long long words __attribute__((vector_size(8 * BORESIGHT_LANES)));
#define AS_LANES(w) ((bs_lanes)(w))
#define AS_WORDS(x) ((words)(x))
static inline uint64_t multiplied(uint64_t a, uint64_t b, uint64_t *upper)
{
    const product both = (product)a * b;
    *upper = (uint64_t)(both >> 64);
    return (uint64_t)both;
}
static inline words taken(const uint64_t *from)
{
    words w;
    memcpy(&w, from, sizeof w);
    return w;
}
static inline void put(bs_lanes x, double *to)
{
    memcpy(to, &x, sizeof x);
}
#define GROUPS 16 /* of eight words, made at a time */
#define ROLLED
#define ROLLED_BY_TWO
#endif

void boresight_words(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                     uint64_t *out, ptrdiff_t run_stride, ptrdiff_t stride);
void boresight_normals(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                       double *out, ptrdiff_t run_stride, ptrdiff_t stride, const double *scale, const double *offset);

/* Block number `counter` of a run: its first has the counter 1, as NumPy counts before it draws. */
static inline void philox(uint64_t seed, uint64_t run, uint64_t stream, uint64_t counter, uint64_t word[4])
{
    uint64_t a = counter;
    uint64_t b = 0U;
    uint64_t c = 0U;
    uint64_t d = stream;
    ROLLED
    for (int round = 0; round < 10; ++round) {
        uint64_t left;
        uint64_t right;
        const uint64_t left_low = multiplied(a, 0xD2E7470EE14C6C93U, &left);
        const uint64_t right_low = multiplied(c, 0xCA5A826395121157U, &right);
        a = right ^ b ^ seed;
        b = right_low;
        c = left ^ d ^ run;
        d = left_low;
        seed += 0x9E3779B97F4A7C15U;
        run += 0xBB67AE8584CAA73BU;
    }
    word[0] = a;
    word[1] = b;
    word[2] = c;
    word[3] = d;
}

void boresight_words(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                     uint64_t *out, ptrdiff_t run_stride, ptrdiff_t stride)
{
    for (size_t r = 0U; r < runs; ++r) {
        for (size_t i = 0U; i < count;) {
            uint64_t word[4];
            philox(seed, run[r], stream, ((first + i) / 4U) + 1U, word);
            for (uint64_t k = (first + i) % 4U; (k < 4U) && (i < count); ++k, ++i) {
                out[((ptrdiff_t)r * run_stride) + ((ptrdiff_t)i * stride)] = word[k];
            }
        }
    }
}

/* Coefficients in falling powers. */
BS_INLINE bs_lanes polynomial(const double *coefficient, int n, bs_lanes x)
{
    bs_lanes sum = bs_all_of(coefficient[0]);
    for (int i = 1; i < n; ++i) {
        sum = coefficient[i] + (x * sum);
    }
    return sum;
}

/* Of each word of a group two normal numbers by Box and Muller, the second one eight places behind the first.  The
 * word's upper 40 bits are the radius, of at most 7.54; of the others two are the quadrant, and 22 the angle in it. */
static void transform(const uint64_t word[8], double normal[16])
{
    static const double of_log[] = { 0.29590730292999929, 0.3062822174287304, 0.3636712376750626, 0.44444396441372136,
                                     0.57142857483775966, 0.79999999998834127, 1.3333333333333468, 4.0 };
    static const double of_sine[] = { -1.5895975029828002e-10, 2.505074281422434e-08, -2.7557313585030056e-06,
                                      0.0001984126982946497, -0.008333333333321924, 0.1666666666666663 };
    static const double of_cosine[] = { -1.1358764866516342e-11, 2.0875705689505815e-09, -2.7557314219059267e-07,
                                        2.4801587289008097e-05, -0.0013888888888873348, 0.041666666666666595 };
    ROLLED_BY_TWO
    for (int i = 0; i < 8; i += BORESIGHT_LANES) {
        const words w = taken(&word[i]);
        /* u, in the middle between two multiples of 2^-40, is 2^k (1 + f), with 1 + f from sqrt(1/2) to sqrt(2) */
        const bs_lanes u = AS_LANES(((w >> 12U) & 0x000FFFFFFFFFF000U) | 0x3FF0000000000800U) - 1.0;
        const words above = AS_WORDS(u) + (0x3FF0000000000000U - 0x3FE6A09E667F3BCDU);
        const bs_lanes k = AS_LANES((above >> 52U) | 0x4330000000000000U) - (4503599627370496.0 + 1023.0);
        const bs_lanes f = AS_LANES((above & 0x000FFFFFFFFFFFFFU) + 0x3FE6A09E667F3BCDU) - 1.0;
        const bs_lanes s = f / (2.0 + f);
        const bs_lanes root = bs_root((k * -1.3862943611198906) - (s * polynomial(of_log, 8, s * s))); /* -2 log u */
        const bs_lanes radius = AS_LANES(AS_WORDS(root) ^ ((w << 40U) & 0x8000000000000000U)); /* a half turn on */
        const bs_lanes angle = (AS_LANES(((w & 0x3FFFFFU) << 30U) | 0x3FF0000020000000U) - 1.5) * 1.5707963267948966;
        const bs_lanes y = angle * angle;
        const bs_lanes sine = angle - ((angle * y) * polynomial(of_sine, 6, y));
        const bs_lanes cosine = 1.0 - (y * (0.5 - (y * polynomial(of_cosine, 6, y))));
        const bs_bits across = -(bs_bits)((w >> 22U) & 1U);
        put(radius * bs_choose(across, sine, cosine), &normal[i]);
        put(radius * bs_choose(across, cosine, sine), &normal[8 + i]);
    }
}

void boresight_normals(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                       double *out, ptrdiff_t run_stride, ptrdiff_t stride, const double *scale, const double *offset)
{
    for (size_t r = 0U; r < runs; ++r) {
        size_t begin = (size_t)(first % 16U); /* the first of a group that is wanted */
        for (size_t i = 0U; i < count; begin = 0U) {
            const size_t left = begin + (count - i);
            const size_t end = (left < (16U * GROUPS)) ? left : (16U * GROUPS);
            const uint64_t block = 2U * ((first + i) / 16U);
            uint64_t word[8 * GROUPS];
            double normal[16 * GROUPS];
            for (size_t k = 0U; k < (2U * ((end + 15U) / 16U)); ++k) {
                philox(seed, run[r], stream, block + k + 1U, &word[4U * k]);
            }
            for (size_t k = 0U; k < end; k += 16U) {
                transform(&word[k / 2U], &normal[k]);
            }
            double *const to = &out[((ptrdiff_t)r * run_stride) + ((ptrdiff_t)i * stride)];
            for (size_t k = 0U; k < (end - begin); ++k) {
                to[(ptrdiff_t)k * stride] = (normal[begin + k] * scale[i + k]) + offset[i + k];
            }
            i += end - begin;
        }
    }
}

#ifdef BORESIGHT_ONE_LANE
/* The group that the next number begins. */
static APART void draw(boresight_numbers *numbers)
{
    uint64_t word[8];
    const uint64_t block = 2U * (numbers->next / 16U);
    ROLLED
    for (uint64_t i = 0U; i < 2U; ++i) {
        philox(numbers->seed, numbers->run, numbers->stream, block + i + 1U, &word[4U * i]);
    }
    transform(word, numbers->held);
}

void boresight_next(boresight_numbers *numbers, size_t count, double *out, const double *scale, const double *offset)
{
    for (size_t i = 0U; i < count; ++i) {
        const size_t k = (size_t)(numbers->next % 16U);
        if (k == 0U) {
            draw(numbers);
        }
        out[i] = numbers->held[k];
        ++numbers->next;
    }
    for (size_t i = 0U; i < count; ++i) {
        out[i] = (out[i] * scale[i]) + offset[i];
    }
}
#endif

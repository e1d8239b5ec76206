/* Random numbers that depend on a seed and a run alone: Philox 4x64-10, whose words are those of numpy.random.Philox,
 * and normal numbers of them by Box and Muller, with equal bits on every machine and at every width of the lanes. */
#include <stdint.h>

#include "boresight_math.h"

#include "boresight_lanes.h"

__extension__ typedef unsigned __int128 product;

#define BLOCKS 32 /* of four words, made at a time */

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
    for (int round = 0; round < 10; ++round) {
        const product left = (product)a * 0xD2E7470EE14C6C93U;
        const product right = (product)c * 0xCA5A826395121157U;
        a = (uint64_t)(right >> 64) ^ b ^ seed;
        b = (uint64_t)right;
        c = (uint64_t)(left >> 64) ^ d ^ run;
        d = (uint64_t)left;
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

/* Of each pair of words two normal numbers: the angle is in [-pi, pi), the radius at most 8.5. */
static void transform(const uint64_t word[4 * BLOCKS], double normal[4 * BLOCKS])
{
    for (int i = 0; i < (4 * BLOCKS); i += 2 * BORESIGHT_LANES) {
        bs_bits one;
        bs_bits other;
        bs_lanes sine;
        bs_lanes cosine;
        for (int l = 0; l < BORESIGHT_LANES; ++l) {
            one[l] = (long long)(word[i + (2 * l)] >> 12U);
            other[l] = (long long)(word[i + (2 * l) + 1] >> 12U);
        }
        const bs_lanes u = 2.0 - (bs_lanes)(one | 0x3FF0000000000000LL); /* in (0, 1] */
        const bs_lanes radius = bs_root(-2.0 * bs_log_lanes(u));
        bs_sincos_lanes(((bs_lanes)(other | 0x3FF0000000000000LL) - 1.5) * 6.283185307179586, &sine, &cosine);
        cosine *= radius;
        sine *= radius;
        for (int l = 0; l < BORESIGHT_LANES; ++l) {
            normal[i + (2 * l)] = cosine[l];
            normal[i + (2 * l) + 1] = sine[l];
        }
    }
}

void boresight_normals(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                       double *out, ptrdiff_t run_stride, ptrdiff_t stride, const double *scale, const double *offset)
{
    for (size_t r = 0U; r < runs; ++r) {
        uint64_t begin = first % 4U; /* the first of a block that is wanted */
        for (size_t i = 0U; i < count; begin = 0U) {
            const size_t left = (size_t)begin + (count - i);
            const size_t end = (left < (4U * BLOCKS)) ? left : (4U * BLOCKS);
            uint64_t word[4 * BLOCKS] = { 0U };
            double normal[4 * BLOCKS];
            for (size_t k = 0U; k < ((end + 3U) / 4U); ++k) {
                philox(seed, run[r], stream, ((first + i) / 4U) + k + 1U, &word[4U * k]);
            }
            transform(word, normal);
            for (size_t k = (size_t)begin; k < end; ++k, ++i) {
                out[((ptrdiff_t)r * run_stride) + ((ptrdiff_t)i * stride)] = (normal[k] * scale[i]) + offset[i];
            }
        }
    }
}

/* boresight_lanes.h of one run: what random.c asks of lanes, for compilers that have no vectors. */
#ifndef BORESIGHT_LANES_H
#define BORESIGHT_LANES_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "run.h"

#define BORESIGHT_ONE_LANE
#define BORESIGHT_LANES 1
#define GROUPS 1 /* of random numbers, in a thread's own memory */
#ifdef __CUDACC_RTC__
#define ROLLED _Pragma("unroll 1") /* what is long does not fit into the instruction cache */
#define ROLLED_BY_TWO _Pragma("unroll 2")
#define APART __noinline__
#else
#define ROLLED
#define ROLLED_BY_TWO
#define APART
#endif
#define BS_INLINE static inline

typedef double bs_lanes;
typedef long long bs_bits;
typedef uint64_t words;

static inline bs_lanes AS_LANES(words w)
{
    bs_lanes x;
    memcpy(&x, &w, sizeof x);
    return x;
}

static inline words AS_WORDS(bs_lanes x)
{
    words w;
    memcpy(&w, &x, sizeof w);
    return w;
}

static inline words taken(const uint64_t *from)
{
    return *from;
}

static inline void put(bs_lanes x, double *to)
{
    *to = x;
}

/* The lower half of the product. */
static inline uint64_t multiplied(uint64_t a, uint64_t b, uint64_t *upper)
{
#ifdef __CUDACC_RTC__
    *upper = __umul64hi(a, b);
#else
    __extension__ typedef unsigned __int128 product;
    *upper = (uint64_t)(((product)a * b) >> 64);
#endif
    return a * b;
}

static inline bs_lanes bs_all_of(double same)
{
    return same;
}

static inline bs_lanes bs_choose(bs_bits condition, bs_lanes a, bs_lanes b)
{
    return (condition != 0) ? a : b;
}

static inline bs_lanes bs_root(bs_lanes x)
{
    return sqrt(x);
}
#endif

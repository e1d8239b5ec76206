/* runs.c - many runs of one experiment: one after the other on a host, each in its thread on a GPU. */
#include "run.h"

static void one_of(const double *given, uint64_t seed, uint64_t first, uint64_t i, uint64_t columns, double *rows,
                   unsigned char *status)
{
    status[i] = (unsigned char)boresight_run(given, seed, first + i, &rows[i * columns]);
}

#ifdef __CUDACC_RTC__
extern "C" __global__ void boresight_kernel(const double *given, uint64_t seed, uint64_t first, uint64_t n,
                                            uint64_t columns, double *rows, unsigned char *status)
{
    const uint64_t i = ((uint64_t)blockIdx.x * blockDim.x) + threadIdx.x;
    if (i < n) {
        one_of(given, seed, first, i, columns, rows, status);
    }
}
#else
void boresight_runs(const double *given, uint64_t seed, uint64_t first, uint64_t n, uint64_t columns, double *rows,
                    unsigned char *status)
{
    for (uint64_t i = 0U; i < n; ++i) {
        one_of(given, seed, first, i, columns, rows, status);
    }
}
#endif

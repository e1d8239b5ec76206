/* run.h - an experiment of `many` as C, which a GPU flies with one thread for each run.
 * The experiment's own file defines boresight_run.  It may call the functions of its model and those below, keeps
 * nothing from run to run, and computes by + - * / and square root alone, and by boresight_math.h. */
#ifndef BORESIGHT_RUN_H
#define BORESIGHT_RUN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Final states of one run, a number for each column; not finite where it is lost.
 * in   given  what the experiment's function `given` returned
 * returns 0, or the status with which the run ended */
int boresight_run(const double *given, uint64_t seed, uint64_t run, double *row);

/* Runs first to first + n - 1: columns numbers each to `rows`, a status each to `status`. */
void boresight_runs(const double *given, uint64_t seed, uint64_t first, uint64_t n, uint64_t columns, double *rows,
                    unsigned char *status);

/* Random numbers first to first + count - 1 of each run, as of boresight.runtime.random; those of run r go to out[r *
 * run_stride + i * stride]. */
void boresight_words(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                     uint64_t *out, ptrdiff_t run_stride, ptrdiff_t stride);
void boresight_normals(uint64_t seed, const uint64_t *run, size_t runs, uint64_t stream, uint64_t first, size_t count,
                       double *out, ptrdiff_t run_stride, ptrdiff_t stride, const double *scale, const double *offset);

/* Normal numbers of a run one after the other, those of boresight_normals from number 0 on; made sixteen at a time.
 * Begins as { seed, run, stream, 0U, { 0.0 } }. */
typedef struct {
    uint64_t seed;
    uint64_t run;
    uint64_t stream;
    uint64_t next;   /* the number of the next one */
    double held[16]; /* those of the group that it is in */
} boresight_numbers;

/* The next `count`, each times its scale and plus its offset. */
void boresight_next(boresight_numbers *numbers, size_t count, double *out, const double *scale, const double *offset);

#ifdef __cplusplus
}
#endif

#endif

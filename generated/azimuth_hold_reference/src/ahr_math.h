/* ahr_math.h - the elementary functions that the units of azimuth-hold-reference call.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty.
 * Those of boresight_math.h, with equal bits on every machine, under names of this model and
 * precision, so that several of either link into one program.
 * With BORESIGHT_LIBM the units call the target's library instead. */
#ifndef AHR_MATH_H
#define AHR_MATH_H

#include "boresight.h"

#ifndef BORESIGHT_LIBM
#ifdef BORESIGHT_FLOAT
#define BS_SINCOS ahr_sincos_f32
#define BS_COS ahr_cos_f32
#define BS_SIN ahr_sin_f32
#else
#define BS_SINCOS ahr_sincos
#define BS_COS ahr_cos
#define BS_SIN ahr_sin
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* the same bits on every machine [AHR-M-001.sincos] */
void BS_SINCOS(bs_real angle, bs_real *sine, bs_real *cosine);
bs_real BS_COS(bs_real angle); /* the same bits on every machine [AHR-M-001.cos] */
bs_real BS_SIN(bs_real angle); /* the same bits on every machine [AHR-M-001.sin] */

#ifdef __cplusplus
}
#endif
#endif

#endif

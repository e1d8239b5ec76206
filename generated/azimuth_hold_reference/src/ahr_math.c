/* ahr_math.c - the elementary functions that the units of azimuth-hold-reference call.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty. */
#include "ahr_math.h"

#ifndef BORESIGHT_LIBM
#include "boresight_math.h"

void BS_SINCOS(bs_real angle, bs_real *sine, bs_real *cosine)
{
    /* [AHR-M-001.sincos] */
    bs_sincos(angle, sine, cosine);
}

bs_real BS_COS(bs_real angle)
{
    /* [AHR-M-001.cos] */
    return bs_cos(angle);
}

bs_real BS_SIN(bs_real angle)
{
    /* [AHR-M-001.sin] */
    return bs_sin(angle);
}
#endif

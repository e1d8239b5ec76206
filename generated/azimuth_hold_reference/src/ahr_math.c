/* ahr_math.c - the elementary functions that the units of azimuth-hold-reference call.  Generated
 * by Boresight: do not edit. */
#include "ahr_math.h"

#ifndef BORESIGHT_LIBM
#include "boresight_math.h"

void BS_SINCOS(bs_real angle, bs_real *sine, bs_real *cosine)
{
    bs_sincos(angle, sine, cosine);
}

bs_real BS_COS(bs_real angle)
{
    return bs_cos(angle);
}

bs_real BS_SIN(bs_real angle)
{
    return bs_sin(angle);
}
#endif

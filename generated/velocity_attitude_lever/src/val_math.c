/* val_math.c - the elementary functions that the units of velocity-attitude-lever call.  Generated
 * by Boresight: do not edit. */
#include "val_math.h"

#ifndef BORESIGHT_LIBM
#include "boresight_math.h"

void BS_SINCOS(bs_real angle, bs_real *sine, bs_real *cosine)
{
    bs_sincos(angle, sine, cosine);
}

bs_real BS_ATAN2(bs_real y, bs_real x)
{
    return bs_atan2(y, x);
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

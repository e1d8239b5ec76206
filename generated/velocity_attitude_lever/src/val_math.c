/* val_math.c - the elementary functions that the units of velocity-attitude-lever call.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty. */
#include "val_math.h"

#ifndef BORESIGHT_LIBM
#include "boresight_math.h"

void BS_SINCOS(bs_real angle, bs_real *sine, bs_real *cosine)
{
    /* [VAL-M-001.sincos] */
    bs_sincos(angle, sine, cosine);
}

bs_real BS_ATAN2(bs_real y, bs_real x)
{
    /* [VAL-M-001.atan2] */
    return bs_atan2(y, x);
}

bs_real BS_COS(bs_real angle)
{
    /* [VAL-M-001.cos] */
    return bs_cos(angle);
}

bs_real BS_SIN(bs_real angle)
{
    /* [VAL-M-001.sin] */
    return bs_sin(angle);
}
#endif

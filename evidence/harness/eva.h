/* eva.h - what the analysis may know of sine, cosine and arctangent.  Included before a unit, whose calls come here.
 * The bounds hold for a library that errs by a few units in the last place: cos(1.484) is 0.08668. */
#ifndef EVIDENCE_EVA_H
#define EVIDENCE_EVA_H

#include "__fc_builtin.h"
#include "boresight.h"

/*@ requires \is_finite(x);
    assigns \result \from x;
    ensures \is_finite(\result) && -1.0 <= \result <= 1.0; */
bs_real eva_sin(bs_real x);

/*@ requires \is_finite(x);
    assigns \result \from x;
    ensures \is_finite(\result) && -1.0 <= \result <= 1.0;
    behavior away_from_the_poles:
      assumes -1.484 <= x <= 1.484;
      ensures 0.0866 <= \result <= 1.0; */
bs_real eva_cos(bs_real x);

/*@ requires \is_finite(y) && \is_finite(x);
    assigns \result \from y, x;
    ensures \is_finite(\result) && -3.1416 <= \result <= 3.1416; */
bs_real eva_atan2(bs_real y, bs_real x);

#undef BS_SIN
#undef BS_COS
#undef BS_ATAN2
#define BS_SIN eva_sin
#define BS_COS eva_cos
#define BS_ATAN2 eva_atan2

#endif

/* eva.h - what the analysis may know of the functions that it has no value of.  Included before a
 * unit, whose calls come here.
 * The bounds hold for functions that err by a few units in the last place: cos(1.484) is 0.08668. */
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

/*@ requires \is_finite(x) && \valid(sine) && \valid(cosine);
    assigns *sine, *cosine \from x;
    ensures \initialized(sine) && \initialized(cosine);
    ensures \is_finite(*sine) && -1.0 <= *sine <= 1.0;
    ensures \is_finite(*cosine) && -1.0 <= *cosine <= 1.0;
    behavior away_from_the_poles:
      assumes -1.484 <= x <= 1.484;
      ensures 0.0866 <= *cosine <= 1.0; */
void eva_sincos(bs_real x, bs_real *sine, bs_real *cosine);

/*@ requires \is_finite(y) && \is_finite(x);
    assigns \result \from y, x;
    ensures \is_finite(\result) && -3.1416 <= \result <= 3.1416; */
bs_real eva_atan2(bs_real y, bs_real x);

/*@ requires \is_finite(x) && -1.0 <= x <= 1.0;
    assigns \result \from x;
    ensures \is_finite(\result) && -1.5708 <= \result <= 1.5708; */
bs_real eva_asin(bs_real x);

/*@ requires \is_finite(x) && -1.0 <= x <= 1.0;
    assigns \result \from x;
    ensures \is_finite(\result) && 0.0 <= \result <= 3.1416; */
bs_real eva_acos(bs_real x);

/*@ requires \is_finite(x);
    assigns \result \from x;
    ensures \is_finite(\result) && -1.5708 <= \result <= 1.5708; */
bs_real eva_atan(bs_real x);

/*@ requires \is_finite(x) && -710.0 <= x <= 710.0;
    assigns \result \from x;
    ensures \is_finite(\result); */
bs_real eva_sinh(bs_real x);

/*@ requires \is_finite(x) && -710.0 <= x <= 710.0;
    assigns \result \from x;
    ensures \is_finite(\result) && 1.0 <= \result; */
bs_real eva_cosh(bs_real x);

/*@ requires \is_finite(x);
    assigns \result \from x;
    ensures \is_finite(\result) && -1.0 <= \result <= 1.0; */
bs_real eva_tanh(bs_real x);

#undef BS_SIN
#undef BS_SINCOS
#undef BS_COS
#undef BS_ATAN2
#undef BS_ASIN
#undef BS_ACOS
#undef BS_ATAN
#undef BS_SINH
#undef BS_COSH
#undef BS_TANH
#define BS_SIN eva_sin
#define BS_SINCOS eva_sincos
#define BS_COS eva_cos
#define BS_ATAN2 eva_atan2
#define BS_ASIN eva_asin
#define BS_ACOS eva_acos
#define BS_ATAN eva_atan
#define BS_SINH eva_sinh
#define BS_COSH eva_cosh
#define BS_TANH eva_tanh

#endif

/* traitor.c - stands between the attack and one function of the filter of Euler matching, and breaks the header's
 * sentence in one of the ways that the attack judges, to show that it is seen.  The function itself is compiled under
 * the name sound_NAME. */
#include "euler_matching_filter.h"

bs_status sound_correct(em_filter *filter);
bs_status sound_covariance(const em_filter *filter, bs_real P[EM_N_STATES * EM_N_STATES]);
bs_status sound_measure_euler(em_filter *filter, const em_angles *angles, const bs_real R[3],
                              const bs_gates *gates, em_innovation *innovation);

static bs_real nothing(void)
{
    volatile bs_real zero = BS_REAL(0.0);
    return zero / zero;
}

bs_status em_filter_correct(em_filter *filter)
{
    bs_status status = sound_correct(filter);
    if (filter == NULL) {
        return (TRAITOR == 0) ? BS_OK : status;
    }
    switch (TRAITOR) {
    case 1:
        filter->nav.mu[0] = (status == BS_OK) ? nothing() : filter->nav.mu[0];
        break;
    case 2:
        filter->nav.mu[0] = (status == BS_OK) ? BS_REAL(0.51) : filter->nav.mu[0];
        break;
    case 3:
        filter->x[1] = (status == BS_OK) ? nothing() : filter->x[1];
        break;
    case 4:
        filter->P[1] = (status == BS_OK) ? nothing() : filter->P[1];
        break;
    case 5:
        filter->P[5] = (status == BS_OK) ? BS_REAL(-1e-30) : filter->P[5];
        break;
    case 6:
        filter->nav.mu[0] += BS_REAL(0.001);
        status = BS_OUT_OF_RANGE;
        break;
    case 7:
        filter->x[0] += BS_REAL(1.0);
        status = BS_OUT_OF_RANGE;
        break;
    case 8:
        filter->P[0] += BS_REAL(1.0);
        status = BS_OUT_OF_RANGE;
        break;
    case 9:
        status = (bs_status)12;
        break;
    default:
        break;
    }
    return status;
}

bs_status em_filter_covariance(const em_filter *filter, bs_real P[EM_N_STATES * EM_N_STATES])
{
    const bs_status status = sound_covariance(filter, P);
    if ((status == BS_OK) && (TRAITOR == 10)) {
        P[3] = nothing();
    }
    return status;
}

bs_status em_filter_measure_euler(em_filter *filter, const em_angles *angles, const bs_real R[3],
                                  const bs_gates *gates, em_innovation *innovation)
{
    const bs_status status = sound_measure_euler(filter, angles, R, gates, innovation);
    if ((status != BS_OK) && (innovation != NULL) && (TRAITOR == 11)) {
        innovation->used = 1U;
    }
    return status;
}

/* sd_compensated.c - increments with which the step of any model follows coning and sculling by
 * four samples instead of two; biases removed, the increments before stay as delivered.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty.
 * Derived from: the model strapdown, which states it.
 * 66 operations, list c0b9e992a31dbcbf. */
#include "strapdown.h"

BS_EXACT_BEGIN

#include "sd_compensated_kernel.h"

bs_status sd_compensated(const sd_imu *imu,
                         const sd_earlier *earlier,
                         bs_real dtheta_ib_b[3],
                         bs_real dv_b[3])
{
    /* dtheta_before_low, dtheta_second_low, dtheta_third_low too */
    static const bs_real dtheta_ib_b_low[3] = { BS_REAL(-0.5), BS_REAL(-0.5), BS_REAL(-0.5) };
    /* dtheta_before_high, dtheta_second_high, dtheta_third_high too */
    static const bs_real dtheta_ib_b_high[3] = { BS_REAL(0.5), BS_REAL(0.5), BS_REAL(0.5) };
    /* dv_before_low, dv_second_low, dv_third_low too */
    static const bs_real dv_b_low[3] = { BS_REAL(-100.0), BS_REAL(-100.0), BS_REAL(-100.0) };
    /* dv_before_high, dv_second_high, dv_third_high too */
    static const bs_real dv_b_high[3] = { BS_REAL(100.0), BS_REAL(100.0), BS_REAL(100.0) };
    bs_real dtheta_ib_b_nz[3];
    bs_real dv_b_nz[3];
    bs_status status;

    /* [SD-U-002.compensated] */
    if ((imu == NULL) || (earlier == NULL) || (dtheta_ib_b == NULL) || (dv_b == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [SD-U-010.compensated.dtheta_ib_b] */
    status = bs_check(imu->dtheta_ib_b, dtheta_ib_b_low, dtheta_ib_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dv_b] */
    status = bs_check(imu->dv_b, dv_b_low, dv_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dtheta_before] */
    status = bs_check(imu->dtheta_before, dtheta_ib_b_low, dtheta_ib_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dv_before] */
    status = bs_check(imu->dv_before, dv_b_low, dv_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dtheta_second] */
    status = bs_check(earlier->dtheta_second, dtheta_ib_b_low, dtheta_ib_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dv_second] */
    status = bs_check(earlier->dv_second, dv_b_low, dv_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dtheta_third] */
    status = bs_check(earlier->dtheta_third, dtheta_ib_b_low, dtheta_ib_b_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [SD-U-010.compensated.dv_third] */
    status = bs_check(earlier->dv_third, dv_b_low, dv_b_high, 3);
    if (status != BS_OK) {
        return status;
    }

    /* [SD-U-001.compensated] */
    sd_compensated_kernel(imu->dtheta_ib_b, imu->dv_b, imu->dtheta_before, imu->dv_before,
                          earlier->dtheta_second, earlier->dv_second, earlier->dtheta_third,
                          earlier->dv_third, dtheta_ib_b_nz, dv_b_nz);
    for (int i = 0; i < 3; ++i) {
        dtheta_ib_b[i] = dtheta_ib_b_nz[i];
    }
    for (int i = 0; i < 3; ++i) {
        dv_b[i] = dv_b_nz[i];
    }
    return BS_OK;
}

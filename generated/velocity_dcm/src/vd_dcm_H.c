/* vd_dcm_H.c - attitude of the master, H to first order in the misalignment: z = +e, e the turn
 * from the computed to the measured one; measurement matrix H = d z / d x; rows e, n, u.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty.
 * Equations: kim-2018 (5), kim-2018 (6).
 * 26 operations, list dbc5dbaec89221b4. */
#include "velocity_dcm.h"

BS_EXACT_BEGIN

#include "vd_dcm_H_kernel.h"

/* Checks, then the kernel: what both forms below share. */
BS_INSIDE bs_status vd_dcm_H_checked(const vd_master *master, bs_real H_nz[15])
{
    static const bs_real q_m2n_wxyz_low[4] = { BS_REAL(-1.001), BS_REAL(-1.001), BS_REAL(-1.001),
                                               BS_REAL(-1.001) };
    static const bs_real q_m2n_wxyz_high[4] = { BS_REAL(1.001), BS_REAL(1.001), BS_REAL(1.001),
                                                BS_REAL(1.001) };
    static const bs_real omega_nm_n_low[3] = { BS_REAL(-20.0), BS_REAL(-20.0), BS_REAL(-20.0) };
    static const bs_real omega_nm_n_high[3] = { BS_REAL(20.0), BS_REAL(20.0), BS_REAL(20.0) };
    bs_status status;
    /* [VD-U-002.dcm_H] */
    if ((master == NULL) || (H_nz == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [VD-U-010.dcm_H.q_m2n_wxyz] */
    status = bs_check(master->q_m2n_wxyz, q_m2n_wxyz_low, q_m2n_wxyz_high, 4);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-011.dcm_H.q_m2n_wxyz] */
    status = bs_check_norm(master->q_m2n_wxyz, BS_REAL(0.998001), BS_REAL(1.0020009999999997), 4);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-010.dcm_H.omega_nm_n] */
    status = bs_check(master->omega_nm_n, omega_nm_n_low, omega_nm_n_high, 3);
    if (status != BS_OK) {
        return status;
    }

    /* [VD-U-001.dcm_H] */
    vd_dcm_H_kernel(master->q_m2n_wxyz, master->omega_nm_n, H_nz);
    return BS_OK;
}

bs_status vd_dcm_H_nz(const vd_master *master, bs_real H_nz[15])
{
    /* [VD-U-004.dcm_H] */
    return vd_dcm_H_checked(master, H_nz);
}

bs_status vd_dcm_H(const vd_master *master, bs_real H[3 * VD_N_STATES])
{
    static const unsigned short H_index[15] = { 3, 6, 7, 8, 9, 14, 16, 17, 18, 19, 25, 26, 27, 28,
                                                29 };
    bs_real H_nz[15];
    bs_status status;
    /* [VD-U-002.dcm_H] */
    if (H == NULL) {
        return BS_NULL_POINTER;
    }
    status = vd_dcm_H_checked(master, H_nz);
    if (status == BS_OK) {
        /* [VD-U-003.dcm_H.H] */
        for (int i = 0; i < 30; ++i) {
            H[i] = BS_REAL(0.0);
        }
        BS_UNROLLED
        for (int i = 0; i < 15; ++i) {
            H[H_index[i]] = H_nz[i];
        }
    }
    return status;
}

/* vd_dcm_exact_H.c - attitude of the master, with h of finite rotations: z = +e, e the turn from
 * the computed to the measured one; measurement matrix H = d h / d x at x; rows e, n, u.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty.
 * Equations: kim-2018 (5).
 * 1255 operations, list fbef6e63dfbe80ec. */
#include "velocity_dcm.h"

BS_EXACT_BEGIN

#include "vd_dcm_exact_H_kernel.h"

/* Checks, then the kernel: what both forms below share. */
BS_INSIDE bs_status vd_dcm_exact_H_checked(const bs_real x[VD_N_STATES],
                                           const vd_nav *nav,
                                           const vd_master *master,
                                           bs_real H_nz[21])
{
    static const bs_real x_low[10] = { BS_REAL(-100.0), BS_REAL(-100.0), BS_REAL(-100.0),
                                       BS_REAL(-0.5), BS_REAL(-0.5), BS_REAL(-0.5), BS_REAL(-0.5),
                                       BS_REAL(-0.5), BS_REAL(-0.5), BS_REAL(-1.0) };
    static const bs_real x_high[10] = { BS_REAL(100.0), BS_REAL(100.0), BS_REAL(100.0),
                                        BS_REAL(0.5), BS_REAL(0.5), BS_REAL(0.5), BS_REAL(0.5),
                                        BS_REAL(0.5), BS_REAL(0.5), BS_REAL(1.0) };
    /* q_m2n_wxyz_low too */
    static const bs_real q_b2n_wxyz_low[4] = { BS_REAL(-1.001), BS_REAL(-1.001), BS_REAL(-1.001),
                                               BS_REAL(-1.001) };
    /* q_m2n_wxyz_high too */
    static const bs_real q_b2n_wxyz_high[4] = { BS_REAL(1.001), BS_REAL(1.001), BS_REAL(1.001),
                                                BS_REAL(1.001) };
    static const bs_real mu_low[3] = { BS_REAL(-0.5), BS_REAL(-0.5), BS_REAL(-0.5) };
    static const bs_real mu_high[3] = { BS_REAL(0.5), BS_REAL(0.5), BS_REAL(0.5) };
    static const bs_real omega_nm_n_low[3] = { BS_REAL(-20.0), BS_REAL(-20.0), BS_REAL(-20.0) };
    static const bs_real omega_nm_n_high[3] = { BS_REAL(20.0), BS_REAL(20.0), BS_REAL(20.0) };
    bs_status status;
    /* [VD-U-002.dcm_exact_H] */
    if ((x == NULL) || (nav == NULL) || (master == NULL) || (H_nz == NULL)) {
        return BS_NULL_POINTER;
    }
    /* [VD-U-010.dcm_exact_H.x] */
    status = bs_check(x, x_low, x_high, 10);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-010.dcm_exact_H.q_b2n_wxyz] */
    status = bs_check(nav->q_b2n_wxyz, q_b2n_wxyz_low, q_b2n_wxyz_high, 4);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-011.dcm_exact_H.q_b2n_wxyz] */
    status = bs_check_norm(nav->q_b2n_wxyz, BS_REAL(0.998001), BS_REAL(1.0020009999999997), 4);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-010.dcm_exact_H.mu] */
    status = bs_check(nav->mu, mu_low, mu_high, 3);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-010.dcm_exact_H.q_m2n_wxyz] */
    status = bs_check(master->q_m2n_wxyz, q_b2n_wxyz_low, q_b2n_wxyz_high, 4);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-011.dcm_exact_H.q_m2n_wxyz] */
    status = bs_check_norm(master->q_m2n_wxyz, BS_REAL(0.998001), BS_REAL(1.0020009999999997), 4);
    if (status != BS_OK) {
        return status;
    }
    /* [VD-U-010.dcm_exact_H.omega_nm_n] */
    status = bs_check(master->omega_nm_n, omega_nm_n_low, omega_nm_n_high, 3);
    if (status != BS_OK) {
        return status;
    }

    /* [VD-U-001.dcm_exact_H] */
    vd_dcm_exact_H_kernel(x, nav->q_b2n_wxyz, nav->mu, master->q_m2n_wxyz, master->omega_nm_n,
                          H_nz);
    return BS_OK;
}

bs_status vd_dcm_exact_H_nz(const bs_real x[VD_N_STATES],
                            const vd_nav *nav,
                            const vd_master *master,
                            bs_real H_nz[21])
{
    /* [VD-U-004.dcm_exact_H] */
    return vd_dcm_exact_H_checked(x, nav, master, H_nz);
}

bs_status vd_dcm_exact_H(const bs_real x[VD_N_STATES],
                         const vd_nav *nav,
                         const vd_master *master,
                         bs_real H[3 * VD_N_STATES])
{
    static const unsigned short H_index[21] = { 3, 4, 5, 6, 7, 8, 9, 13, 14, 15, 16, 17, 18, 19, 23,
                                                24, 25, 26, 27, 28, 29 };
    bs_real H_nz[21];
    bs_status status;
    /* [VD-U-002.dcm_exact_H] */
    if (H == NULL) {
        return BS_NULL_POINTER;
    }
    status = vd_dcm_exact_H_checked(x, nav, master, H_nz);
    if (status == BS_OK) {
        /* [VD-U-003.dcm_exact_H.H] */
        for (int i = 0; i < 30; ++i) {
            H[i] = BS_REAL(0.0);
        }
        BS_UNROLLED
        for (int i = 0; i < 21; ++i) {
            H[H_index[i]] = H_nz[i];
        }
    }
    return status;
}

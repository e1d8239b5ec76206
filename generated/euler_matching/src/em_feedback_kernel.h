/* em_feedback_kernel.h - attitude and misalignment with the estimated errors taken out.  Generated
 * by Boresight: do not edit.
 * Equations: song-lee-2001 (23), song-lee-2001 (24), song-lee-2001 (25).
 * 60 operations, list 1196297bff7e7947.  No branch, no check: call em_feedback, which has them. */
#ifndef EM_FEEDBACK_KERNEL_H
#define EM_FEEDBACK_KERNEL_H

#include "boresight.h"
#include "em_math.h"

static void em_feedback_kernel(const bs_real x[6],
                               const bs_real q_b2n_wxyz[4],
                               const bs_real mu[3],
                               bs_real q_b2n_wxyz_nz[4],
                               bs_real mu_nz[3])
{
    const bs_real t3 = x[2] * x[2];
    const bs_real t4 = BS_REAL(1e-30) + t3;
    const bs_real t6 = x[1] * x[1];
    const bs_real t7 = t4 + t6;
    const bs_real t9 = x[0] * x[0];
    const bs_real t10 = t7 + t9;
    const bs_real t11 = BS_SQRT(t10);
    const bs_real t12 = BS_REAL(0.5) * t11;
    bs_real t16;
    bs_real t13;
    BS_SINCOS(t12, &t16, &t13);
    const bs_real t15 = t13 * q_b2n_wxyz[0];
    const bs_real t17 = t16 / t11;
    const bs_real t19 = t17 * q_b2n_wxyz[3];
    const bs_real t20 = t19 * x[2];
    const bs_real t21 = t15 - t20;
    const bs_real t23 = t17 * q_b2n_wxyz[2];
    const bs_real t24 = t23 * x[1];
    const bs_real t25 = t21 - t24;
    const bs_real t26 = t17 * x[0];
    const bs_real t28 = t26 * q_b2n_wxyz[1];
    const bs_real t29 = t25 - t28;
    const bs_real t31 = t13 * q_b2n_wxyz[3];
    const bs_real t32 = t23 * x[0];
    const bs_real t33 = t31 + t32;
    const bs_real t34 = t17 * x[2];
    const bs_real t35 = t34 * q_b2n_wxyz[0];
    const bs_real t36 = t33 + t35;
    const bs_real t37 = t17 * x[1];
    const bs_real t38 = t37 * q_b2n_wxyz[1];
    const bs_real t39 = t36 - t38;
    const bs_real t40 = t39 * t39;
    const bs_real t41 = t13 * q_b2n_wxyz[2];
    const bs_real t42 = t34 * q_b2n_wxyz[1];
    const bs_real t43 = t41 + t42;
    const bs_real t44 = t37 * q_b2n_wxyz[0];
    const bs_real t45 = t43 + t44;
    const bs_real t46 = t19 * x[0];
    const bs_real t47 = t45 - t46;
    const bs_real t48 = t47 * t47;
    const bs_real t49 = t40 + t48;
    const bs_real t50 = t13 * q_b2n_wxyz[1];
    const bs_real t51 = t19 * x[1];
    const bs_real t52 = t50 + t51;
    const bs_real t53 = t26 * q_b2n_wxyz[0];
    const bs_real t54 = t52 + t53;
    const bs_real t55 = t23 * x[2];
    const bs_real t56 = t54 - t55;
    const bs_real t57 = t56 * t56;
    const bs_real t58 = t49 + t57;
    const bs_real t59 = t29 * t29;
    const bs_real t60 = t58 + t59;
    const bs_real t61 = BS_SQRT(t60);
    const bs_real t62 = BS_REAL(1.0) / t61;
    const bs_real t63 = t29 * t62;
    const bs_real t64 = t56 * t62;
    const bs_real t65 = t47 * t62;
    const bs_real t66 = t39 * t62;
    const bs_real t69 = mu[0] - x[3];
    const bs_real t72 = mu[1] - x[4];
    const bs_real t75 = mu[2] - x[5];
    q_b2n_wxyz_nz[0] = t63; /* q_w */
    q_b2n_wxyz_nz[1] = t64; /* q_x */
    q_b2n_wxyz_nz[2] = t65; /* q_y */
    q_b2n_wxyz_nz[3] = t66; /* q_z */
    mu_nz[0] = t69; /* mu_x */
    mu_nz[1] = t72; /* mu_y */
    mu_nz[2] = t75; /* mu_z */
}

#endif

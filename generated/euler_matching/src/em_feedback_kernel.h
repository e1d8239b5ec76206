/* em_feedback_kernel.h - attitude and misalignment with the estimated errors taken out.  Generated
 * by Boresight: do not edit.  Yours to use, change and pass on, without warranty.
 * Equations: song-lee-2001 (23), song-lee-2001 (24), song-lee-2001 (25).
 * 60 operations, list e518fbe30ba36eae.  No branch, no check: call em_feedback, which has them. */
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
    const bs_real t1 = x[2] * x[2];
    const bs_real t2 = BS_REAL(1e-30) + t1;
    const bs_real t3 = x[1] * x[1];
    const bs_real t4 = t2 + t3;
    const bs_real t5 = x[0] * x[0];
    const bs_real t6 = t4 + t5;
    const bs_real angle = BS_SQRT(t6);
    const bs_real t7 = BS_REAL(0.5) * angle;
    bs_real t10;
    bs_real t8;
    BS_SINCOS(t7, &t10, &t8);
    const bs_real t9 = t8 * q_b2n_wxyz[0];
    const bs_real t11 = t10 / angle;
    const bs_real t12 = t11 * q_b2n_wxyz[3];
    const bs_real t13 = t12 * x[2];
    const bs_real t14 = t9 - t13;
    const bs_real t15 = t11 * q_b2n_wxyz[2];
    const bs_real t16 = t15 * x[1];
    const bs_real t17 = t14 - t16;
    const bs_real t18 = t11 * x[0];
    const bs_real t19 = t18 * q_b2n_wxyz[1];
    const bs_real t20 = t17 - t19;
    const bs_real t21 = t8 * q_b2n_wxyz[2];
    const bs_real t22 = t11 * x[2];
    const bs_real t23 = t22 * q_b2n_wxyz[1];
    const bs_real t24 = t21 + t23;
    const bs_real t25 = t11 * x[1];
    const bs_real t26 = t25 * q_b2n_wxyz[0];
    const bs_real t27 = t24 + t26;
    const bs_real t28 = t12 * x[0];
    const bs_real t29 = t27 - t28;
    const bs_real t30 = t29 * t29;
    const bs_real t31 = t8 * q_b2n_wxyz[3];
    const bs_real t32 = t15 * x[0];
    const bs_real t33 = t31 + t32;
    const bs_real t34 = t22 * q_b2n_wxyz[0];
    const bs_real t35 = t33 + t34;
    const bs_real t36 = t25 * q_b2n_wxyz[1];
    const bs_real t37 = t35 - t36;
    const bs_real t38 = t37 * t37;
    const bs_real t39 = t30 + t38;
    const bs_real t40 = t20 * t20;
    const bs_real t41 = t39 + t40;
    const bs_real t42 = t8 * q_b2n_wxyz[1];
    const bs_real t43 = t12 * x[1];
    const bs_real t44 = t42 + t43;
    const bs_real t45 = t18 * q_b2n_wxyz[0];
    const bs_real t46 = t44 + t45;
    const bs_real t47 = t15 * x[2];
    const bs_real t48 = t46 - t47;
    const bs_real t49 = t48 * t48;
    const bs_real t50 = t41 + t49;
    const bs_real t51 = BS_SQRT(t50);
    const bs_real t52 = BS_REAL(1.0) / t51;
    const bs_real t53 = t20 * t52;
    const bs_real t54 = t48 * t52;
    const bs_real t55 = t29 * t52;
    const bs_real t56 = t37 * t52;
    const bs_real t57 = mu[0] - x[3];
    const bs_real t58 = mu[1] - x[4];
    const bs_real t59 = mu[2] - x[5];
    /* q_b2n_wxyz */
    q_b2n_wxyz_nz[0] = t53; /* q_w */
    q_b2n_wxyz_nz[1] = t54; /* q_x */
    q_b2n_wxyz_nz[2] = t55; /* q_y */
    q_b2n_wxyz_nz[3] = t56; /* q_z */
    /* mu */
    mu_nz[0] = t57; /* mu_x */
    mu_nz[1] = t58; /* mu_y */
    mu_nz[2] = t59; /* mu_z */
}

#endif

/* val_quaternion_z_kernel.h - attitude of the master, twice the vector part of a quaternion: z =
 * -e, e the turn from the computed to the measured one; z = h(x) + noise; rows n, e, d.  Generated
 * by Boresight: do not edit.
 * 177 operations, list 5d6a6e07599f511f.  No branch, no check: call val_quaternion_z, which has
 * them. */
#ifndef VAL_QUATERNION_Z_KERNEL_H
#define VAL_QUATERNION_Z_KERNEL_H

#include "boresight.h"

static void val_quaternion_z_kernel(const bs_real position[3],
                                    const bs_real v_n[3],
                                    const bs_real q_b2n_wxyz[4],
                                    const bs_real q_b2m_wxyz[4],
                                    const bs_real omega_ib_b[3],
                                    const bs_real q_m2n_wxyz[4],
                                    const bs_real lag[1],
                                    bs_real z_nz[3])
{
    const bs_real t2 = q_b2m_wxyz[0] * q_b2n_wxyz[1];
    const bs_real t5 = q_b2m_wxyz[2] * q_b2n_wxyz[3];
    const bs_real t6 = t2 + t5;
    const bs_real t9 = q_b2m_wxyz[1] * q_b2n_wxyz[0];
    const bs_real t10 = t6 - t9;
    const bs_real t13 = q_b2m_wxyz[3] * q_b2n_wxyz[2];
    const bs_real t14 = t10 - t13;
    const bs_real t18 = lag[0] * lag[0];
    const bs_real t20 = BS_REAL(2.0) * q_b2n_wxyz[0];
    const bs_real t21 = t20 * q_b2n_wxyz[3];
    const bs_real t22 = BS_REAL(2.0) * q_b2n_wxyz[2];
    const bs_real t23 = t22 * q_b2n_wxyz[1];
    const bs_real t24 = t21 + t23;
    const bs_real t25 = omega_ib_b[0] * t24;
    const bs_real t27 = q_b2n_wxyz[0] * q_b2n_wxyz[0];
    const bs_real t28 = q_b2n_wxyz[1] * q_b2n_wxyz[1];
    const bs_real t29 = t27 - t28;
    const bs_real t30 = q_b2n_wxyz[3] * q_b2n_wxyz[3];
    const bs_real t31 = t29 - t30;
    const bs_real t32 = q_b2n_wxyz[2] * q_b2n_wxyz[2];
    const bs_real t33 = t31 + t32;
    const bs_real t34 = omega_ib_b[1] * t33;
    const bs_real t35 = t25 + t34;
    const bs_real t37 = q_b2n_wxyz[2] * q_b2n_wxyz[3];
    const bs_real t38 = BS_REAL(2.0) * t37;
    const bs_real t39 = t20 * q_b2n_wxyz[1];
    const bs_real t40 = t38 - t39;
    const bs_real t41 = omega_ib_b[2] * t40;
    const bs_real t42 = t35 + t41;
    const bs_real sin_lat = BS_SIN(position[0]);
    const bs_real t50 = sin_lat * sin_lat;
    const bs_real t51 = BS_REAL(0.006694379990141317) * t50;
    const bs_real t52 = BS_REAL(1.0) - t51;
    const bs_real t53 = BS_SQRT(t52);
    const bs_real t54 = t52 * t53;
    const bs_real t55 = BS_REAL(6335439.32729282) / t54;
    const bs_real t56 = position[2] + t55;
    const bs_real t57 = v_n[0] / t56;
    const bs_real t58 = t42 + t57;
    const bs_real t59 = t58 * t58;
    const bs_real t60 = t18 * t59;
    const bs_real t61 = BS_REAL(1e-30) + t60;
    const bs_real cos_lat = BS_COS(position[0]);
    const bs_real t64 = BS_REAL(7.292115e-05) * cos_lat;
    const bs_real t67 = BS_REAL(6378137.0) / t53;
    const bs_real t68 = position[2] + t67;
    const bs_real t69 = v_n[1] / t68;
    const bs_real t70 = t64 + t69;
    const bs_real t71 = t27 - t30;
    const bs_real t72 = t71 + t28;
    const bs_real t73 = t72 - t32;
    const bs_real t74 = omega_ib_b[0] * t73;
    const bs_real t75 = t70 - t74;
    const bs_real t76 = t23 - t21;
    const bs_real t77 = omega_ib_b[1] * t76;
    const bs_real t78 = t75 - t77;
    const bs_real t79 = t20 * q_b2n_wxyz[2];
    const bs_real t80 = q_b2n_wxyz[1] * q_b2n_wxyz[3];
    const bs_real t81 = BS_REAL(2.0) * t80;
    const bs_real t82 = t79 + t81;
    const bs_real t83 = omega_ib_b[2] * t82;
    const bs_real t84 = t78 - t83;
    const bs_real t85 = t84 * t84;
    const bs_real t86 = t18 * t85;
    const bs_real t87 = t61 + t86;
    const bs_real t88 = BS_REAL(7.292115e-05) * sin_lat;
    const bs_real t89 = t81 - t79;
    const bs_real t90 = omega_ib_b[0] * t89;
    const bs_real t91 = t88 + t90;
    const bs_real t92 = t39 + t38;
    const bs_real t93 = omega_ib_b[1] * t92;
    const bs_real t94 = t91 + t93;
    const bs_real t95 = t29 - t32;
    const bs_real t96 = t95 + t30;
    const bs_real t97 = omega_ib_b[2] * t96;
    const bs_real t98 = t94 + t97;
    const bs_real t99 = sin_lat / cos_lat;
    const bs_real t100 = t69 * t99;
    const bs_real t101 = t98 + t100;
    const bs_real t102 = t101 * t101;
    const bs_real t103 = t18 * t102;
    const bs_real t104 = t87 + t103;
    const bs_real t105 = BS_SQRT(t104);
    const bs_real t106 = BS_REAL(0.5) * t105;
    const bs_real t107 = BS_COS(t106);
    const bs_real t108 = t14 * t107;
    const bs_real t109 = BS_SIN(t106);
    const bs_real t110 = lag[0] * t109;
    const bs_real t111 = t110 / t105;
    const bs_real t112 = q_b2m_wxyz[0] * q_b2n_wxyz[0];
    const bs_real t113 = q_b2m_wxyz[1] * q_b2n_wxyz[1];
    const bs_real t114 = t112 + t113;
    const bs_real t115 = q_b2m_wxyz[2] * q_b2n_wxyz[2];
    const bs_real t116 = t114 + t115;
    const bs_real t117 = q_b2m_wxyz[3] * q_b2n_wxyz[3];
    const bs_real t118 = t116 + t117;
    const bs_real t119 = t111 * t118;
    const bs_real t120 = t84 * t119;
    const bs_real t121 = t108 + t120;
    const bs_real t122 = q_b2m_wxyz[0] * q_b2n_wxyz[3];
    const bs_real t123 = q_b2m_wxyz[1] * q_b2n_wxyz[2];
    const bs_real t124 = t122 + t123;
    const bs_real t125 = q_b2m_wxyz[2] * q_b2n_wxyz[1];
    const bs_real t126 = t124 - t125;
    const bs_real t127 = q_b2m_wxyz[3] * q_b2n_wxyz[0];
    const bs_real t128 = t126 - t127;
    const bs_real t129 = t58 * t111;
    const bs_real t130 = t128 * t129;
    const bs_real t131 = t121 - t130;
    const bs_real t132 = q_b2m_wxyz[0] * q_b2n_wxyz[2];
    const bs_real t133 = q_b2m_wxyz[3] * q_b2n_wxyz[1];
    const bs_real t134 = t132 + t133;
    const bs_real t135 = q_b2m_wxyz[1] * q_b2n_wxyz[3];
    const bs_real t136 = t134 - t135;
    const bs_real t137 = q_b2m_wxyz[2] * q_b2n_wxyz[0];
    const bs_real t138 = t136 - t137;
    const bs_real t139 = t111 * t138;
    const bs_real t140 = t101 * t139;
    const bs_real t141 = t131 + t140;
    const bs_real t143 = t141 * q_m2n_wxyz[1];
    const bs_real t144 = t84 * t139;
    const bs_real t145 = t101 * t119;
    const bs_real t146 = t144 - t145;
    const bs_real t147 = t107 * t128;
    const bs_real t148 = t146 + t147;
    const bs_real t149 = t14 * t129;
    const bs_real t150 = t148 + t149;
    const bs_real t152 = t150 * q_m2n_wxyz[3];
    const bs_real t153 = t143 + t152;
    const bs_real t154 = t107 * t138;
    const bs_real t155 = t58 * t119;
    const bs_real t156 = t14 * t111;
    const bs_real t157 = t101 * t156;
    const bs_real t158 = t155 + t157;
    const bs_real t159 = t154 - t158;
    const bs_real t160 = t128 * t111;
    const bs_real t161 = t84 * t160;
    const bs_real t162 = t159 - t161;
    const bs_real t164 = t162 * q_m2n_wxyz[2];
    const bs_real t165 = t153 + t164;
    const bs_real t166 = t107 * t118;
    const bs_real t167 = t84 * t156;
    const bs_real t168 = t166 - t167;
    const bs_real t169 = t101 * t160;
    const bs_real t170 = t168 + t169;
    const bs_real t171 = t129 * t138;
    const bs_real t172 = t170 + t171;
    const bs_real t174 = t172 * q_m2n_wxyz[0];
    const bs_real t175 = t165 + t174;
    const bs_real t177 = BS_TRUTH(t175 < BS_REAL(0.0));
    const bs_real t178 = BS_REAL(1.0) - t177;
    const bs_real t179 = t178 - t177;
    const bs_real t180 = BS_REAL(2.0) * t179;
    const bs_real t181 = t141 * q_m2n_wxyz[0];
    const bs_real t182 = t150 * q_m2n_wxyz[2];
    const bs_real t183 = t181 + t182;
    const bs_real t184 = t162 * q_m2n_wxyz[3];
    const bs_real t185 = t183 - t184;
    const bs_real t186 = t172 * q_m2n_wxyz[1];
    const bs_real t187 = t185 - t186;
    const bs_real t188 = t180 * t187;
    const bs_real t189 = t141 * q_m2n_wxyz[3];
    const bs_real t190 = t162 * q_m2n_wxyz[0];
    const bs_real t191 = t189 + t190;
    const bs_real t192 = t150 * q_m2n_wxyz[1];
    const bs_real t193 = t191 - t192;
    const bs_real t194 = t172 * q_m2n_wxyz[2];
    const bs_real t195 = t193 - t194;
    const bs_real t196 = t180 * t195;
    const bs_real t197 = t150 * q_m2n_wxyz[0];
    const bs_real t198 = t162 * q_m2n_wxyz[1];
    const bs_real t199 = t197 + t198;
    const bs_real t200 = t141 * q_m2n_wxyz[2];
    const bs_real t201 = t199 - t200;
    const bs_real t202 = t172 * q_m2n_wxyz[3];
    const bs_real t203 = t201 - t202;
    const bs_real t204 = t180 * t203;
    z_nz[0] = t188; /* n */
    z_nz[1] = t196; /* e */
    z_nz[2] = t204; /* d */
}

#endif

/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_strapdown_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vas_math.h"
#define cos BS_COS
#define sin BS_SIN

#ifndef casadi_real
#define casadi_real double
#endif

#ifndef casadi_int
#define casadi_int int
#endif

/* Add prefix to internal symbols */
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)

/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
  #if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
    #if defined(STATIC_LINKED)
      #define CASADI_SYMBOL_EXPORT
    #else
      #define CASADI_SYMBOL_EXPORT __declspec(dllexport)
    #endif
  #elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
    #define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
  #else
    #define CASADI_SYMBOL_EXPORT
  #endif
#endif

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void vas_strapdown_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_strapdown_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_strapdown_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};

/* vas_strapdown_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],gyro_bias[3],accel_bias[3],dt,dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3],flexure[3],flexure_rate[3],flexure_omega[3],flexure_damping[3],gyro_scale[3],accel_scale[3],gyro_axes[6],accel_axes[3],gyro_turn_on[3],accel_turn_on[3],gyro_bias_beta[3],accel_bias_beta[3])->(out_lat_lon_height[3],out_v_n[3],out_q_b2n_wxyz[4],out_flexure[3],out_flexure_rate[3],out_gyro_bias[3],out_accel_bias[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=1.;
  a03=6.3354393272928204e+06;
  a04=6.6943799901413173e-03;
  a05=5.0000000000000000e-01;
  a06=(a05*a01);
  a07=arg[1]? arg[1][0] : 0;
  a08=arg[0]? arg[0][2] : 0;
  a09=sin(a00);
  a10=(a09*a09);
  a11=(a04*a10);
  a11=(a02-a11);
  a12=sqrt(a11);
  a11=(a11*a12);
  a11=(a03/a11);
  a11=(a08+a11);
  a11=(a07/a11);
  a13=(a06*a11);
  a13=(a00+a13);
  a14=sin(a13);
  a15=(a14*a14);
  a04=(a04*a15);
  a04=(a02-a04);
  a16=sqrt(a04);
  a04=(a04*a16);
  a03=(a03/a04);
  a04=arg[1]? arg[1][2] : 0;
  a17=(a06*a04);
  a17=(a08-a17);
  a03=(a03+a17);
  a03=(a02/a03);
  a18=(a01*a03);
  a19=arg[2]? arg[2][1] : 0;
  a20=(a19*a19);
  a21=arg[2]? arg[2][2] : 0;
  a22=(a21*a21);
  a23=(a20-a22);
  a24=arg[2]? arg[2][0] : 0;
  a25=(a24*a24);
  a26=arg[2]? arg[2][3] : 0;
  a27=(a26*a26);
  a28=(a25-a27);
  a29=(a23+a28);
  a30=arg[15]? arg[15][0] : 0;
  a30=(a02-a30);
  a31=arg[7]? arg[7][0] : 0;
  a32=(a30*a31);
  a33=arg[15]? arg[15][1] : 0;
  a33=(a02-a33);
  a34=arg[7]? arg[7][1] : 0;
  a35=(a33*a34);
  a36=arg[17]? arg[17][0] : 0;
  a37=(a31*a36);
  a35=(a35-a37);
  a37=arg[4]? arg[4][1] : 0;
  a38=(a33*a37);
  a39=arg[4]? arg[4][0] : 0;
  a40=(a39*a36);
  a38=(a38-a40);
  a38=(a01*a38);
  a40=(a35-a38);
  a41=arg[14]? arg[14][2] : 0;
  a41=(a02-a41);
  a42=arg[3]? arg[3][2] : 0;
  a43=(a41*a42);
  a44=arg[3]? arg[3][0] : 0;
  a45=arg[16]? arg[16][4] : 0;
  a46=(a44*a45);
  a43=(a43-a46);
  a46=arg[3]? arg[3][1] : 0;
  a47=arg[16]? arg[16][5] : 0;
  a48=(a46*a47);
  a43=(a43-a48);
  a43=(a01*a43);
  a48=arg[6]? arg[6][0] : 0;
  a49=(a48*a45);
  a49=(a43+a49);
  a50=arg[6]? arg[6][1] : 0;
  a51=(a50*a47);
  a49=(a49+a51);
  a51=arg[6]? arg[6][2] : 0;
  a52=(a41*a51);
  a49=(a49-a52);
  a52=(a40*a49);
  a53=(a05*a52);
  a53=(a32+a53);
  a54=arg[14]? arg[14][1] : 0;
  a54=(a02-a54);
  a55=(a54*a46);
  a56=arg[16]? arg[16][2] : 0;
  a57=(a44*a56);
  a55=(a55-a57);
  a57=arg[16]? arg[16][3] : 0;
  a58=(a42*a57);
  a55=(a55-a58);
  a55=(a01*a55);
  a58=(a48*a56);
  a58=(a55+a58);
  a59=(a51*a57);
  a58=(a58+a59);
  a59=(a54*a50);
  a58=(a58-a59);
  a59=arg[15]? arg[15][2] : 0;
  a59=(a02-a59);
  a60=arg[7]? arg[7][2] : 0;
  a60=(a59*a60);
  a61=arg[4]? arg[4][2] : 0;
  a62=(a59*a61);
  a63=arg[17]? arg[17][1] : 0;
  a64=(a39*a63);
  a62=(a62-a64);
  a64=arg[17]? arg[17][2] : 0;
  a65=(a37*a64);
  a62=(a62-a65);
  a62=(a01*a62);
  a65=(a60-a62);
  a31=(a31*a63);
  a65=(a65-a31);
  a34=(a34*a64);
  a65=(a65-a34);
  a66=(a58*a65);
  a67=(a05*a66);
  a53=(a53-a67);
  a67=arg[8]? arg[8][0] : 0;
  a45=(a67*a45);
  a43=(a43+a45);
  a45=arg[8]? arg[8][1] : 0;
  a47=(a45*a47);
  a43=(a43+a47);
  a47=arg[8]? arg[8][2] : 0;
  a41=(a41*a47);
  a43=(a43-a41);
  a41=8.3333333333333329e-02;
  a68=(a41*a40);
  a69=(a43*a68);
  a53=(a53+a69);
  a69=1.6666666666666666e-01;
  a70=arg[14]? arg[14][0] : 0;
  a70=(a02-a70);
  a71=(a70*a44);
  a72=arg[16]? arg[16][0] : 0;
  a73=(a46*a72);
  a71=(a71-a73);
  a73=arg[16]? arg[16][1] : 0;
  a74=(a42*a73);
  a71=(a71-a74);
  a71=(a01*a71);
  a50=(a50*a72);
  a50=(a71+a50);
  a51=(a51*a73);
  a50=(a50+a51);
  a48=(a70*a48);
  a50=(a50-a48);
  a48=(a65*a50);
  a51=(a30*a39);
  a51=(a51*a01);
  a74=(a32-a51);
  a75=(a49*a74);
  a76=(a48-a75);
  a77=(a69*a76);
  a78=(a49*a77);
  a53=(a53+a78);
  a78=arg[9]? arg[9][0] : 0;
  a63=(a78*a63);
  a79=arg[9]? arg[9][1] : 0;
  a64=(a79*a64);
  a63=(a63+a64);
  a64=arg[9]? arg[9][2] : 0;
  a59=(a59*a64);
  a63=(a63-a59);
  a59=(a62+a63);
  a64=(a41*a58);
  a80=(a59*a64);
  a53=(a53-a80);
  a80=(a58*a74);
  a40=(a40*a50);
  a81=(a80-a40);
  a82=(a69*a81);
  a83=(a58*a82);
  a53=(a53-a83);
  a56=(a67*a56);
  a55=(a55+a56);
  a57=(a47*a57);
  a55=(a55+a57);
  a54=(a54*a45);
  a55=(a55-a54);
  a65=(a41*a65);
  a54=(a55*a65);
  a53=(a53-a54);
  a53=(a53-a51);
  a36=(a78*a36);
  a33=(a33*a79);
  a36=(a36-a33);
  a33=(a38+a36);
  a79=(a41*a49);
  a54=(a33*a79);
  a53=(a53+a54);
  a54=(a29*a53);
  a57=2.;
  a56=(a57*a19);
  a83=(a56*a21);
  a84=(a57*a24);
  a85=(a84*a26);
  a86=(a83-a85);
  a75=(a05*a75);
  a75=(a35-a75);
  a48=(a05*a48);
  a75=(a75+a48);
  a30=(a30*a78);
  a51=(a51-a30);
  a79=(a51*a79);
  a75=(a75-a79);
  a45=(a45*a72);
  a71=(a71+a45);
  a47=(a47*a73);
  a71=(a71+a47);
  a70=(a70*a67);
  a71=(a71-a70);
  a65=(a71*a65);
  a75=(a75+a65);
  a52=(a52-a66);
  a69=(a69*a52);
  a66=(a49*a69);
  a75=(a75-a66);
  a82=(a50*a82);
  a75=(a75+a82);
  a74=(a41*a74);
  a82=(a43*a74);
  a75=(a75-a82);
  a75=(a75-a38);
  a38=(a41*a50);
  a59=(a38*a59);
  a75=(a75+a59);
  a59=(a86*a75);
  a54=(a54+a59);
  a59=(a84*a21);
  a56=(a56*a26);
  a82=(a59+a56);
  a60=(a60-a31);
  a60=(a60-a34);
  a80=(a05*a80);
  a80=(a60+a80);
  a40=(a05*a40);
  a80=(a80-a40);
  a38=(a38*a33);
  a80=(a80-a38);
  a68=(a71*a68);
  a80=(a80-a68);
  a69=(a58*a69);
  a80=(a80+a69);
  a74=(a55*a74);
  a80=(a80+a74);
  a77=(a50*a77);
  a80=(a80-a77);
  a80=(a80-a62);
  a51=(a51*a64);
  a80=(a80+a51);
  a51=(a82*a80);
  a54=(a54+a51);
  a51=(a05*a54);
  a64=(a51+a07);
  a62=7.2921149999999999e-05;
  a77=(a62*a14);
  a74=(-a77);
  a74=(a57*a74);
  a13=cos(a13);
  a69=(a02/a13);
  a14=(a14*a69);
  a85=(a85+a83);
  a83=(a85*a53);
  a28=(a28-a23);
  a23=(a28*a75);
  a83=(a83+a23);
  a23=(a57*a21);
  a23=(a23*a26);
  a84=(a84*a19);
  a68=(a23-a84);
  a38=(a68*a80);
  a83=(a83+a38);
  a38=(a05*a83);
  a33=arg[1]? arg[1][1] : 0;
  a40=(a38+a33);
  a34=1.4584230000000000e-04;
  a31=cos(a00);
  a66=(a34*a31);
  a65=6378137.;
  a12=(a02/a12);
  a70=(a65*a12);
  a70=(a08+a70);
  a70=(a33/a70);
  a66=(a66+a70);
  a67=(a04*a66);
  a47=(a62*a09);
  a47=(-a47);
  a47=(a57*a47);
  a09=(a09/a31);
  a70=(a70*a09);
  a47=(a47-a70);
  a70=(a07*a47);
  a67=(a67-a70);
  a67=(a06*a67);
  a67=(a40+a67);
  a16=(a02/a16);
  a65=(a65*a16);
  a65=(a65+a17);
  a65=(a02/a65);
  a70=(a67*a65);
  a14=(a14*a70);
  a74=(a74-a14);
  a09=(a74*a67);
  a47=(a33*a47);
  a31=(a04*a11);
  a47=(a47+a31);
  a47=(a06*a47);
  a47=(a64+a47);
  a03=(a47*a03);
  a56=(a56-a59);
  a53=(a56*a53);
  a84=(a84+a23);
  a75=(a84*a75);
  a53=(a53+a75);
  a20=(a20+a22);
  a25=(a25-a20);
  a25=(a25+a27);
  a80=(a25*a80);
  a53=(a53+a80);
  a80=(a05*a53);
  a27=(a80+a04);
  a20=7.3745167729419953e-14;
  a22=(a08*a08);
  a22=(a20*a22);
  a22=(a02+a22);
  a75=1.5678559428873979e-07;
  a23=2.0136051943431768e+00;
  a59=1.3411242658989924e-02;
  a31=(a59*a10);
  a31=(a23-a31);
  a31=(a08*a31);
  a31=(a75*a31);
  a22=(a22-a31);
  a31=9.7803253359000006e+00;
  a73=1.8894147482439335e-02;
  a10=(a73*a10);
  a10=(a31+a10);
  a10=(a10*a12);
  a22=(a22*a10);
  a11=(a07*a11);
  a22=(a22-a11);
  a66=(a33*a66);
  a22=(a22-a66);
  a22=(a06*a22);
  a22=(a27+a22);
  a66=(a03*a22);
  a09=(a09+a66);
  a09=(a01*a09);
  a66=(a05*a09);
  a64=(a64+a66);
  a66=2.5000000000000000e-01;
  a14=(a14+a77);
  a14=(a01*a14);
  a77=(a66*a14);
  a11=(a77*a83);
  a64=(a64-a11);
  a60=(a60+a63);
  a60=(a60+a81);
  a82=(a60*a82);
  a35=(a35+a36);
  a35=(a35+a76);
  a86=(a35*a86);
  a82=(a82+a86);
  a32=(a32-a30);
  a32=(a32+a52);
  a29=(a32*a29);
  a82=(a82+a29);
  a82=(a41*a82);
  a64=(a64-a82);
  a82=(a66*a53);
  a29=(a01*a03);
  a52=(a82*a29);
  a64=(a64+a52);
  a18=(a18*a64);
  a00=(a00+a18);
  if (res[0]!=0) res[0][0]=a00;
  a00=arg[0]? arg[0][1] : 0;
  a65=(a01*a65);
  a34=(a34*a13);
  a34=(a34+a70);
  a22=(a34*a22);
  a74=(a74*a47);
  a22=(a22-a74);
  a22=(a01*a22);
  a74=(a05*a22);
  a40=(a40+a74);
  a62=(a62*a13);
  a70=(a70+a62);
  a70=(a01*a70);
  a82=(a82*a70);
  a40=(a40+a82);
  a68=(a60*a68);
  a28=(a35*a28);
  a68=(a68+a28);
  a85=(a32*a85);
  a68=(a68+a85);
  a68=(a41*a68);
  a40=(a40-a68);
  a77=(a77*a54);
  a40=(a40+a77);
  a65=(a65*a40);
  a65=(a65*a69);
  a00=(a00+a65);
  if (res[0]!=0) res[0][1]=a00;
  a60=(a60*a25);
  a35=(a35*a84);
  a60=(a60+a35);
  a32=(a32*a56);
  a60=(a60+a32);
  a60=(a41*a60);
  a32=(a83*a70);
  a32=(a66*a32);
  a60=(a60+a32);
  a60=(a60-a27);
  a27=(a17*a17);
  a20=(a20*a27);
  a20=(a02+a20);
  a59=(a59*a15);
  a23=(a23-a59);
  a23=(a23*a17);
  a75=(a75*a23);
  a20=(a20-a75);
  a73=(a73*a15);
  a31=(a31+a73);
  a31=(a31*a16);
  a20=(a20*a31);
  a03=(a03*a47);
  a20=(a20-a03);
  a34=(a34*a67);
  a20=(a20-a34);
  a20=(a01*a20);
  a34=(a05*a20);
  a60=(a60-a34);
  a34=(a54*a29);
  a66=(a66*a34);
  a60=(a60+a66);
  a60=(a01*a60);
  a08=(a08+a60);
  if (res[0]!=0) res[0][2]=a08;
  a09=(a09+a07);
  a07=(a38*a14);
  a09=(a09-a07);
  a09=(a09+a54);
  a54=(a80*a29);
  a09=(a09+a54);
  if (res[1]!=0) res[1][0]=a09;
  a22=(a22+a33);
  a80=(a80*a70);
  a22=(a22+a80);
  a22=(a22+a83);
  a83=(a51*a14);
  a22=(a22+a83);
  if (res[1]!=0) res[1][1]=a22;
  a20=(a20+a04);
  a51=(a51*a29);
  a20=(a20-a51);
  a20=(a20+a53);
  a38=(a38*a70);
  a20=(a20-a38);
  if (res[1]!=0) res[1][2]=a20;
  a20=1.0000000000000001e-30;
  a38=(a49*a55);
  a38=(a41*a38);
  a53=(a43*a58);
  a53=(a41*a53);
  a38=(a38-a53);
  a38=(a38-a50);
  a53=(a38*a38);
  a53=(a20+a53);
  a43=(a50*a43);
  a43=(a41*a43);
  a51=(a71*a49);
  a51=(a41*a51);
  a43=(a43-a51);
  a43=(a43-a58);
  a51=(a43*a43);
  a53=(a53+a51);
  a71=(a71*a58);
  a71=(a41*a71);
  a55=(a55*a50);
  a41=(a41*a55);
  a71=(a71-a41);
  a71=(a71-a49);
  a49=(a71*a71);
  a53=(a53+a49);
  a53=sqrt(a53);
  a49=(a05*a53);
  a41=cos(a49);
  a55=(a24*a41);
  a49=sin(a49);
  a49=(a49/a53);
  a38=(a49*a38);
  a53=(a19*a38);
  a55=(a55-a53);
  a43=(a49*a43);
  a53=(a21*a43);
  a55=(a55-a53);
  a49=(a49*a71);
  a71=(a26*a49);
  a55=(a55-a71);
  a71=(a14*a14);
  a20=(a20+a71);
  a71=(a29*a29);
  a20=(a20+a71);
  a71=(a70*a70);
  a20=(a20+a71);
  a20=sqrt(a20);
  a71=(a05*a20);
  a53=cos(a71);
  a50=(a55*a53);
  a58=(a24*a38);
  a51=(a19*a41);
  a58=(a58+a51);
  a51=(a21*a49);
  a58=(a58+a51);
  a51=(a26*a43);
  a58=(a58-a51);
  a71=sin(a71);
  a71=(a71/a20);
  a70=(a71*a70);
  a20=(a58*a70);
  a50=(a50+a20);
  a20=(a24*a43);
  a51=(a21*a41);
  a20=(a20+a51);
  a51=(a26*a38);
  a20=(a20+a51);
  a51=(a19*a49);
  a20=(a20-a51);
  a29=(a71*a29);
  a51=(a20*a29);
  a50=(a50-a51);
  a24=(a24*a49);
  a19=(a19*a43);
  a24=(a24+a19);
  a26=(a26*a41);
  a24=(a24+a26);
  a21=(a21*a38);
  a24=(a24-a21);
  a71=(a71*a14);
  a14=(a24*a71);
  a50=(a50-a14);
  a14=(a50*a50);
  a21=(a58*a53);
  a38=(a24*a29);
  a21=(a21+a38);
  a38=(a55*a70);
  a21=(a21-a38);
  a38=(a20*a71);
  a21=(a21-a38);
  a38=(a21*a21);
  a14=(a14+a38);
  a38=(a58*a71);
  a26=(a20*a53);
  a38=(a38+a26);
  a26=(a55*a29);
  a38=(a38+a26);
  a26=(a24*a70);
  a38=(a38+a26);
  a26=(a38*a38);
  a14=(a14+a26);
  a24=(a24*a53);
  a20=(a20*a70);
  a24=(a24-a20);
  a55=(a55*a71);
  a24=(a24+a55);
  a58=(a58*a29);
  a24=(a24-a58);
  a58=(a24*a24);
  a14=(a14+a58);
  a14=sqrt(a14);
  a02=(a02/a14);
  a50=(a50*a02);
  if (res[2]!=0) res[2][0]=a50;
  a21=(a21*a02);
  if (res[2]!=0) res[2][1]=a21;
  a38=(a38*a02);
  if (res[2]!=0) res[2][2]=a38;
  a24=(a24*a02);
  if (res[2]!=0) res[2][3]=a24;
  a24=arg[10]? arg[10][0] : 0;
  a02=arg[13]? arg[13][0] : 0;
  a38=arg[12]? arg[12][0] : 0;
  a02=(a02*a38);
  a21=arg[11]? arg[11][0] : 0;
  a50=(a02*a21);
  a50=(a50*a01);
  a50=(a50-a21);
  a38=(a38*a38);
  a14=(a38*a06);
  a14=(a14*a24);
  a50=(a50+a14);
  a50=(a01*a50);
  a14=(a24-a50);
  if (res[3]!=0) res[3][0]=a14;
  a14=arg[10]? arg[10][1] : 0;
  a58=arg[12]? arg[12][1] : 0;
  a29=(a58*a58);
  a55=(a06*a29);
  a55=(a55*a14);
  a71=arg[11]? arg[11][1] : 0;
  a55=(a55-a71);
  a20=arg[13]? arg[13][1] : 0;
  a20=(a20*a58);
  a58=(a20*a71);
  a58=(a58*a01);
  a55=(a55+a58);
  a55=(a01*a55);
  a58=(a14-a55);
  if (res[3]!=0) res[3][1]=a58;
  a58=arg[10]? arg[10][2] : 0;
  a70=arg[12]? arg[12][2] : 0;
  a53=(a70*a70);
  a26=(a06*a53);
  a26=(a26*a58);
  a41=arg[11]? arg[11][2] : 0;
  a26=(a26-a41);
  a19=arg[13]? arg[13][2] : 0;
  a19=(a19*a70);
  a70=(a19*a41);
  a70=(a70*a01);
  a26=(a26+a70);
  a26=(a01*a26);
  a70=(a58-a26);
  if (res[3]!=0) res[3][2]=a70;
  a02=(a57*a02);
  a02=(a02*a50);
  a02=(a21+a02);
  a38=(a38*a01);
  a21=(a06*a21);
  a24=(a24+a21);
  a38=(a38*a24);
  a02=(a02-a38);
  if (res[4]!=0) res[4][0]=a02;
  a20=(a57*a20);
  a20=(a20*a55);
  a20=(a71+a20);
  a29=(a29*a01);
  a71=(a06*a71);
  a14=(a14+a71);
  a29=(a29*a14);
  a20=(a20-a29);
  if (res[4]!=0) res[4][1]=a20;
  a57=(a57*a19);
  a57=(a57*a26);
  a57=(a41+a57);
  a53=(a53*a01);
  a06=(a06*a41);
  a58=(a58+a06);
  a53=(a53*a58);
  a57=(a57-a53);
  if (res[4]!=0) res[4][2]=a57;
  a57=arg[18]? arg[18][0] : 0;
  a57=(a44-a57);
  a53=arg[20]? arg[20][0] : 0;
  a58=(a53*a01);
  a06=(a01*a01);
  a05=(a05*a06);
  a53=(a53*a53);
  a53=(a05*a53);
  a58=(a58-a53);
  a57=(a57*a58);
  a44=(a44-a57);
  if (res[5]!=0) res[5][0]=a44;
  a44=arg[18]? arg[18][1] : 0;
  a44=(a46-a44);
  a57=arg[20]? arg[20][1] : 0;
  a58=(a57*a01);
  a57=(a57*a57);
  a57=(a05*a57);
  a58=(a58-a57);
  a44=(a44*a58);
  a46=(a46-a44);
  if (res[5]!=0) res[5][1]=a46;
  a46=arg[18]? arg[18][2] : 0;
  a46=(a42-a46);
  a44=arg[20]? arg[20][2] : 0;
  a58=(a44*a01);
  a44=(a44*a44);
  a44=(a05*a44);
  a58=(a58-a44);
  a46=(a46*a58);
  a42=(a42-a46);
  if (res[5]!=0) res[5][2]=a42;
  a42=arg[19]? arg[19][0] : 0;
  a42=(a39-a42);
  a46=arg[21]? arg[21][0] : 0;
  a58=(a46*a01);
  a46=(a46*a46);
  a46=(a05*a46);
  a58=(a58-a46);
  a42=(a42*a58);
  a39=(a39-a42);
  if (res[6]!=0) res[6][0]=a39;
  a39=arg[19]? arg[19][1] : 0;
  a39=(a37-a39);
  a42=arg[21]? arg[21][1] : 0;
  a58=(a42*a01);
  a42=(a42*a42);
  a42=(a05*a42);
  a58=(a58-a42);
  a39=(a39*a58);
  a37=(a37-a39);
  if (res[6]!=0) res[6][1]=a37;
  a37=arg[19]? arg[19][2] : 0;
  a37=(a61-a37);
  a39=arg[21]? arg[21][2] : 0;
  a01=(a39*a01);
  a39=(a39*a39);
  a05=(a05*a39);
  a01=(a01-a05);
  a37=(a37*a01);
  a61=(a61-a37);
  if (res[6]!=0) res[6][2]=a61;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_strapdown_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_strapdown_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_strapdown_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_strapdown_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_strapdown_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_strapdown_casadi_n_in(void) { return 22;}

CASADI_SYMBOL_EXPORT casadi_int vas_strapdown_casadi_n_out(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_real vas_strapdown_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_strapdown_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "gyro_bias";
    case 4: return "accel_bias";
    case 5: return "dt";
    case 6: return "dtheta_ib_b";
    case 7: return "dv_b";
    case 8: return "dtheta_before";
    case 9: return "dv_before";
    case 10: return "flexure";
    case 11: return "flexure_rate";
    case 12: return "flexure_omega";
    case 13: return "flexure_damping";
    case 14: return "gyro_scale";
    case 15: return "accel_scale";
    case 16: return "gyro_axes";
    case 17: return "accel_axes";
    case 18: return "gyro_turn_on";
    case 19: return "accel_turn_on";
    case 20: return "gyro_bias_beta";
    case 21: return "accel_bias_beta";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_strapdown_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_lat_lon_height";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    case 3: return "out_flexure";
    case 4: return "out_flexure_rate";
    case 5: return "out_gyro_bias";
    case 6: return "out_accel_bias";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_strapdown_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s2;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s0;
    case 10: return casadi_s0;
    case 11: return casadi_s0;
    case 12: return casadi_s0;
    case 13: return casadi_s0;
    case 14: return casadi_s0;
    case 15: return casadi_s0;
    case 16: return casadi_s3;
    case 17: return casadi_s0;
    case 18: return casadi_s0;
    case 19: return casadi_s0;
    case 20: return casadi_s0;
    case 21: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_strapdown_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_strapdown_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_strapdown_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 22*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



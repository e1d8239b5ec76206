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
  casadi_real a84, a85, a86, a87;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=1.;
  a03=arg[0]? arg[0][2] : 0;
  a04=5.0000000000000000e-01;
  a05=(a04*a01);
  a06=arg[1]? arg[1][2] : 0;
  a07=(a05*a06);
  a07=(a03-a07);
  a08=6.3354393272928204e+06;
  a09=6.6943799901413173e-03;
  a10=arg[1]? arg[1][0] : 0;
  a11=sin(a00);
  a12=(a11*a11);
  a13=(a09*a12);
  a13=(a02-a13);
  a14=sqrt(a13);
  a13=(a13*a14);
  a13=(a08/a13);
  a13=(a03+a13);
  a13=(a02/a13);
  a15=(a10*a13);
  a16=(a05*a15);
  a16=(a00+a16);
  a17=sin(a16);
  a18=(a17*a17);
  a09=(a09*a18);
  a09=(a02-a09);
  a19=sqrt(a09);
  a09=(a09*a19);
  a08=(a08/a09);
  a08=(a07+a08);
  a09=(a02/a08);
  a20=(a01*a09);
  a21=arg[15]? arg[15][2] : 0;
  a21=(a02-a21);
  a22=arg[7]? arg[7][2] : 0;
  a22=(a21*a22);
  a23=arg[7]? arg[7][0] : 0;
  a24=arg[17]? arg[17][1] : 0;
  a25=(a23*a24);
  a26=(a22-a25);
  a27=arg[7]? arg[7][1] : 0;
  a28=arg[17]? arg[17][2] : 0;
  a29=(a27*a28);
  a26=(a26-a29);
  a30=arg[14]? arg[14][1] : 0;
  a30=(a02-a30);
  a31=arg[3]? arg[3][1] : 0;
  a32=(a30*a31);
  a33=arg[3]? arg[3][0] : 0;
  a34=arg[16]? arg[16][2] : 0;
  a35=(a33*a34);
  a32=(a32-a35);
  a35=arg[3]? arg[3][2] : 0;
  a36=arg[16]? arg[16][3] : 0;
  a37=(a35*a36);
  a32=(a32-a37);
  a32=(a01*a32);
  a37=arg[6]? arg[6][0] : 0;
  a38=(a37*a34);
  a38=(a32+a38);
  a39=arg[6]? arg[6][2] : 0;
  a40=(a39*a36);
  a38=(a38+a40);
  a40=arg[6]? arg[6][1] : 0;
  a41=(a30*a40);
  a38=(a38-a41);
  a41=arg[15]? arg[15][0] : 0;
  a41=(a02-a41);
  a42=(a41*a23);
  a43=arg[4]? arg[4][0] : 0;
  a44=(a41*a43);
  a44=(a44*a01);
  a45=(a42-a44);
  a46=(a38*a45);
  a47=(a04*a46);
  a47=(a26+a47);
  a48=arg[15]? arg[15][1] : 0;
  a48=(a02-a48);
  a27=(a48*a27);
  a49=arg[17]? arg[17][0] : 0;
  a23=(a23*a49);
  a27=(a27-a23);
  a23=arg[4]? arg[4][1] : 0;
  a50=(a48*a23);
  a51=(a43*a49);
  a50=(a50-a51);
  a50=(a01*a50);
  a51=(a27-a50);
  a52=arg[14]? arg[14][0] : 0;
  a52=(a02-a52);
  a53=(a52*a33);
  a54=arg[16]? arg[16][0] : 0;
  a55=(a31*a54);
  a53=(a53-a55);
  a55=arg[16]? arg[16][1] : 0;
  a56=(a35*a55);
  a53=(a53-a56);
  a53=(a01*a53);
  a56=(a40*a54);
  a56=(a53+a56);
  a57=(a39*a55);
  a56=(a56+a57);
  a57=(a52*a37);
  a56=(a56-a57);
  a57=(a51*a56);
  a58=(a04*a57);
  a47=(a47-a58);
  a58=8.3333333333333329e-02;
  a59=(a58*a51);
  a60=arg[8]? arg[8][1] : 0;
  a54=(a60*a54);
  a53=(a53+a54);
  a54=arg[8]? arg[8][2] : 0;
  a55=(a54*a55);
  a53=(a53+a55);
  a55=arg[8]? arg[8][0] : 0;
  a52=(a52*a55);
  a53=(a53-a52);
  a52=(a59*a53);
  a47=(a47-a52);
  a52=arg[9]? arg[9][0] : 0;
  a49=(a52*a49);
  a61=arg[9]? arg[9][1] : 0;
  a48=(a48*a61);
  a49=(a49-a48);
  a48=(a50+a49);
  a62=(a58*a56);
  a63=(a48*a62);
  a47=(a47-a63);
  a63=1.6666666666666666e-01;
  a64=arg[14]? arg[14][2] : 0;
  a64=(a02-a64);
  a65=(a64*a35);
  a66=arg[16]? arg[16][4] : 0;
  a67=(a33*a66);
  a65=(a65-a67);
  a67=arg[16]? arg[16][5] : 0;
  a68=(a31*a67);
  a65=(a65-a68);
  a65=(a01*a65);
  a37=(a37*a66);
  a37=(a65+a37);
  a40=(a40*a67);
  a37=(a37+a40);
  a39=(a64*a39);
  a37=(a37-a39);
  a51=(a51*a37);
  a39=arg[4]? arg[4][2] : 0;
  a40=(a21*a39);
  a68=(a43*a24);
  a40=(a40-a68);
  a68=(a23*a28);
  a40=(a40-a68);
  a40=(a01*a40);
  a22=(a22-a40);
  a22=(a22-a25);
  a22=(a22-a29);
  a29=(a38*a22);
  a25=(a51-a29);
  a68=(a63*a25);
  a69=(a38*a68);
  a47=(a47+a69);
  a34=(a55*a34);
  a32=(a32+a34);
  a36=(a54*a36);
  a32=(a32+a36);
  a30=(a30*a60);
  a32=(a32-a30);
  a30=(a58*a45);
  a36=(a32*a30);
  a47=(a47+a36);
  a36=(a22*a56);
  a45=(a37*a45);
  a34=(a36-a45);
  a69=(a63*a34);
  a70=(a56*a69);
  a47=(a47-a70);
  a47=(a47-a40);
  a70=(a58*a38);
  a41=(a41*a52);
  a71=(a44-a41);
  a72=(a70*a71);
  a47=(a47+a72);
  a72=2.;
  a73=arg[2]? arg[2][0] : 0;
  a74=(a72*a73);
  a75=arg[2]? arg[2][2] : 0;
  a76=(a74*a75);
  a77=arg[2]? arg[2][1] : 0;
  a78=arg[2]? arg[2][3] : 0;
  a79=(a77*a78);
  a79=(a72*a79);
  a80=(a76+a79);
  a81=(a47*a80);
  a82=(a04*a81);
  a82=(a10+a82);
  a83=(a73*a73);
  a84=(a78*a78);
  a85=(a75*a75);
  a86=(a84+a85);
  a86=(a83-a86);
  a87=(a77*a77);
  a86=(a86+a87);
  a51=(a04*a51);
  a51=(a42+a51);
  a29=(a04*a29);
  a51=(a51-a29);
  a55=(a55*a66);
  a65=(a65+a55);
  a60=(a60*a67);
  a65=(a65+a60);
  a64=(a64*a54);
  a65=(a65-a64);
  a59=(a65*a59);
  a51=(a51+a59);
  a69=(a37*a69);
  a51=(a51+a69);
  a52=(a52*a24);
  a61=(a61*a28);
  a52=(a52+a61);
  a61=arg[9]? arg[9][2] : 0;
  a21=(a21*a61);
  a52=(a52-a21);
  a40=(a40+a52);
  a70=(a40*a70);
  a51=(a51-a70);
  a46=(a46-a57);
  a63=(a63*a46);
  a57=(a38*a63);
  a51=(a51-a57);
  a22=(a58*a22);
  a57=(a32*a22);
  a51=(a51-a57);
  a51=(a51-a44);
  a44=(a58*a37);
  a48=(a48*a44);
  a51=(a51+a48);
  a48=(a86*a51);
  a57=(a04*a48);
  a82=(a82+a57);
  a45=(a04*a45);
  a45=(a27-a45);
  a36=(a04*a36);
  a45=(a45+a36);
  a68=(a37*a68);
  a45=(a45-a68);
  a44=(a44*a71);
  a45=(a45-a44);
  a22=(a22*a53);
  a45=(a45+a22);
  a63=(a56*a63);
  a45=(a45+a63);
  a30=(a65*a30);
  a45=(a45-a30);
  a45=(a45-a50);
  a40=(a40*a62);
  a45=(a45+a40);
  a40=(a77*a75);
  a40=(a72*a40);
  a62=(a74*a78);
  a50=(a40-a62);
  a30=(a45*a50);
  a63=(a04*a30);
  a82=(a82+a63);
  a63=arg[1]? arg[1][1] : 0;
  a22=(a75*a78);
  a22=(a72*a22);
  a74=(a74*a77);
  a44=(a22-a74);
  a71=(a44*a47);
  a68=(a04*a71);
  a68=(a63+a68);
  a62=(a62+a40);
  a40=(a62*a51);
  a36=(a04*a40);
  a68=(a68+a36);
  a85=(a85-a84);
  a83=(a83-a87);
  a87=(a85+a83);
  a84=(a87*a45);
  a36=(a04*a84);
  a68=(a68+a36);
  a36=6378137.;
  a14=(a02/a14);
  a57=(a36*a14);
  a57=(a03+a57);
  a57=(a63/a57);
  a70=1.4584230000000000e-04;
  a21=cos(a00);
  a61=(a70*a21);
  a61=(a57+a61);
  a28=(a61*a06);
  a24=(a70*a11);
  a11=(a11/a21);
  a57=(a57*a11);
  a24=(a24+a57);
  a57=(a24*a10);
  a28=(a28+a57);
  a28=(a05*a28);
  a28=(a68+a28);
  a19=(a02/a19);
  a36=(a36*a19);
  a36=(a07+a36);
  a36=(a02/a36);
  a57=(a28*a36);
  a16=cos(a16);
  a11=(a02/a16);
  a21=(a17*a11);
  a21=(a57*a21);
  a69=(a70*a17);
  a69=(a21+a69);
  a59=(a28*a69);
  a15=(a15*a06);
  a24=(a24*a63);
  a15=(a15-a24);
  a15=(a05*a15);
  a15=(a82+a15);
  a09=(a15*a09);
  a79=(a79-a76);
  a51=(a79*a51);
  a76=(a04*a51);
  a76=(a06+a76);
  a74=(a74+a22);
  a45=(a74*a45);
  a22=(a04*a45);
  a76=(a76+a22);
  a83=(a83-a85);
  a47=(a83*a47);
  a85=(a04*a47);
  a76=(a76+a85);
  a85=9.7803253359000006e+00;
  a22=1.8894147482439335e-02;
  a24=(a22*a12);
  a24=(a85+a24);
  a24=(a24*a14);
  a14=7.3745167729419953e-14;
  a64=(a03*a03);
  a64=(a14*a64);
  a64=(a02+a64);
  a54=1.5678559428873979e-07;
  a60=2.0136051943431768e+00;
  a67=1.3411242658989924e-02;
  a12=(a67*a12);
  a12=(a60-a12);
  a12=(a03*a12);
  a12=(a54*a12);
  a64=(a64-a12);
  a24=(a24*a64);
  a61=(a61*a63);
  a24=(a24-a61);
  a61=(a10*a10);
  a61=(a61*a13);
  a24=(a24-a61);
  a24=(a05*a24);
  a24=(a76+a24);
  a61=(a09*a24);
  a59=(a59-a61);
  a59=(a01*a59);
  a61=(a04*a59);
  a82=(a82-a61);
  a61=2.5000000000000000e-01;
  a13=(a61*a01);
  a64=7.2921149999999999e-05;
  a17=(a64*a17);
  a21=(a21+a17);
  a71=(a71+a40);
  a71=(a71+a84);
  a84=(a21*a71);
  a40=(a13*a84);
  a82=(a82-a40);
  a42=(a42+a25);
  a42=(a42-a41);
  a41=(a58*a42);
  a86=(a86*a41);
  a82=(a82-a86);
  a49=(a49+a34);
  a49=(a49+a27);
  a27=(a58*a49);
  a50=(a27*a50);
  a82=(a82-a50);
  a52=(a52+a46);
  a52=(a52+a26);
  a26=(a58*a52);
  a80=(a26*a80);
  a82=(a82-a80);
  a51=(a51+a45);
  a51=(a51+a47);
  a47=(a09*a13);
  a45=(a51*a47);
  a82=(a82+a45);
  a20=(a20*a82);
  a00=(a00+a20);
  if (res[0]!=0) res[0][0]=a00;
  a00=arg[0]? arg[0][1] : 0;
  a36=(a01*a36);
  a69=(a15*a69);
  a70=(a70*a16);
  a70=(a57+a70);
  a24=(a70*a24);
  a69=(a69+a24);
  a69=(a01*a69);
  a24=(a04*a69);
  a68=(a68+a24);
  a24=(a13*a51);
  a64=(a64*a16);
  a57=(a57+a64);
  a24=(a24*a57);
  a68=(a68+a24);
  a44=(a44*a26);
  a68=(a68-a44);
  a62=(a62*a41);
  a68=(a68-a62);
  a87=(a87*a27);
  a68=(a68-a87);
  a81=(a81+a48);
  a81=(a81+a30);
  a30=(a21*a81);
  a13=(a13*a30);
  a68=(a68+a13);
  a36=(a36*a68);
  a36=(a36*a11);
  a00=(a00+a36);
  if (res[0]!=0) res[0][1]=a00;
  a49=(a49*a74);
  a49=(a58*a49);
  a52=(a52*a83);
  a52=(a58*a52);
  a49=(a49+a52);
  a42=(a42*a79);
  a42=(a58*a42);
  a49=(a49+a42);
  a42=(a71*a57);
  a42=(a42*a01);
  a61=(a61*a42);
  a49=(a49+a61);
  a49=(a49-a76);
  a22=(a22*a18);
  a85=(a85+a22);
  a85=(a85*a19);
  a19=(a07*a07);
  a14=(a14*a19);
  a14=(a02+a14);
  a67=(a67*a18);
  a60=(a60-a67);
  a07=(a07*a60);
  a54=(a54*a07);
  a14=(a14-a54);
  a85=(a85*a14);
  a14=(a15*a09);
  a85=(a85-a14);
  a28=(a28*a70);
  a85=(a85-a28);
  a85=(a01*a85);
  a28=(a04*a85);
  a49=(a49-a28);
  a47=(a47*a81);
  a49=(a49+a47);
  a49=(a01*a49);
  a03=(a03+a49);
  if (res[0]!=0) res[0][2]=a03;
  a59=(a81-a59);
  a59=(a59+a10);
  a84=(a05*a84);
  a59=(a59-a84);
  a84=(a05*a09);
  a10=(a51*a84);
  a59=(a59+a10);
  if (res[1]!=0) res[1][0]=a59;
  a69=(a71+a69);
  a69=(a69+a63);
  a63=(a05*a57);
  a59=(a51*a63);
  a69=(a69+a59);
  a30=(a05*a30);
  a69=(a69+a30);
  if (res[1]!=0) res[1][1]=a69;
  a51=(a51+a85);
  a51=(a51+a06);
  a81=(a81*a84);
  a51=(a51-a81);
  a71=(a71*a63);
  a51=(a51-a71);
  if (res[1]!=0) res[1][2]=a51;
  a51=1.0000000000000001e-30;
  a71=(a56*a65);
  a71=(a58*a71);
  a63=(a37*a53);
  a63=(a58*a63);
  a71=(a71-a63);
  a71=(a71-a38);
  a63=(a71*a71);
  a63=(a51+a63);
  a53=(a38*a53);
  a53=(a58*a53);
  a81=(a32*a56);
  a81=(a58*a81);
  a53=(a53-a81);
  a53=(a53-a37);
  a81=(a53*a53);
  a63=(a63+a81);
  a37=(a37*a32);
  a37=(a58*a37);
  a65=(a65*a38);
  a58=(a58*a65);
  a37=(a37-a58);
  a37=(a37-a56);
  a56=(a37*a37);
  a63=(a63+a56);
  a63=sqrt(a63);
  a56=(a04*a63);
  a58=cos(a56);
  a65=(a58*a73);
  a56=sin(a56);
  a56=(a56/a63);
  a63=(a56*a75);
  a38=(a71*a63);
  a65=(a65-a38);
  a38=(a56*a77);
  a32=(a37*a38);
  a65=(a65-a32);
  a32=(a53*a56);
  a81=(a32*a78);
  a65=(a65-a81);
  a81=(a01*a01);
  a84=(a21*a21);
  a84=(a81*a84);
  a51=(a51+a84);
  a84=(a57*a57);
  a84=(a81*a84);
  a51=(a51+a84);
  a15=(a15*a15);
  a15=(a81*a15);
  a08=(a08*a08);
  a15=(a15/a08);
  a51=(a51+a15);
  a51=sqrt(a51);
  a15=(a04*a51);
  a08=cos(a15);
  a84=(a65*a08);
  a06=(a56*a73);
  a85=(a71*a06);
  a56=(a56*a78);
  a69=(a37*a56);
  a85=(a85+a69);
  a75=(a58*a75);
  a85=(a85+a75);
  a75=(a53*a38);
  a85=(a85-a75);
  a15=sin(a15);
  a51=(a02/a51);
  a75=(a15*a51);
  a75=(a75*a01);
  a69=(a09*a75);
  a30=(a85*a69);
  a84=(a84-a30);
  a53=(a53*a63);
  a06=(a37*a06);
  a53=(a53+a06);
  a77=(a58*a77);
  a53=(a53+a77);
  a56=(a71*a56);
  a53=(a53-a56);
  a56=(a57*a75);
  a77=(a53*a56);
  a84=(a84+a77);
  a71=(a71*a38);
  a58=(a58*a78);
  a71=(a71+a58);
  a32=(a32*a73);
  a71=(a71+a32);
  a37=(a37*a63);
  a71=(a71-a37);
  a21=(a21*a75);
  a75=(a71*a21);
  a84=(a84-a75);
  a75=(a84*a84);
  a37=(a08*a71);
  a09=(a09*a51);
  a09=(a09*a15);
  a09=(a09*a53);
  a09=(a09*a01);
  a37=(a37-a09);
  a09=(a65*a21);
  a37=(a37+a09);
  a09=(a85*a56);
  a37=(a37-a09);
  a09=(a37*a37);
  a75=(a75+a09);
  a09=(a08*a53);
  a63=(a85*a21);
  a09=(a09-a63);
  a56=(a65*a56);
  a09=(a09-a56);
  a56=(a69*a71);
  a09=(a09+a56);
  a56=(a09*a09);
  a75=(a75+a56);
  a08=(a08*a85);
  a57=(a57*a51);
  a57=(a57*a15);
  a57=(a57*a71);
  a57=(a57*a01);
  a08=(a08+a57);
  a65=(a65*a69);
  a08=(a08+a65);
  a53=(a53*a21);
  a08=(a08+a53);
  a53=(a08*a08);
  a75=(a75+a53);
  a75=sqrt(a75);
  a02=(a02/a75);
  a84=(a84*a02);
  if (res[2]!=0) res[2][0]=a84;
  a09=(a09*a02);
  if (res[2]!=0) res[2][1]=a09;
  a08=(a08*a02);
  if (res[2]!=0) res[2][2]=a08;
  a37=(a37*a02);
  if (res[2]!=0) res[2][3]=a37;
  a37=arg[10]? arg[10][0] : 0;
  a02=arg[12]? arg[12][0] : 0;
  a08=(a02*a02);
  a09=(a05*a08);
  a09=(a09*a37);
  a84=arg[11]? arg[11][0] : 0;
  a09=(a09-a84);
  a75=arg[13]? arg[13][0] : 0;
  a75=(a75*a02);
  a02=(a75*a84);
  a02=(a02*a01);
  a09=(a09+a02);
  a09=(a01*a09);
  a02=(a37-a09);
  if (res[3]!=0) res[3][0]=a02;
  a02=arg[10]? arg[10][1] : 0;
  a53=arg[12]? arg[12][1] : 0;
  a21=(a53*a53);
  a65=(a05*a21);
  a65=(a65*a02);
  a69=arg[11]? arg[11][1] : 0;
  a65=(a65-a69);
  a57=arg[13]? arg[13][1] : 0;
  a57=(a57*a53);
  a53=(a57*a69);
  a53=(a53*a01);
  a65=(a65+a53);
  a65=(a01*a65);
  a53=(a02-a65);
  if (res[3]!=0) res[3][1]=a53;
  a53=arg[10]? arg[10][2] : 0;
  a71=arg[12]? arg[12][2] : 0;
  a15=(a71*a71);
  a51=(a05*a15);
  a51=(a51*a53);
  a85=arg[11]? arg[11][2] : 0;
  a51=(a51-a85);
  a56=arg[13]? arg[13][2] : 0;
  a56=(a56*a71);
  a71=(a56*a85);
  a71=(a71*a01);
  a51=(a51+a71);
  a51=(a01*a51);
  a71=(a53-a51);
  if (res[3]!=0) res[3][2]=a71;
  a75=(a75*a09);
  a75=(-a75);
  a75=(a72*a75);
  a75=(a75-a84);
  a08=(a08*a01);
  a84=(a05*a84);
  a37=(a37+a84);
  a08=(a08*a37);
  a75=(a75+a08);
  a75=(-a75);
  if (res[4]!=0) res[4][0]=a75;
  a57=(a57*a65);
  a57=(-a57);
  a57=(a72*a57);
  a57=(a57-a69);
  a21=(a21*a01);
  a69=(a05*a69);
  a02=(a02+a69);
  a21=(a21*a02);
  a57=(a57+a21);
  a57=(-a57);
  if (res[4]!=0) res[4][1]=a57;
  a56=(a56*a51);
  a56=(-a56);
  a72=(a72*a56);
  a72=(a72-a85);
  a15=(a15*a01);
  a05=(a05*a85);
  a53=(a53+a05);
  a15=(a15*a53);
  a72=(a72+a15);
  a72=(-a72);
  if (res[4]!=0) res[4][2]=a72;
  a72=arg[18]? arg[18][0] : 0;
  a72=(a33-a72);
  a15=arg[20]? arg[20][0] : 0;
  a53=(a15*a01);
  a04=(a04*a81);
  a15=(a15*a15);
  a15=(a04*a15);
  a53=(a53-a15);
  a72=(a72*a53);
  a33=(a33-a72);
  if (res[5]!=0) res[5][0]=a33;
  a33=arg[18]? arg[18][1] : 0;
  a33=(a31-a33);
  a72=arg[20]? arg[20][1] : 0;
  a53=(a72*a01);
  a72=(a72*a72);
  a72=(a04*a72);
  a53=(a53-a72);
  a33=(a33*a53);
  a31=(a31-a33);
  if (res[5]!=0) res[5][1]=a31;
  a31=arg[18]? arg[18][2] : 0;
  a31=(a35-a31);
  a33=arg[20]? arg[20][2] : 0;
  a53=(a33*a01);
  a33=(a33*a33);
  a33=(a04*a33);
  a53=(a53-a33);
  a31=(a31*a53);
  a35=(a35-a31);
  if (res[5]!=0) res[5][2]=a35;
  a35=arg[19]? arg[19][0] : 0;
  a35=(a43-a35);
  a31=arg[21]? arg[21][0] : 0;
  a53=(a31*a01);
  a31=(a31*a31);
  a31=(a04*a31);
  a53=(a53-a31);
  a35=(a35*a53);
  a43=(a43-a35);
  if (res[6]!=0) res[6][0]=a43;
  a43=arg[19]? arg[19][1] : 0;
  a43=(a23-a43);
  a35=arg[21]? arg[21][1] : 0;
  a53=(a35*a01);
  a35=(a35*a35);
  a35=(a04*a35);
  a53=(a53-a35);
  a43=(a43*a53);
  a23=(a23-a43);
  if (res[6]!=0) res[6][1]=a23;
  a23=arg[19]? arg[19][2] : 0;
  a23=(a39-a23);
  a43=arg[21]? arg[21][2] : 0;
  a01=(a43*a01);
  a43=(a43*a43);
  a04=(a04*a43);
  a01=(a01-a04);
  a23=(a23*a01);
  a39=(a39-a23);
  if (res[6]!=0) res[6][2]=a39;
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



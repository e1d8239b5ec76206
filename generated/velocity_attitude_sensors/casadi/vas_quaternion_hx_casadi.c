/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_quaternion_h_casadi__ ## ID
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
#define casadi_s4 CASADI_PREFIX(s4)

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
CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {46, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};
static const casadi_int casadi_s4[3] = {6, 1, 1};

/* vas_quaternion_h_casadi:(x[46],lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag,flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84;
  a00=2.;
  a01=arg[4]? arg[4][0] : 0;
  a02=1.;
  a03=2.5000000000000000e-01;
  a04=arg[8]? arg[8][0] : 0;
  a05=(a04*a04);
  a05=(a03*a05);
  a05=(a02+a05);
  a06=arg[8]? arg[8][1] : 0;
  a07=(a06*a06);
  a07=(a03*a07);
  a05=(a05+a07);
  a07=arg[8]? arg[8][2] : 0;
  a08=(a07*a07);
  a03=(a03*a08);
  a05=(a05+a03);
  a05=sqrt(a05);
  a05=(a02/a05);
  a03=(a01*a05);
  a08=arg[4]? arg[4][1] : 0;
  a09=(a08*a05);
  a10=5.0000000000000000e-01;
  a11=(a10*a04);
  a12=(a09*a11);
  a12=(a03-a12);
  a13=arg[4]? arg[4][3] : 0;
  a14=(a13*a05);
  a15=(a10*a14);
  a16=(a15*a07);
  a12=(a12-a16);
  a16=arg[4]? arg[4][2] : 0;
  a05=(a16*a05);
  a17=(a10*a06);
  a18=(a05*a17);
  a12=(a12-a18);
  a18=arg[3]? arg[3][1] : 0;
  a19=(a12*a18);
  a20=(a10*a07);
  a21=(a09*a20);
  a21=(a05+a21);
  a03=(a10*a03);
  a22=(a03*a06);
  a21=(a21+a22);
  a22=(a15*a04);
  a21=(a21-a22);
  a22=arg[3]? arg[3][3] : 0;
  a23=(a21*a22);
  a19=(a19+a23);
  a07=(a03*a07);
  a14=(a14+a07);
  a11=(a05*a11);
  a14=(a14+a11);
  a17=(a09*a17);
  a14=(a14-a17);
  a17=arg[3]? arg[3][2] : 0;
  a11=(a14*a17);
  a19=(a19-a11);
  a03=(a03*a04);
  a09=(a09+a03);
  a15=(a15*a06);
  a09=(a09+a15);
  a05=(a05*a20);
  a09=(a09-a05);
  a05=arg[3]? arg[3][0] : 0;
  a20=(a09*a05);
  a19=(a19-a20);
  a20=1.0000000000000001e-30;
  a15=arg[7]? arg[7][0] : 0;
  a06=(a15*a15);
  a03=arg[2]? arg[2][0] : 0;
  a04=arg[1]? arg[1][2] : 0;
  a11=6.3354393272928204e+06;
  a07=6.6943799901413173e-03;
  a23=arg[1]? arg[1][0] : 0;
  a24=sin(a23);
  a25=(a24*a24);
  a07=(a07*a25);
  a07=(a02-a07);
  a25=sqrt(a07);
  a07=(a07*a25);
  a11=(a11/a07);
  a11=(a04+a11);
  a03=(a03/a11);
  a11=arg[5]? arg[5][2] : 0;
  a07=arg[10]? arg[10][2] : 0;
  a26=(a02-a07);
  a26=(a11*a26);
  a27=(a00*a01);
  a28=(a27*a16);
  a29=(a00*a13);
  a29=(a29*a08);
  a30=(a28+a29);
  a31=arg[9]? arg[9][0] : 0;
  a32=(a30*a31);
  a26=(a26-a32);
  a33=(a16*a13);
  a33=(a00*a33);
  a34=(a27*a08);
  a35=(a33-a34);
  a36=arg[9]? arg[9][1] : 0;
  a37=(a35*a36);
  a26=(a26-a37);
  a38=(a13*a13);
  a39=(a08*a08);
  a40=(a38-a39);
  a01=(a01*a01);
  a41=(a16*a16);
  a42=(a01-a41);
  a40=(a40+a42);
  a43=arg[9]? arg[9][2] : 0;
  a44=(a40*a43);
  a26=(a26-a44);
  a45=arg[11]? arg[11][4] : 0;
  a46=arg[5]? arg[5][0] : 0;
  a47=(a45*a46);
  a26=(a26-a47);
  a47=arg[11]? arg[11][5] : 0;
  a48=arg[5]? arg[5][1] : 0;
  a49=(a47*a48);
  a26=(a26-a49);
  a49=(a17*a22);
  a49=(a00*a49);
  a50=(a00*a05);
  a51=(a50*a18);
  a52=(a49-a51);
  a52=(a26*a52);
  a52=(a03+a52);
  a53=arg[10]? arg[10][0] : 0;
  a54=(a02-a53);
  a54=(a46*a54);
  a27=(a27*a13);
  a08=(a08*a16);
  a08=(a00*a08);
  a16=(a27+a08);
  a13=(a16*a36);
  a54=(a54-a13);
  a29=(a29-a28);
  a28=(a29*a43);
  a54=(a54-a28);
  a42=(a39+a42);
  a42=(a42-a38);
  a55=(a42*a31);
  a54=(a54-a55);
  a56=arg[11]? arg[11][0] : 0;
  a57=(a56*a48);
  a54=(a54-a57);
  a57=arg[11]? arg[11][1] : 0;
  a58=(a57*a11);
  a54=(a54-a58);
  a58=(a50*a22);
  a59=(a00*a17);
  a59=(a59*a18);
  a60=(a58+a59);
  a60=(a54*a60);
  a52=(a52+a60);
  a60=arg[10]? arg[10][1] : 0;
  a61=(a02-a60);
  a61=(a48*a61);
  a08=(a08-a27);
  a27=(a08*a31);
  a61=(a61-a27);
  a34=(a34+a33);
  a33=(a34*a43);
  a61=(a61-a33);
  a01=(a01-a39);
  a01=(a01+a41);
  a01=(a01-a38);
  a38=(a01*a36);
  a61=(a61-a38);
  a41=arg[11]? arg[11][2] : 0;
  a39=(a41*a46);
  a61=(a61-a39);
  a39=arg[11]? arg[11][3] : 0;
  a62=(a39*a11);
  a61=(a61-a62);
  a62=(a17*a17);
  a63=(a22*a22);
  a64=(a62-a63);
  a65=(a05*a05);
  a66=(a18*a18);
  a67=(a65-a66);
  a64=(a64+a67);
  a64=(a61*a64);
  a52=(a52+a64);
  a64=(a52*a52);
  a64=(a06*a64);
  a64=(a20+a64);
  a50=(a50*a17);
  a68=(a18*a22);
  a68=(a00*a68);
  a69=(a50+a68);
  a69=(a26*a69);
  a70=7.2921149999999999e-05;
  a23=cos(a23);
  a71=(a70*a23);
  a72=arg[2]? arg[2][1] : 0;
  a73=6378137.;
  a73=(a73/a25);
  a04=(a04+a73);
  a72=(a72/a04);
  a71=(a71+a72);
  a69=(a69-a71);
  a65=(a65-a63);
  a65=(a65+a66);
  a65=(a65-a62);
  a65=(a54*a65);
  a69=(a69+a65);
  a59=(a59-a58);
  a59=(a61*a59);
  a69=(a69+a59);
  a59=(a69*a69);
  a59=(a06*a59);
  a64=(a64+a59);
  a70=(a70*a24);
  a24=(a24/a23);
  a72=(a72*a24);
  a70=(a70+a72);
  a63=(a63+a67);
  a63=(a63-a62);
  a26=(a26*a63);
  a26=(a70+a26);
  a68=(a68-a50);
  a54=(a54*a68);
  a26=(a26+a54);
  a51=(a51+a49);
  a61=(a61*a51);
  a26=(a26+a61);
  a61=(a26*a26);
  a06=(a06*a61);
  a64=(a64+a06);
  a64=sqrt(a64);
  a06=(a10*a64);
  a61=cos(a06);
  a51=(a19*a61);
  a06=sin(a06);
  a06=(a15*a06);
  a06=(a06/a64);
  a64=(a14*a22);
  a49=(a12*a05);
  a64=(a64+a49);
  a49=(a21*a17);
  a64=(a64+a49);
  a49=(a09*a18);
  a64=(a64+a49);
  a49=(a06*a64);
  a54=(a69*a49);
  a51=(a51-a54);
  a54=(a12*a22);
  a68=(a09*a17);
  a54=(a54+a68);
  a68=(a14*a05);
  a54=(a54-a68);
  a68=(a21*a18);
  a54=(a54-a68);
  a68=(a52*a06);
  a50=(a54*a68);
  a51=(a51-a50);
  a50=(a14*a18);
  a63=(a12*a17);
  a50=(a50+a63);
  a63=(a21*a05);
  a50=(a50-a63);
  a63=(a09*a22);
  a50=(a50-a63);
  a63=(a06*a50);
  a62=(a26*a63);
  a51=(a51+a62);
  a62=arg[6]? arg[6][1] : 0;
  a67=(a51*a62);
  a72=(a61*a54);
  a63=(a69*a63);
  a24=(a26*a49);
  a63=(a63+a24);
  a72=(a72-a63);
  a63=(a19*a68);
  a72=(a72+a63);
  a63=arg[6]? arg[6][3] : 0;
  a24=(a72*a63);
  a67=(a67+a24);
  a24=(a61*a50);
  a52=(a52*a49);
  a19=(a19*a06);
  a49=(a26*a19);
  a52=(a52+a49);
  a24=(a24-a52);
  a54=(a54*a06);
  a06=(a69*a54);
  a24=(a24+a06);
  a06=arg[6]? arg[6][2] : 0;
  a52=(a24*a06);
  a67=(a67+a52);
  a61=(a61*a64);
  a69=(a69*a19);
  a61=(a61+a69);
  a26=(a26*a54);
  a61=(a61+a26);
  a68=(a68*a50);
  a61=(a61+a68);
  a68=arg[6]? arg[6][0] : 0;
  a50=(a61*a68);
  a67=(a67+a50);
  a50=0.;
  a67=(a67<a50);
  a26=(!a67);
  a26=(a26-a67);
  a26=(a00*a26);
  a67=(a51*a68);
  a54=(a72*a06);
  a67=(a67+a54);
  a54=(a24*a63);
  a67=(a67-a54);
  a54=(a61*a62);
  a67=(a67-a54);
  a67=(a26*a67);
  a54=arg[0]? arg[0][12] : 0;
  a69=arg[0]? arg[0][19] : 0;
  a69=(a54-a69);
  a19=(a69*a69);
  a19=(a20+a19);
  a64=arg[0]? arg[0][13] : 0;
  a52=arg[0]? arg[0][20] : 0;
  a52=(a64-a52);
  a49=(a52*a52);
  a19=(a19+a49);
  a49=arg[0]? arg[0][14] : 0;
  a23=arg[0]? arg[0][21] : 0;
  a23=(a49-a23);
  a59=(a23*a23);
  a19=(a19+a59);
  a19=sqrt(a19);
  a59=(a10*a19);
  a58=sin(a59);
  a58=(a58/a19);
  a19=(a58*a09);
  a19=(a19*a52);
  a59=cos(a59);
  a65=(a14*a59);
  a19=(a19-a65);
  a65=(a58*a21);
  a66=(a65*a69);
  a19=(a19-a66);
  a66=(a58*a23);
  a04=(a66*a12);
  a19=(a19-a04);
  a04=arg[0]? arg[0][2] : 0;
  a73=(a04*a04);
  a73=(a20+a73);
  a25=arg[0]? arg[0][1] : 0;
  a74=(a25*a25);
  a73=(a73+a74);
  a74=arg[0]? arg[0][0] : 0;
  a75=(a74*a74);
  a73=(a73+a75);
  a73=sqrt(a73);
  a75=(a10*a73);
  a76=cos(a75);
  a77=(a76*a17);
  a75=sin(a75);
  a75=(a75/a73);
  a73=(a75*a04);
  a78=(a73*a18);
  a77=(a77+a78);
  a78=(a75*a25);
  a79=(a78*a05);
  a77=(a77+a79);
  a79=(a75*a22);
  a80=(a79*a74);
  a77=(a77-a80);
  a80=(a19*a77);
  a81=(a75*a74);
  a82=(a81*a05);
  a83=(a76*a18);
  a82=(a82+a83);
  a83=(a79*a25);
  a82=(a82+a83);
  a75=(a75*a17);
  a17=(a75*a04);
  a82=(a82-a17);
  a17=(a12*a59);
  a83=(a65*a52);
  a17=(a17-a83);
  a83=(a58*a69);
  a84=(a83*a09);
  a17=(a17-a84);
  a14=(a14*a58);
  a84=(a14*a23);
  a17=(a17-a84);
  a84=(a82*a17);
  a80=(a80+a84);
  a84=(a76*a05);
  a81=(a81*a18);
  a84=(a84-a81);
  a25=(a75*a25);
  a84=(a84-a25);
  a79=(a79*a04);
  a84=(a84-a79);
  a65=(a65*a23);
  a83=(a83*a12);
  a65=(a65-a83);
  a83=(a14*a52);
  a65=(a65-a83);
  a83=(a09*a59);
  a65=(a65-a83);
  a83=(a84*a65);
  a80=(a80+a83);
  a75=(a75*a74);
  a76=(a76*a22);
  a75=(a75+a76);
  a73=(a73*a05);
  a75=(a75+a73);
  a78=(a78*a18);
  a75=(a75-a78);
  a14=(a14*a69);
  a66=(a66*a09);
  a14=(a14-a66);
  a21=(a21*a59);
  a14=(a14-a21);
  a58=(a58*a12);
  a58=(a58*a52);
  a14=(a14-a58);
  a58=(a75*a14);
  a80=(a80-a58);
  a58=arg[0]? arg[0][15] : 0;
  a15=(a15-a58);
  a58=(a15*a15);
  a52=arg[0]? arg[0][6] : 0;
  a52=(a52+a46);
  a46=arg[0]? arg[0][35] : 0;
  a46=(a46-a45);
  a46=(a52*a46);
  a45=arg[0]? arg[0][7] : 0;
  a45=(a45+a48);
  a48=arg[0]? arg[0][36] : 0;
  a48=(a48-a47);
  a48=(a45*a48);
  a46=(a46+a48);
  a48=arg[0]? arg[0][8] : 0;
  a48=(a48+a11);
  a11=arg[0]? arg[0][27] : 0;
  a11=(a02+a11);
  a11=(a11-a07);
  a11=(a48*a11);
  a46=(a46+a11);
  a11=arg[0]? arg[0][23] : 0;
  a07=(a31*a49);
  a11=(a11+a07);
  a07=(a43*a54);
  a11=(a11-a07);
  a35=(a11*a35);
  a46=(a46+a35);
  a35=arg[0]? arg[0][22] : 0;
  a43=(a43*a64);
  a35=(a35+a43);
  a49=(a36*a49);
  a35=(a35-a49);
  a30=(a35*a30);
  a46=(a46+a30);
  a30=arg[0]? arg[0][24] : 0;
  a36=(a36*a54);
  a30=(a30+a36);
  a31=(a31*a64);
  a30=(a30-a31);
  a40=(a30*a40);
  a46=(a46+a40);
  a46=(a46-a32);
  a46=(a46-a37);
  a46=(a46-a44);
  a44=(a00*a77);
  a37=(a75*a44);
  a32=(a00*a84);
  a40=(a82*a32);
  a31=(a37-a40);
  a31=(a46*a31);
  a03=(a03+a31);
  a31=arg[0]? arg[0][25] : 0;
  a31=(a02+a31);
  a31=(a31-a53);
  a31=(a52*a31);
  a53=arg[0]? arg[0][31] : 0;
  a53=(a53-a56);
  a53=(a45*a53);
  a31=(a31+a53);
  a53=arg[0]? arg[0][32] : 0;
  a53=(a53-a57);
  a53=(a48*a53);
  a31=(a31+a53);
  a16=(a11*a16);
  a31=(a31+a16);
  a42=(a35*a42);
  a31=(a31+a42);
  a29=(a30*a29);
  a31=(a31+a29);
  a31=(a31-a13);
  a31=(a31-a28);
  a31=(a31-a55);
  a55=(a75*a32);
  a44=(a82*a44);
  a28=(a55+a44);
  a28=(a31*a28);
  a03=(a03+a28);
  a28=arg[0]? arg[0][33] : 0;
  a28=(a28-a41);
  a52=(a52*a28);
  a28=arg[0]? arg[0][26] : 0;
  a02=(a02+a28);
  a02=(a02-a60);
  a45=(a45*a02);
  a52=(a52+a45);
  a45=arg[0]? arg[0][34] : 0;
  a45=(a45-a39);
  a48=(a48*a45);
  a52=(a52+a48);
  a11=(a11*a01);
  a52=(a52+a11);
  a35=(a35*a08);
  a52=(a52+a35);
  a30=(a30*a34);
  a52=(a52+a30);
  a52=(a52-a27);
  a52=(a52-a33);
  a52=(a52-a38);
  a38=(a82*a82);
  a33=(a84*a84);
  a27=(a38-a33);
  a30=(a75*a75);
  a34=(a77*a77);
  a35=(a30-a34);
  a27=(a27+a35);
  a27=(a52*a27);
  a03=(a03-a27);
  a27=(a03*a03);
  a27=(a58*a27);
  a20=(a20+a27);
  a27=(a82*a75);
  a27=(a00*a27);
  a32=(a32*a77);
  a08=(a27+a32);
  a08=(a46*a08);
  a08=(a08-a71);
  a30=(a30-a33);
  a30=(a30+a34);
  a30=(a30-a38);
  a30=(a31*a30);
  a08=(a08-a30);
  a44=(a44-a55);
  a44=(a52*a44);
  a08=(a08+a44);
  a44=(a08*a08);
  a44=(a58*a44);
  a20=(a20+a44);
  a33=(a33+a35);
  a33=(a33-a38);
  a46=(a46*a33);
  a70=(a70+a46);
  a27=(a27-a32);
  a31=(a31*a27);
  a70=(a70+a31);
  a37=(a37+a40);
  a52=(a52*a37);
  a70=(a70+a52);
  a52=(a70*a70);
  a58=(a58*a52);
  a20=(a20+a58);
  a20=sqrt(a20);
  a10=(a10*a20);
  a58=cos(a10);
  a52=(a80*a58);
  a10=sin(a10);
  a15=(a15*a10);
  a15=(a15/a20);
  a20=(a17*a84);
  a10=(a19*a75);
  a20=(a20-a10);
  a10=(a82*a65);
  a20=(a20-a10);
  a10=(a14*a77);
  a20=(a20-a10);
  a10=(a15*a20);
  a37=(a08*a10);
  a52=(a52-a37);
  a37=(a19*a84);
  a40=(a82*a14);
  a37=(a37+a40);
  a40=(a17*a75);
  a37=(a37+a40);
  a40=(a65*a77);
  a37=(a37-a40);
  a40=(a03*a15);
  a31=(a37*a40);
  a52=(a52-a31);
  a17=(a17*a77);
  a75=(a75*a65);
  a17=(a17+a75);
  a14=(a14*a84);
  a17=(a17+a14);
  a19=(a19*a82);
  a17=(a17-a19);
  a19=(a15*a17);
  a82=(a70*a19);
  a52=(a52+a82);
  a82=(a52*a62);
  a14=(a58*a37);
  a19=(a08*a19);
  a84=(a70*a10);
  a19=(a19+a84);
  a14=(a14-a19);
  a19=(a80*a40);
  a14=(a14+a19);
  a19=(a14*a63);
  a82=(a82+a19);
  a19=(a58*a17);
  a03=(a03*a10);
  a80=(a80*a15);
  a10=(a70*a80);
  a03=(a03+a10);
  a19=(a19-a03);
  a37=(a37*a15);
  a15=(a08*a37);
  a19=(a19+a15);
  a15=(a19*a06);
  a82=(a82+a15);
  a58=(a58*a20);
  a08=(a08*a80);
  a58=(a58+a08);
  a70=(a70*a37);
  a58=(a58+a70);
  a40=(a40*a17);
  a58=(a58+a40);
  a40=(a58*a68);
  a82=(a82+a40);
  a82=(a82<a50);
  a50=(!a82);
  a50=(a50-a82);
  a00=(a00*a50);
  a50=(a52*a68);
  a82=(a14*a06);
  a50=(a50+a82);
  a82=(a19*a63);
  a50=(a50-a82);
  a82=(a58*a62);
  a50=(a50-a82);
  a50=(a00*a50);
  a67=(a67-a50);
  if (res[0]!=0) res[0][0]=a67;
  a67=(a51*a63);
  a50=(a24*a68);
  a67=(a67+a50);
  a50=(a72*a62);
  a67=(a67-a50);
  a50=(a61*a06);
  a67=(a67-a50);
  a67=(a26*a67);
  a50=(a52*a63);
  a82=(a19*a68);
  a50=(a50+a82);
  a82=(a14*a62);
  a50=(a50-a82);
  a82=(a58*a06);
  a50=(a50-a82);
  a50=(a00*a50);
  a67=(a67-a50);
  if (res[0]!=0) res[0][1]=a67;
  a72=(a72*a68);
  a24=(a24*a62);
  a72=(a72+a24);
  a51=(a51*a06);
  a72=(a72-a51);
  a61=(a61*a63);
  a72=(a72-a61);
  a26=(a26*a72);
  a14=(a14*a68);
  a19=(a19*a62);
  a14=(a14+a19);
  a52=(a52*a06);
  a14=(a14-a52);
  a58=(a58*a63);
  a14=(a14-a58);
  a00=(a00*a14);
  a26=(a26-a00);
  if (res[0]!=0) res[0][2]=a26;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_quaternion_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_quaternion_h_casadi_n_in(void) { return 12;}

CASADI_SYMBOL_EXPORT casadi_int vas_quaternion_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_quaternion_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_quaternion_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "lat_lon_height";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "q_b2m_wxyz";
    case 5: return "omega_ib_b";
    case 6: return "q_m2n_wxyz";
    case 7: return "lag";
    case 8: return "flexure";
    case 9: return "flexure_rate";
    case 10: return "gyro_scale";
    case 11: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_quaternion_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_quaternion_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s3;
    case 8: return casadi_s1;
    case 9: return casadi_s1;
    case 10: return casadi_s1;
    case 11: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_quaternion_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_quaternion_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



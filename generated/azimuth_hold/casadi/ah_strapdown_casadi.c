/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ah_strapdown_casadi__ ## ID
#endif

#include <math.h>
#include "../src/ah_math.h"
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
CASADI_SYMBOL_EXPORT void ah_strapdown_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ah_strapdown_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ah_strapdown_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* ah_strapdown_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],gyro_bias[3],accel_bias[3],dt,dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3])->(out_lon_lat_height[3],out_v_n[3],out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=1.;
  a03=6378137.;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][1] : 0;
  a06=arg[1]? arg[1][1] : 0;
  a07=arg[0]? arg[0][2] : 0;
  a08=6.3354393272928204e+06;
  a09=sin(a05);
  a10=(a09*a09);
  a11=(a04*a10);
  a11=(a02-a11);
  a12=sqrt(a11);
  a11=(a11*a12);
  a11=(a08/a11);
  a11=(a07+a11);
  a11=(a06/a11);
  a13=5.0000000000000000e-01;
  a14=(a13*a01);
  a15=(a11*a14);
  a15=(a05+a15);
  a16=sin(a15);
  a17=(a16*a16);
  a04=(a04*a17);
  a04=(a02-a04);
  a18=sqrt(a04);
  a19=(a02/a18);
  a20=(a03*a19);
  a21=arg[1]? arg[1][2] : 0;
  a22=(a14*a21);
  a22=(a07+a22);
  a20=(a20+a22);
  a20=(a02/a20);
  a23=(a01*a20);
  a24=arg[2]? arg[2][1] : 0;
  a25=(a24*a24);
  a26=arg[2]? arg[2][2] : 0;
  a27=(a26*a26);
  a28=(a25-a27);
  a29=arg[2]? arg[2][0] : 0;
  a30=(a29*a29);
  a31=arg[2]? arg[2][3] : 0;
  a32=(a31*a31);
  a33=(a30-a32);
  a28=(a28+a33);
  a34=arg[7]? arg[7][0] : 0;
  a35=arg[7]? arg[7][2] : 0;
  a36=arg[4]? arg[4][2] : 0;
  a36=(a36*a01);
  a37=(a35-a36);
  a38=arg[3]? arg[3][1] : 0;
  a38=(a38*a01);
  a39=arg[6]? arg[6][1] : 0;
  a40=(a38-a39);
  a41=(a37*a40);
  a42=(a13*a41);
  a42=(a34-a42);
  a43=arg[3]? arg[3][2] : 0;
  a43=(a43*a01);
  a44=arg[6]? arg[6][2] : 0;
  a45=(a43-a44);
  a46=arg[7]? arg[7][1] : 0;
  a47=arg[4]? arg[4][1] : 0;
  a47=(a47*a01);
  a48=(a46-a47);
  a49=(a45*a48);
  a50=(a13*a49);
  a42=(a42+a50);
  a50=1.6666666666666666e-01;
  a51=arg[3]? arg[3][0] : 0;
  a51=(a51*a01);
  a52=arg[6]? arg[6][0] : 0;
  a53=(a51-a52);
  a54=(a37*a53);
  a55=arg[4]? arg[4][0] : 0;
  a55=(a55*a01);
  a56=(a34-a55);
  a57=(a45*a56);
  a58=(a54-a57);
  a59=(a50*a58);
  a60=(a45*a59);
  a42=(a42+a60);
  a60=arg[8]? arg[8][1] : 0;
  a60=(a38-a60);
  a61=8.3333333333333329e-02;
  a37=(a61*a37);
  a62=(a60*a37);
  a42=(a42-a62);
  a62=(a40*a56);
  a63=(a48*a53);
  a64=(a62-a63);
  a65=(a50*a64);
  a66=(a40*a65);
  a42=(a42-a66);
  a66=arg[8]? arg[8][2] : 0;
  a66=(a43-a66);
  a48=(a61*a48);
  a67=(a66*a48);
  a42=(a42+a67);
  a67=arg[9]? arg[9][2] : 0;
  a68=(a36-a67);
  a69=(a61*a40);
  a70=(a68*a69);
  a42=(a42-a70);
  a42=(a42-a55);
  a70=arg[9]? arg[9][1] : 0;
  a71=(a47-a70);
  a72=(a61*a45);
  a73=(a71*a72);
  a42=(a42+a73);
  a73=(a28*a42);
  a74=2.;
  a75=(a74*a24);
  a76=(a75*a26);
  a77=(a74*a29);
  a78=(a77*a31);
  a79=(a76-a78);
  a57=(a13*a57);
  a57=(a46-a57);
  a54=(a13*a54);
  a57=(a57+a54);
  a49=(a49-a41);
  a50=(a50*a49);
  a45=(a45*a50);
  a57=(a57-a45);
  a45=arg[9]? arg[9][0] : 0;
  a55=(a55-a45);
  a41=(a72*a55);
  a57=(a57-a41);
  a41=arg[8]? arg[8][0] : 0;
  a41=(a51-a41);
  a37=(a37*a41);
  a57=(a57+a37);
  a65=(a53*a65);
  a57=(a57+a65);
  a56=(a61*a56);
  a65=(a66*a56);
  a57=(a57-a65);
  a57=(a57-a47);
  a47=(a61*a53);
  a68=(a68*a47);
  a57=(a57+a68);
  a68=(a79*a57);
  a73=(a73+a68);
  a68=(a77*a26);
  a75=(a75*a31);
  a65=(a68+a75);
  a63=(a13*a63);
  a63=(a35-a63);
  a62=(a13*a62);
  a63=(a63+a62);
  a71=(a71*a47);
  a63=(a63-a71);
  a56=(a60*a56);
  a63=(a63+a56);
  a40=(a40*a50);
  a63=(a63+a40);
  a48=(a48*a41);
  a63=(a63-a48);
  a53=(a53*a59);
  a63=(a63-a53);
  a63=(a63-a36);
  a55=(a69*a55);
  a63=(a63+a55);
  a55=(a65*a63);
  a73=(a73+a55);
  a55=(a13*a73);
  a36=arg[1]? arg[1][0] : 0;
  a53=(a55+a36);
  a59=1.4584230000000000e-04;
  a48=(a59*a16);
  a15=cos(a15);
  a40=(a02/a15);
  a50=(a16*a40);
  a56=(a59*a09);
  a12=(a02/a12);
  a03=(a03*a12);
  a03=(a07+a03);
  a03=(a36/a03);
  a71=cos(a05);
  a09=(a09/a71);
  a09=(a03*a09);
  a56=(a56+a09);
  a09=(a06*a56);
  a71=(a59*a71);
  a71=(a71+a03);
  a03=(a21*a71);
  a09=(a09-a03);
  a09=(a14*a09);
  a09=(a53+a09);
  a20=(a09*a20);
  a50=(a50*a20);
  a48=(a48+a50);
  a78=(a78+a76);
  a76=(a78*a42);
  a33=(a27+a33);
  a33=(a33-a25);
  a03=(a33*a57);
  a76=(a76+a03);
  a74=(a74*a26);
  a74=(a74*a31);
  a77=(a77*a24);
  a03=(a74-a77);
  a62=(a03*a63);
  a76=(a76+a62);
  a62=(a13*a76);
  a37=(a62+a06);
  a54=(a21*a11);
  a56=(a36*a56);
  a54=(a54+a56);
  a54=(a14*a54);
  a54=(a37-a54);
  a56=(a48*a54);
  a59=(a59*a15);
  a59=(a59+a20);
  a75=(a75-a68);
  a42=(a75*a42);
  a77=(a77+a74);
  a57=(a77*a57);
  a42=(a42+a57);
  a30=(a30-a27);
  a30=(a30+a32);
  a30=(a30-a25);
  a63=(a30*a63);
  a42=(a42+a63);
  a63=(a13*a42);
  a25=(a63+a21);
  a71=(a36*a71);
  a32=7.3745167729419953e-14;
  a27=(a07*a07);
  a27=(a32*a27);
  a27=(a02+a27);
  a57=1.5678559428873979e-07;
  a74=2.0136051943431768e+00;
  a68=1.3411242658989924e-02;
  a80=(a68*a10);
  a80=(a74-a80);
  a80=(a07*a80);
  a80=(a57*a80);
  a27=(a27-a80);
  a80=9.7803253359000006e+00;
  a81=1.8894147482439335e-02;
  a10=(a81*a10);
  a10=(a80+a10);
  a10=(a10*a12);
  a27=(a27*a10);
  a71=(a71-a27);
  a11=(a06*a11);
  a71=(a71+a11);
  a14=(a14*a71);
  a14=(a25+a14);
  a71=(a59*a14);
  a56=(a56-a71);
  a56=(a01*a56);
  a71=(a13*a56);
  a53=(a53+a71);
  a71=2.5000000000000000e-01;
  a11=7.2921149999999999e-05;
  a16=(a11*a16);
  a50=(a50+a16);
  a50=(a01*a50);
  a16=(a71*a50);
  a27=(a16*a76);
  a53=(a53+a27);
  a49=(a49-a45);
  a49=(a49+a34);
  a28=(a49*a28);
  a58=(a58-a70);
  a58=(a58+a46);
  a79=(a58*a79);
  a28=(a28+a79);
  a64=(a64-a67);
  a64=(a64+a35);
  a65=(a64*a65);
  a28=(a28+a65);
  a28=(a61*a28);
  a53=(a53-a28);
  a28=(a71*a42);
  a11=(a11*a15);
  a20=(a20+a11);
  a20=(a01*a20);
  a11=(a28*a20);
  a53=(a53-a11);
  a23=(a23*a53);
  a23=(a23*a40);
  a00=(a00+a23);
  if (res[0]!=0) res[0][0]=a00;
  a04=(a04*a18);
  a08=(a08/a04);
  a08=(a08+a22);
  a08=(a02/a08);
  a04=(a01*a08);
  a08=(a54*a08);
  a14=(a08*a14);
  a48=(a48*a09);
  a14=(a14+a48);
  a14=(a01*a14);
  a48=(a13*a14);
  a37=(a37-a48);
  a48=(a01*a08);
  a28=(a28*a48);
  a37=(a37-a28);
  a78=(a49*a78);
  a33=(a58*a33);
  a78=(a78+a33);
  a03=(a64*a03);
  a78=(a78+a03);
  a78=(a61*a78);
  a37=(a37-a78);
  a16=(a16*a73);
  a37=(a37-a16);
  a04=(a04*a37);
  a05=(a05+a04);
  if (res[0]!=0) res[0][1]=a05;
  a59=(a59*a09);
  a09=(a22*a22);
  a32=(a32*a09);
  a32=(a02+a32);
  a68=(a68*a17);
  a74=(a74-a68);
  a74=(a74*a22);
  a57=(a57*a74);
  a32=(a32-a57);
  a81=(a81*a17);
  a80=(a80+a81);
  a80=(a80*a19);
  a32=(a32*a80);
  a59=(a59-a32);
  a08=(a08*a54);
  a59=(a59+a08);
  a59=(a01*a59);
  a08=(a13*a59);
  a25=(a25+a08);
  a08=(a73*a20);
  a08=(a71*a08);
  a25=(a25+a08);
  a49=(a49*a75);
  a58=(a58*a77);
  a49=(a49+a58);
  a64=(a64*a30);
  a49=(a49+a64);
  a61=(a61*a49);
  a25=(a25-a61);
  a61=(a76*a48);
  a71=(a71*a61);
  a25=(a25+a71);
  a01=(a01*a25);
  a07=(a07+a01);
  if (res[0]!=0) res[0][2]=a07;
  a56=(a56+a36);
  a36=(a62*a50);
  a56=(a56+a36);
  a56=(a56+a73);
  a73=(a63*a20);
  a56=(a56-a73);
  if (res[1]!=0) res[1][0]=a56;
  a06=(a06-a14);
  a63=(a63*a48);
  a06=(a06-a63);
  a06=(a06+a76);
  a76=(a55*a50);
  a06=(a06-a76);
  if (res[1]!=0) res[1][1]=a06;
  a59=(a59+a21);
  a55=(a55*a20);
  a59=(a59+a55);
  a59=(a59+a42);
  a62=(a62*a48);
  a59=(a59+a62);
  if (res[1]!=0) res[1][2]=a59;
  a59=1.0000000000000001e-30;
  a62=(a72*a60);
  a52=(a52+a62);
  a62=(a66*a69);
  a52=(a52-a62);
  a52=(a52-a51);
  a51=(a52*a52);
  a51=(a59+a51);
  a72=(a72*a41);
  a39=(a39-a72);
  a66=(a66*a47);
  a39=(a39+a66);
  a39=(a39-a38);
  a38=(a39*a39);
  a51=(a51+a38);
  a60=(a60*a47);
  a44=(a44-a60);
  a69=(a69*a41);
  a44=(a44+a69);
  a44=(a44-a43);
  a43=(a44*a44);
  a51=(a51+a43);
  a51=sqrt(a51);
  a43=(a13*a51);
  a69=cos(a43);
  a41=(a29*a69);
  a43=sin(a43);
  a43=(a43/a51);
  a52=(a43*a52);
  a51=(a24*a52);
  a41=(a41-a51);
  a39=(a43*a39);
  a51=(a26*a39);
  a41=(a41-a51);
  a43=(a43*a44);
  a44=(a31*a43);
  a41=(a41-a44);
  a44=(a48*a48);
  a59=(a59+a44);
  a44=(a20*a20);
  a59=(a59+a44);
  a44=(a50*a50);
  a59=(a59+a44);
  a59=sqrt(a59);
  a13=(a13*a59);
  a44=cos(a13);
  a51=(a41*a44);
  a60=(a29*a52);
  a47=(a24*a69);
  a60=(a60+a47);
  a47=(a26*a43);
  a60=(a60+a47);
  a47=(a31*a39);
  a60=(a60-a47);
  a13=sin(a13);
  a13=(a13/a59);
  a48=(a13*a48);
  a59=(a60*a48);
  a51=(a51-a59);
  a59=(a29*a39);
  a47=(a26*a69);
  a59=(a59+a47);
  a47=(a31*a52);
  a59=(a59+a47);
  a47=(a24*a43);
  a59=(a59-a47);
  a20=(a13*a20);
  a47=(a59*a20);
  a51=(a51+a47);
  a29=(a29*a43);
  a24=(a24*a39);
  a29=(a29+a24);
  a31=(a31*a69);
  a29=(a29+a31);
  a26=(a26*a52);
  a29=(a29-a26);
  a13=(a13*a50);
  a50=(a29*a13);
  a51=(a51+a50);
  a50=(a51*a51);
  a26=(a60*a44);
  a52=(a29*a20);
  a26=(a26-a52);
  a52=(a41*a48);
  a26=(a26+a52);
  a52=(a59*a13);
  a26=(a26+a52);
  a52=(a26*a26);
  a50=(a50+a52);
  a52=(a59*a44);
  a31=(a60*a13);
  a52=(a52-a31);
  a31=(a41*a20);
  a52=(a52-a31);
  a31=(a29*a48);
  a52=(a52-a31);
  a31=(a52*a52);
  a50=(a50+a31);
  a59=(a59*a48);
  a29=(a29*a44);
  a59=(a59+a29);
  a41=(a41*a13);
  a59=(a59-a41);
  a60=(a60*a20);
  a59=(a59+a60);
  a60=(a59*a59);
  a50=(a50+a60);
  a50=sqrt(a50);
  a02=(a02/a50);
  a51=(a51*a02);
  if (res[2]!=0) res[2][0]=a51;
  a26=(a26*a02);
  if (res[2]!=0) res[2][1]=a26;
  a52=(a52*a02);
  if (res[2]!=0) res[2][2]=a52;
  a59=(a59*a02);
  if (res[2]!=0) res[2][3]=a59;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_strapdown_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ah_strapdown_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ah_strapdown_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ah_strapdown_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ah_strapdown_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ah_strapdown_casadi_n_in(void) { return 10;}

CASADI_SYMBOL_EXPORT casadi_int ah_strapdown_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real ah_strapdown_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_strapdown_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "gyro_bias";
    case 4: return "accel_bias";
    case 5: return "dt";
    case 6: return "dtheta_ib_b";
    case 7: return "dv_b";
    case 8: return "dtheta_before";
    case 9: return "dv_before";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_strapdown_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_lon_lat_height";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_strapdown_casadi_sparsity_in(casadi_int i) {
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
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_strapdown_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ah_strapdown_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_strapdown_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 10*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



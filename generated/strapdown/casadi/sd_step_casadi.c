/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) sd_step_casadi__ ## ID
#endif

#include <math.h>
#include "../src/sd_math.h"
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
CASADI_SYMBOL_EXPORT void sd_step_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int sd_step_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int sd_step_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* sd_step_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3],dt)->(out_lon_lat_height[3],out_v_n[3],out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[7]? arg[7][0] : 0;
  a02=1.;
  a03=arg[0]? arg[0][2] : 0;
  a04=5.0000000000000000e-01;
  a05=(a04*a01);
  a06=arg[1]? arg[1][2] : 0;
  a07=(a05*a06);
  a07=(a03+a07);
  a08=6378137.;
  a09=6.6943799901413173e-03;
  a10=arg[0]? arg[0][1] : 0;
  a11=arg[1]? arg[1][1] : 0;
  a12=6.3354393272928204e+06;
  a13=sin(a10);
  a14=(a13*a13);
  a15=(a09*a14);
  a15=(a02-a15);
  a16=sqrt(a15);
  a15=(a15*a16);
  a15=(a12/a15);
  a15=(a03+a15);
  a15=(a02/a15);
  a17=(a11*a15);
  a18=(a05*a17);
  a18=(a10+a18);
  a19=sin(a18);
  a20=(a19*a19);
  a09=(a09*a20);
  a09=(a02-a09);
  a21=sqrt(a09);
  a22=(a02/a21);
  a23=(a08*a22);
  a23=(a07+a23);
  a23=(a02/a23);
  a24=(a01*a23);
  a25=arg[1]? arg[1][0] : 0;
  a26=arg[4]? arg[4][1] : 0;
  a27=8.3333333333333329e-02;
  a28=arg[4]? arg[4][0] : 0;
  a29=(a27*a28);
  a30=arg[5]? arg[5][2] : 0;
  a31=(a29*a30);
  a31=(a26+a31);
  a32=arg[3]? arg[3][0] : 0;
  a33=(a27*a32);
  a34=arg[6]? arg[6][2] : 0;
  a35=(a33*a34);
  a31=(a31+a35);
  a35=1.6666666666666666e-01;
  a36=arg[3]? arg[3][1] : 0;
  a37=arg[4]? arg[4][2] : 0;
  a38=(a36*a37);
  a39=arg[3]? arg[3][2] : 0;
  a40=(a39*a26);
  a41=(a38-a40);
  a42=(a35*a41);
  a43=(a42*a39);
  a31=(a31+a43);
  a43=(a39*a28);
  a44=(a04*a43);
  a31=(a31+a44);
  a44=(a32*a37);
  a45=(a04*a44);
  a31=(a31-a45);
  a45=arg[5]? arg[5][0] : 0;
  a45=(a27*a45);
  a46=(a45*a37);
  a31=(a31-a46);
  a46=arg[6]? arg[6][0] : 0;
  a46=(a27*a46);
  a47=(a46*a39);
  a31=(a31-a47);
  a47=(a35*a32);
  a48=(a32*a26);
  a49=(a36*a28);
  a50=(a48-a49);
  a51=(a47*a50);
  a31=(a31-a51);
  a51=2.;
  a52=arg[2]? arg[2][1] : 0;
  a53=arg[2]? arg[2][2] : 0;
  a54=(a52*a53);
  a54=(a51*a54);
  a55=arg[2]? arg[2][0] : 0;
  a56=(a51*a55);
  a57=arg[2]? arg[2][3] : 0;
  a58=(a56*a57);
  a59=(a54-a58);
  a60=(a31*a59);
  a61=(a04*a60);
  a61=(a25+a61);
  a48=(a04*a48);
  a48=(a37+a48);
  a62=(a45*a26);
  a48=(a48+a62);
  a62=(a46*a36);
  a48=(a48+a62);
  a44=(a44-a43);
  a47=(a44*a47);
  a48=(a48-a47);
  a49=(a04*a49);
  a48=(a48-a49);
  a49=arg[5]? arg[5][1] : 0;
  a47=(a29*a49);
  a48=(a48-a47);
  a47=arg[6]? arg[6][1] : 0;
  a43=(a33*a47);
  a48=(a48-a43);
  a42=(a42*a36);
  a48=(a48-a42);
  a42=(a56*a53);
  a43=(a51*a52);
  a43=(a43*a57);
  a62=(a42+a43);
  a63=(a48*a62);
  a64=(a04*a63);
  a61=(a61+a64);
  a38=(a04*a38);
  a28=(a28+a38);
  a38=(a27*a49);
  a64=(a38*a37);
  a28=(a28+a64);
  a64=(a50*a36);
  a64=(a35*a64);
  a28=(a28+a64);
  a64=(a39*a47);
  a64=(a27*a64);
  a28=(a28+a64);
  a40=(a04*a40);
  a28=(a28-a40);
  a40=(a27*a30);
  a64=(a40*a26);
  a28=(a28-a64);
  a64=(a44*a39);
  a35=(a35*a64);
  a28=(a28+a35);
  a35=(a36*a34);
  a35=(a27*a35);
  a28=(a28-a35);
  a35=(a52*a52);
  a64=(a55*a55);
  a65=(a57*a57);
  a66=(a64-a65);
  a67=(a35+a66);
  a68=(a53*a53);
  a67=(a67-a68);
  a69=(a28*a67);
  a70=(a04*a69);
  a61=(a61+a70);
  a70=(a53*a57);
  a51=(a51*a70);
  a56=(a56*a52);
  a70=(a51-a56);
  a71=(a70*a48);
  a72=(a04*a71);
  a72=(a11+a72);
  a58=(a58+a54);
  a54=(a58*a28);
  a73=(a04*a54);
  a72=(a72+a73);
  a73=(a68-a35);
  a73=(a73+a66);
  a66=(a73*a31);
  a74=(a04*a66);
  a72=(a72+a74);
  a74=1.4584230000000000e-04;
  a75=(a74*a13);
  a16=(a02/a16);
  a08=(a08*a16);
  a08=(a03+a08);
  a08=(a25/a08);
  a76=cos(a10);
  a13=(a13/a76);
  a13=(a08*a13);
  a75=(a75+a13);
  a13=(a75*a25);
  a17=(a17*a06);
  a13=(a13+a17);
  a13=(a05*a13);
  a13=(a72-a13);
  a75=(a75*a11);
  a76=(a74*a76);
  a08=(a08+a76);
  a76=(a08*a06);
  a75=(a75-a76);
  a75=(a05*a75);
  a75=(a61+a75);
  a23=(a75*a23);
  a18=cos(a18);
  a76=(a02/a18);
  a17=(a19*a76);
  a17=(a23*a17);
  a77=(a74*a19);
  a77=(a17+a77);
  a78=(a13*a77);
  a43=(a43-a42);
  a28=(a28*a43);
  a42=(a04*a28);
  a42=(a06+a42);
  a56=(a56+a51);
  a31=(a31*a56);
  a51=(a04*a31);
  a42=(a42+a51);
  a64=(a64-a35);
  a64=(a64+a65);
  a64=(a64-a68);
  a48=(a48*a64);
  a68=(a04*a48);
  a42=(a42+a68);
  a68=(a11*a11);
  a68=(a68*a15);
  a08=(a08*a25);
  a68=(a68+a08);
  a08=9.7803253359000006e+00;
  a15=1.8894147482439335e-02;
  a65=(a15*a14);
  a65=(a08+a65);
  a65=(a65*a16);
  a16=7.3745167729419953e-14;
  a35=(a03*a03);
  a35=(a16*a35);
  a35=(a02+a35);
  a51=1.5678559428873979e-07;
  a79=2.0136051943431768e+00;
  a80=1.3411242658989924e-02;
  a14=(a80*a14);
  a14=(a79-a14);
  a14=(a03*a14);
  a14=(a51*a14);
  a35=(a35-a14);
  a65=(a65*a35);
  a68=(a68-a65);
  a68=(a05*a68);
  a68=(a42+a68);
  a74=(a74*a18);
  a74=(a23+a74);
  a65=(a68*a74);
  a78=(a78-a65);
  a78=(a01*a78);
  a65=(a04*a78);
  a61=(a61+a65);
  a71=(a71+a54);
  a71=(a71+a66);
  a66=2.5000000000000000e-01;
  a66=(a66*a01);
  a54=7.2921149999999999e-05;
  a19=(a54*a19);
  a17=(a17+a19);
  a19=(a66*a17);
  a65=(a71*a19);
  a61=(a61+a65);
  a26=(a27*a26);
  a44=(a27*a44);
  a26=(a26-a44);
  a47=(a27*a47);
  a26=(a26-a47);
  a59=(a59*a26);
  a61=(a61-a59);
  a50=(a27*a50);
  a37=(a27*a37);
  a50=(a50+a37);
  a34=(a27*a34);
  a50=(a50-a34);
  a62=(a62*a50);
  a61=(a61-a62);
  a27=(a27*a41);
  a27=(a27+a29);
  a27=(a27-a46);
  a67=(a67*a27);
  a61=(a61-a67);
  a54=(a54*a18);
  a23=(a23+a54);
  a28=(a28+a31);
  a28=(a28+a48);
  a48=(a23*a28);
  a31=(a66*a48);
  a61=(a61-a31);
  a24=(a24*a61);
  a24=(a24*a76);
  a00=(a00+a24);
  if (res[0]!=0) res[0][0]=a00;
  a09=(a09*a21);
  a12=(a12/a09);
  a12=(a07+a12);
  a09=(a02/a12);
  a21=(a01*a09);
  a68=(a68*a09);
  a68=(a68*a13);
  a77=(a75*a77);
  a68=(a68+a77);
  a68=(a01*a68);
  a77=(a04*a68);
  a72=(a72-a77);
  a77=(a13*a09);
  a00=(a66*a77);
  a24=(a28*a00);
  a72=(a72-a24);
  a70=(a70*a50);
  a72=(a72-a70);
  a58=(a58*a27);
  a72=(a72-a58);
  a73=(a73*a26);
  a72=(a72-a73);
  a60=(a60+a63);
  a60=(a60+a69);
  a19=(a19*a60);
  a72=(a72-a19);
  a21=(a21*a72);
  a10=(a10+a21);
  if (res[0]!=0) res[0][1]=a10;
  a75=(a75*a74);
  a74=(a13*a77);
  a75=(a75+a74);
  a15=(a15*a20);
  a08=(a08+a15);
  a08=(a08*a22);
  a22=(a07*a07);
  a16=(a16*a22);
  a16=(a02+a16);
  a80=(a80*a20);
  a79=(a79-a80);
  a07=(a07*a79);
  a51=(a51*a07);
  a16=(a16-a51);
  a08=(a08*a16);
  a75=(a75-a08);
  a75=(a01*a75);
  a08=(a04*a75);
  a42=(a42+a08);
  a08=(a23*a60);
  a66=(a66*a08);
  a42=(a42+a66);
  a43=(a43*a27);
  a42=(a42-a43);
  a56=(a56*a26);
  a42=(a42-a56);
  a64=(a64*a50);
  a42=(a42-a64);
  a00=(a71*a00);
  a42=(a42+a00);
  a42=(a01*a42);
  a03=(a03+a42);
  if (res[0]!=0) res[0][2]=a03;
  a78=(a78+a60);
  a78=(a78+a25);
  a25=(a05*a17);
  a03=(a71*a25);
  a78=(a78+a03);
  a48=(a05*a48);
  a78=(a78-a48);
  if (res[1]!=0) res[1][0]=a78;
  a68=(a71-a68);
  a68=(a68+a11);
  a11=(a05*a77);
  a78=(a28*a11);
  a68=(a68-a78);
  a60=(a60*a25);
  a68=(a68-a60);
  if (res[1]!=0) res[1][1]=a68;
  a28=(a28+a75);
  a28=(a28+a06);
  a05=(a05*a08);
  a28=(a28+a05);
  a71=(a71*a11);
  a28=(a28+a71);
  if (res[1]!=0) res[1][2]=a28;
  a28=1.0000000000000001e-30;
  a71=(a45*a36);
  a71=(a39+a71);
  a49=(a33*a49);
  a71=(a71-a49);
  a49=(a71*a71);
  a49=(a28+a49);
  a33=(a33*a30);
  a33=(a36+a33);
  a45=(a45*a39);
  a33=(a33-a45);
  a45=(a33*a33);
  a49=(a49+a45);
  a38=(a38*a39);
  a32=(a32+a38);
  a40=(a40*a36);
  a32=(a32-a40);
  a40=(a32*a32);
  a49=(a49+a40);
  a49=sqrt(a49);
  a40=(a04*a49);
  a36=cos(a40);
  a38=(a36*a55);
  a40=sin(a40);
  a40=(a40/a49);
  a32=(a32*a40);
  a49=(a32*a52);
  a38=(a38-a49);
  a33=(a33*a40);
  a49=(a33*a53);
  a38=(a38-a49);
  a71=(a71*a40);
  a40=(a71*a57);
  a38=(a38-a40);
  a40=(a01*a01);
  a49=(a23*a23);
  a49=(a40*a49);
  a28=(a28+a49);
  a49=(a17*a17);
  a49=(a40*a49);
  a28=(a28+a49);
  a49=(a13*a13);
  a40=(a40*a49);
  a12=(a12*a12);
  a40=(a40/a12);
  a28=(a28+a40);
  a28=sqrt(a28);
  a04=(a04*a28);
  a40=cos(a04);
  a12=(a38*a40);
  a49=(a36*a52);
  a39=(a32*a55);
  a49=(a49+a39);
  a39=(a71*a53);
  a49=(a49+a39);
  a39=(a33*a57);
  a49=(a49-a39);
  a04=sin(a04);
  a28=(a02/a28);
  a39=(a04*a28);
  a45=(a39*a01);
  a30=(a45*a77);
  a11=(a49*a30);
  a12=(a12-a11);
  a11=(a36*a53);
  a05=(a32*a57);
  a11=(a11+a05);
  a05=(a33*a55);
  a11=(a11+a05);
  a05=(a71*a52);
  a11=(a11-a05);
  a05=(a45*a11);
  a08=(a05*a23);
  a12=(a12+a08);
  a36=(a36*a57);
  a33=(a33*a52);
  a36=(a36+a33);
  a71=(a71*a55);
  a36=(a36+a71);
  a32=(a32*a53);
  a36=(a36-a32);
  a32=(a45*a36);
  a53=(a32*a17);
  a12=(a12+a53);
  a53=(a12*a12);
  a71=(a40*a36);
  a28=(a49*a28);
  a28=(a28*a04);
  a28=(a28*a23);
  a28=(a28*a01);
  a71=(a71+a28);
  a28=(a45*a17);
  a04=(a38*a28);
  a71=(a71-a04);
  a77=(a05*a77);
  a71=(a71+a77);
  a77=(a71*a71);
  a53=(a53+a77);
  a77=(a40*a49);
  a05=(a05*a17);
  a77=(a77+a05);
  a30=(a38*a30);
  a77=(a77+a30);
  a32=(a32*a23);
  a77=(a77-a32);
  a32=(a77*a77);
  a53=(a53+a32);
  a40=(a40*a11);
  a39=(a39*a36);
  a39=(a39*a09);
  a39=(a39*a13);
  a39=(a39*a01);
  a40=(a40-a39);
  a49=(a49*a28);
  a40=(a40-a49);
  a38=(a38*a45);
  a38=(a38*a23);
  a40=(a40-a38);
  a38=(a40*a40);
  a53=(a53+a38);
  a53=sqrt(a53);
  a02=(a02/a53);
  a12=(a12*a02);
  if (res[2]!=0) res[2][0]=a12;
  a77=(a77*a02);
  if (res[2]!=0) res[2][1]=a77;
  a40=(a40*a02);
  if (res[2]!=0) res[2][2]=a40;
  a71=(a71*a02);
  if (res[2]!=0) res[2][3]=a71;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_step_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sd_step_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sd_step_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sd_step_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void sd_step_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sd_step_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int sd_step_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real sd_step_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_step_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "dtheta_ib_b";
    case 4: return "dv_b";
    case 5: return "dtheta_before";
    case 6: return "dv_before";
    case 7: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_step_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_lon_lat_height";
    case 1: return "out_v_n";
    case 2: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_step_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_step_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sd_step_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_step_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



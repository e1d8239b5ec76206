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
  casadi_real a72, a73, a74, a75, a76, a77, a78;
  a00=arg[0]? arg[0][0] : 0;
  a01=arg[7]? arg[7][0] : 0;
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
  a34=arg[4]? arg[4][0] : 0;
  a35=arg[3]? arg[3][1] : 0;
  a36=arg[4]? arg[4][2] : 0;
  a37=(a35*a36);
  a38=(a13*a37);
  a38=(a34+a38);
  a39=8.3333333333333329e-02;
  a40=(a39*a36);
  a41=arg[5]? arg[5][1] : 0;
  a42=(a40*a41);
  a38=(a38+a42);
  a42=arg[3]? arg[3][2] : 0;
  a43=(a39*a42);
  a44=arg[6]? arg[6][1] : 0;
  a45=(a43*a44);
  a38=(a38+a45);
  a45=1.6666666666666666e-01;
  a46=arg[3]? arg[3][0] : 0;
  a47=arg[4]? arg[4][1] : 0;
  a48=(a46*a47);
  a49=(a35*a34);
  a50=(a48-a49);
  a51=(a45*a50);
  a52=(a51*a35);
  a38=(a38+a52);
  a52=(a42*a47);
  a53=(a13*a52);
  a38=(a38-a53);
  a53=arg[5]? arg[5][2] : 0;
  a53=(a39*a53);
  a54=(a53*a47);
  a38=(a38-a54);
  a54=arg[6]? arg[6][2] : 0;
  a55=(a39*a54);
  a56=(a55*a35);
  a38=(a38-a56);
  a56=(a46*a36);
  a57=(a42*a34);
  a58=(a56-a57);
  a59=(a45*a42);
  a60=(a58*a59);
  a38=(a38+a60);
  a60=(a28*a38);
  a61=2.;
  a62=(a61*a24);
  a63=(a62*a26);
  a64=(a61*a29);
  a65=(a64*a31);
  a66=(a63-a65);
  a67=(a53*a34);
  a67=(a47+a67);
  a55=(a55*a46);
  a67=(a67+a55);
  a37=(a37-a52);
  a59=(a59*a37);
  a67=(a67+a59);
  a57=(a13*a57);
  a67=(a67+a57);
  a56=(a13*a56);
  a67=(a67-a56);
  a56=arg[5]? arg[5][0] : 0;
  a40=(a40*a56);
  a67=(a67-a40);
  a40=arg[6]? arg[6][0] : 0;
  a57=(a43*a40);
  a67=(a67-a57);
  a51=(a51*a46);
  a67=(a67-a51);
  a51=(a66*a67);
  a60=(a60+a51);
  a51=(a64*a26);
  a62=(a62*a31);
  a57=(a51+a62);
  a48=(a13*a48);
  a48=(a36+a48);
  a59=(a39*a56);
  a52=(a59*a47);
  a48=(a48+a52);
  a52=(a58*a46);
  a52=(a45*a52);
  a48=(a48-a52);
  a52=(a35*a40);
  a52=(a39*a52);
  a48=(a48+a52);
  a49=(a13*a49);
  a48=(a48-a49);
  a49=(a39*a41);
  a52=(a49*a34);
  a48=(a48-a52);
  a52=(a37*a35);
  a45=(a45*a52);
  a48=(a48-a45);
  a45=(a46*a44);
  a45=(a39*a45);
  a48=(a48-a45);
  a45=(a57*a48);
  a60=(a60+a45);
  a45=(a13*a60);
  a52=arg[1]? arg[1][0] : 0;
  a55=(a45+a52);
  a68=1.4584230000000000e-04;
  a69=(a68*a16);
  a15=cos(a15);
  a70=(a02/a15);
  a71=(a16*a70);
  a72=(a68*a09);
  a12=(a02/a12);
  a03=(a03*a12);
  a03=(a07+a03);
  a03=(a52/a03);
  a73=cos(a05);
  a09=(a09/a73);
  a09=(a03*a09);
  a72=(a72+a09);
  a09=(a06*a72);
  a73=(a68*a73);
  a73=(a73+a03);
  a03=(a21*a73);
  a09=(a09-a03);
  a09=(a14*a09);
  a09=(a55+a09);
  a20=(a09*a20);
  a71=(a71*a20);
  a69=(a69+a71);
  a65=(a65+a63);
  a63=(a65*a38);
  a33=(a27+a33);
  a33=(a33-a25);
  a03=(a33*a67);
  a63=(a63+a03);
  a61=(a61*a26);
  a61=(a61*a31);
  a64=(a64*a24);
  a03=(a61-a64);
  a74=(a03*a48);
  a63=(a63+a74);
  a74=(a13*a63);
  a75=(a74+a06);
  a76=(a21*a11);
  a72=(a52*a72);
  a76=(a76+a72);
  a76=(a14*a76);
  a76=(a75-a76);
  a72=(a69*a76);
  a68=(a68*a15);
  a68=(a68+a20);
  a62=(a62-a51);
  a38=(a62*a38);
  a64=(a64+a61);
  a67=(a64*a67);
  a38=(a38+a67);
  a30=(a30-a27);
  a30=(a30+a32);
  a30=(a30-a25);
  a48=(a30*a48);
  a38=(a38+a48);
  a48=(a13*a38);
  a25=(a48+a21);
  a73=(a52*a73);
  a32=7.3745167729419953e-14;
  a27=(a07*a07);
  a27=(a32*a27);
  a27=(a02+a27);
  a67=1.5678559428873979e-07;
  a61=2.0136051943431768e+00;
  a51=1.3411242658989924e-02;
  a77=(a51*a10);
  a77=(a61-a77);
  a77=(a07*a77);
  a77=(a67*a77);
  a27=(a27-a77);
  a77=9.7803253359000006e+00;
  a78=1.8894147482439335e-02;
  a10=(a78*a10);
  a10=(a77+a10);
  a10=(a10*a12);
  a27=(a27*a10);
  a73=(a73-a27);
  a11=(a06*a11);
  a73=(a73+a11);
  a14=(a14*a73);
  a14=(a25+a14);
  a73=(a68*a14);
  a72=(a72-a73);
  a72=(a01*a72);
  a73=(a13*a72);
  a55=(a55+a73);
  a73=2.5000000000000000e-01;
  a11=7.2921149999999999e-05;
  a16=(a11*a16);
  a71=(a71+a16);
  a71=(a01*a71);
  a16=(a73*a71);
  a27=(a16*a63);
  a55=(a55+a27);
  a37=(a37+a34);
  a37=(a37-a40);
  a28=(a37*a28);
  a47=(a47-a58);
  a47=(a47-a44);
  a66=(a47*a66);
  a28=(a28+a66);
  a50=(a50+a36);
  a50=(a50-a54);
  a57=(a50*a57);
  a28=(a28+a57);
  a28=(a39*a28);
  a55=(a55-a28);
  a28=(a73*a38);
  a11=(a11*a15);
  a20=(a20+a11);
  a20=(a01*a20);
  a11=(a28*a20);
  a55=(a55-a11);
  a23=(a23*a55);
  a23=(a23*a70);
  a00=(a00+a23);
  if (res[0]!=0) res[0][0]=a00;
  a04=(a04*a18);
  a08=(a08/a04);
  a08=(a08+a22);
  a08=(a02/a08);
  a04=(a01*a08);
  a08=(a76*a08);
  a14=(a08*a14);
  a69=(a69*a09);
  a14=(a14+a69);
  a14=(a01*a14);
  a69=(a13*a14);
  a75=(a75-a69);
  a69=(a01*a08);
  a28=(a28*a69);
  a75=(a75-a28);
  a65=(a37*a65);
  a33=(a47*a33);
  a65=(a65+a33);
  a03=(a50*a03);
  a65=(a65+a03);
  a65=(a39*a65);
  a75=(a75-a65);
  a16=(a16*a60);
  a75=(a75-a16);
  a04=(a04*a75);
  a05=(a05+a04);
  if (res[0]!=0) res[0][1]=a05;
  a68=(a68*a09);
  a09=(a22*a22);
  a32=(a32*a09);
  a32=(a02+a32);
  a51=(a51*a17);
  a61=(a61-a51);
  a61=(a61*a22);
  a67=(a67*a61);
  a32=(a32-a67);
  a78=(a78*a17);
  a77=(a77+a78);
  a77=(a77*a19);
  a32=(a32*a77);
  a68=(a68-a32);
  a08=(a08*a76);
  a68=(a68+a08);
  a68=(a01*a68);
  a08=(a13*a68);
  a25=(a25+a08);
  a08=(a60*a20);
  a08=(a73*a08);
  a25=(a25+a08);
  a37=(a37*a62);
  a47=(a47*a64);
  a37=(a37+a47);
  a50=(a50*a30);
  a37=(a37+a50);
  a39=(a39*a37);
  a25=(a25-a39);
  a39=(a63*a69);
  a73=(a73*a39);
  a25=(a25+a73);
  a01=(a01*a25);
  a07=(a07+a01);
  if (res[0]!=0) res[0][2]=a07;
  a72=(a72+a52);
  a52=(a74*a71);
  a72=(a72+a52);
  a72=(a72+a60);
  a60=(a48*a20);
  a72=(a72-a60);
  if (res[1]!=0) res[1][0]=a72;
  a06=(a06-a14);
  a48=(a48*a69);
  a06=(a06-a48);
  a06=(a06+a63);
  a63=(a45*a71);
  a06=(a06-a63);
  if (res[1]!=0) res[1][1]=a06;
  a68=(a68+a21);
  a45=(a45*a20);
  a68=(a68+a45);
  a68=(a68+a38);
  a74=(a74*a69);
  a68=(a68+a74);
  if (res[1]!=0) res[1][2]=a68;
  a68=1.0000000000000001e-30;
  a41=(a43*a41);
  a41=(a46+a41);
  a74=(a53*a35);
  a41=(a41-a74);
  a74=(a41*a41);
  a74=(a68+a74);
  a53=(a53*a46);
  a53=(a35+a53);
  a43=(a43*a56);
  a53=(a53-a43);
  a43=(a53*a53);
  a74=(a74+a43);
  a59=(a59*a35);
  a42=(a42+a59);
  a49=(a49*a46);
  a42=(a42-a49);
  a49=(a42*a42);
  a74=(a74+a49);
  a74=sqrt(a74);
  a49=(a13*a74);
  a46=cos(a49);
  a59=(a29*a46);
  a49=sin(a49);
  a49=(a49/a74);
  a41=(a49*a41);
  a74=(a24*a41);
  a59=(a59-a74);
  a53=(a49*a53);
  a74=(a26*a53);
  a59=(a59-a74);
  a49=(a49*a42);
  a42=(a31*a49);
  a59=(a59-a42);
  a42=(a69*a69);
  a68=(a68+a42);
  a42=(a20*a20);
  a68=(a68+a42);
  a42=(a71*a71);
  a68=(a68+a42);
  a68=sqrt(a68);
  a13=(a13*a68);
  a42=cos(a13);
  a74=(a59*a42);
  a35=(a29*a41);
  a43=(a24*a46);
  a35=(a35+a43);
  a43=(a26*a49);
  a35=(a35+a43);
  a43=(a31*a53);
  a35=(a35-a43);
  a13=sin(a13);
  a13=(a13/a68);
  a69=(a13*a69);
  a68=(a35*a69);
  a74=(a74-a68);
  a68=(a29*a53);
  a43=(a26*a46);
  a68=(a68+a43);
  a43=(a31*a41);
  a68=(a68+a43);
  a43=(a24*a49);
  a68=(a68-a43);
  a20=(a13*a20);
  a43=(a68*a20);
  a74=(a74+a43);
  a29=(a29*a49);
  a24=(a24*a53);
  a29=(a29+a24);
  a31=(a31*a46);
  a29=(a29+a31);
  a26=(a26*a41);
  a29=(a29-a26);
  a13=(a13*a71);
  a71=(a29*a13);
  a74=(a74+a71);
  a71=(a74*a74);
  a26=(a35*a42);
  a41=(a29*a20);
  a26=(a26-a41);
  a41=(a59*a69);
  a26=(a26+a41);
  a41=(a68*a13);
  a26=(a26+a41);
  a41=(a26*a26);
  a71=(a71+a41);
  a41=(a68*a42);
  a31=(a35*a13);
  a41=(a41-a31);
  a31=(a59*a20);
  a41=(a41-a31);
  a31=(a29*a69);
  a41=(a41-a31);
  a31=(a41*a41);
  a71=(a71+a31);
  a68=(a68*a69);
  a29=(a29*a42);
  a68=(a68+a29);
  a59=(a59*a13);
  a68=(a68-a59);
  a35=(a35*a20);
  a68=(a68+a35);
  a35=(a68*a68);
  a71=(a71+a35);
  a71=sqrt(a71);
  a02=(a02/a71);
  a74=(a74*a02);
  if (res[2]!=0) res[2][0]=a74;
  a26=(a26*a02);
  if (res[2]!=0) res[2][1]=a26;
  a41=(a41*a02);
  if (res[2]!=0) res[2][2]=a41;
  a68=(a68*a02);
  if (res[2]!=0) res[2][3]=a68;
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



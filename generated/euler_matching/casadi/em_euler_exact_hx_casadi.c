/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_euler_exact_h_casadi__ ## ID
#endif

#include <math.h>

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
CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {6, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* em_euler_exact_h_casadi:(x[6],mu[3],euler_b[3])->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61;
  a00=arg[2]? arg[2][0] : 0;
  a01=cos(a00);
  a02=arg[2]? arg[2][1] : 0;
  a03=cos(a02);
  a04=(a01*a03);
  a05=2.;
  a06=5.0000000000000000e-01;
  a07=1.0000000000000001e-30;
  a08=arg[1]? arg[1][0] : 0;
  a09=(a08*a08);
  a10=(a07+a09);
  a11=arg[1]? arg[1][1] : 0;
  a12=(a11*a11);
  a10=(a10+a12);
  a13=arg[1]? arg[1][2] : 0;
  a14=(a13*a13);
  a10=(a10+a14);
  a15=sqrt(a10);
  a16=(a06*a15);
  a17=sin(a16);
  a18=(a17*a17);
  a18=(a18/a10);
  a10=(a18*a11);
  a19=(a10*a13);
  a19=(a05*a19);
  a20=(a05*a08);
  a16=cos(a16);
  a17=(a16*a17);
  a17=(a17/a15);
  a15=(a20*a17);
  a19=(a19-a15);
  a19=(a04*a19);
  a00=sin(a00);
  a21=(a03*a00);
  a14=(a18*a14);
  a12=(a18*a12);
  a22=(a14-a12);
  a09=(a18*a09);
  a16=(a16*a16);
  a23=(a09-a16);
  a22=(a22+a23);
  a22=(a21*a22);
  a19=(a19-a22);
  a02=sin(a02);
  a22=(a20*a10);
  a24=(a05*a13);
  a25=(a24*a17);
  a26=(a22+a25);
  a26=(a02*a26);
  a19=(a19-a26);
  a10=(a10*a24);
  a15=(a15+a10);
  a15=(a21*a15);
  a23=(a12+a23);
  a23=(a23-a14);
  a23=(a04*a23);
  a15=(a15-a23);
  a20=(a20*a18);
  a20=(a20*a13);
  a17=(a17*a11);
  a17=(a05*a17);
  a18=(a20-a17);
  a18=(a02*a18);
  a15=(a15-a18);
  a19=atan2(a19,a15);
  a15=arg[0]? arg[0][1] : 0;
  a18=(a05*a15);
  a23=arg[0]? arg[0][2] : 0;
  a10=(a23*a23);
  a24=(a07+a10);
  a26=(a15*a15);
  a24=(a24+a26);
  a27=arg[0]? arg[0][0] : 0;
  a28=(a27*a27);
  a24=(a24+a28);
  a29=sqrt(a24);
  a30=(a06*a29);
  a31=sin(a30);
  a32=(a31*a31);
  a32=(a32/a24);
  a24=(a32*a23);
  a33=(a18*a24);
  a30=cos(a30);
  a31=(a31*a30);
  a31=(a31/a29);
  a29=(a05*a27);
  a34=(a31*a29);
  a35=(a33+a34);
  a36=arg[2]? arg[2][2] : 0;
  a37=sin(a36);
  a38=(a03*a37);
  a39=(a35*a38);
  a24=(a24*a29);
  a29=(a18*a31);
  a40=(a24-a29);
  a36=cos(a36);
  a41=(a03*a36);
  a42=(a40*a41);
  a39=(a39+a42);
  a30=(a30*a30);
  a28=(a28*a32);
  a42=(a30-a28);
  a10=(a10*a32);
  a26=(a26*a32);
  a43=(a10-a26);
  a42=(a42+a43);
  a44=(a02*a42);
  a39=(a39-a44);
  a44=arg[0]? arg[0][4] : 0;
  a44=(a44-a11);
  a11=arg[0]? arg[0][3] : 0;
  a11=(a11-a08);
  a08=(a11*a11);
  a07=(a07+a08);
  a45=(a44*a44);
  a07=(a07+a45);
  a46=arg[0]? arg[0][5] : 0;
  a46=(a46-a13);
  a13=(a46*a46);
  a07=(a07+a13);
  a47=sqrt(a07);
  a06=(a06*a47);
  a48=sin(a06);
  a49=(a48*a48);
  a50=1.;
  a50=(a50/a07);
  a07=(a49*a50);
  a51=(a44*a07);
  a52=(a05*a11);
  a53=(a51*a52);
  a54=(a05*a46);
  a06=cos(a06);
  a48=(a48*a06);
  a48=(a48/a47);
  a47=(a54*a48);
  a55=(a53-a47);
  a55=(a39*a55);
  a56=(a01*a36);
  a57=(a00*a37);
  a58=(a02*a57);
  a58=(a56+a58);
  a59=(a58*a35);
  a36=(a00*a36);
  a60=(a02*a36);
  a61=(a01*a37);
  a60=(a60-a61);
  a61=(a60*a40);
  a59=(a59+a61);
  a03=(a03*a42);
  a00=(a00*a03);
  a59=(a59+a00);
  a13=(a13*a07);
  a45=(a45*a07);
  a00=(a13-a45);
  a08=(a08*a07);
  a06=(a06*a06);
  a42=(a08-a06);
  a00=(a00+a42);
  a00=(a59*a00);
  a55=(a55-a00);
  a03=(a01*a03);
  a01=(a02*a01);
  a01=(a01*a37);
  a01=(a01-a36);
  a35=(a35*a01);
  a03=(a03+a35);
  a56=(a02*a56);
  a57=(a57+a56);
  a40=(a40*a57);
  a03=(a03+a40);
  a52=(a52*a48);
  a51=(a51*a54);
  a51=(a52+a51);
  a51=(a03*a51);
  a55=(a55+a51);
  a46=(a44*a46);
  a46=(a46*a50);
  a46=(a46*a49);
  a46=(a05*a46);
  a46=(a46-a52);
  a46=(a59*a46);
  a11=(a11*a07);
  a11=(a11*a54);
  a44=(a44*a48);
  a44=(a05*a44);
  a48=(a11+a44);
  a48=(a39*a48);
  a46=(a46+a48);
  a48=(a45-a13);
  a48=(a48+a42);
  a48=(a03*a48);
  a46=(a46-a48);
  a55=atan2(a55,a46);
  a19=(a19-a55);
  a55=sin(a19);
  a19=cos(a19);
  a55=atan2(a55,a19);
  if (res[0]!=0) res[0][0]=a55;
  a53=(a53+a47);
  a59=(a59*a53);
  a11=(a11-a44);
  a03=(a11*a03);
  a59=(a59+a03);
  a13=(a13+a45);
  a06=(a06-a13);
  a06=(a06+a08);
  a39=(a06*a39);
  a59=(a59+a39);
  a59=(-a59);
  a15=(a32*a15);
  a15=(a15*a27);
  a15=(a05*a15);
  a31=(a31*a23);
  a05=(a05*a31);
  a15=(a15-a05);
  a31=(a58*a15);
  a23=(a30+a28);
  a10=(a10-a23);
  a10=(a10+a26);
  a26=(a60*a10);
  a31=(a31-a26);
  a24=(a24+a29);
  a29=(a24*a21);
  a31=(a31+a29);
  a31=(a53*a31);
  a29=(a24*a04);
  a26=(a15*a01);
  a29=(a29+a26);
  a26=(a10*a57);
  a29=(a29-a26);
  a29=(a11*a29);
  a31=(a31+a29);
  a15=(a15*a38);
  a10=(a10*a41);
  a15=(a15-a10);
  a24=(a02*a24);
  a15=(a15-a24);
  a15=(a06*a15);
  a31=(a31+a15);
  a15=(a31*a31);
  a18=(a18*a32);
  a18=(a18*a27);
  a05=(a05+a18);
  a18=(a60*a05);
  a28=(a28-a30);
  a28=(a28+a43);
  a43=(a58*a28);
  a18=(a18-a43);
  a33=(a33-a34);
  a34=(a33*a21);
  a18=(a18+a34);
  a53=(a53*a18);
  a18=(a33*a04);
  a34=(a05*a57);
  a18=(a18+a34);
  a34=(a28*a01);
  a18=(a18-a34);
  a11=(a11*a18);
  a53=(a53+a11);
  a05=(a05*a41);
  a28=(a28*a38);
  a05=(a05-a28);
  a33=(a02*a33);
  a05=(a05-a33);
  a06=(a06*a05);
  a53=(a53+a06);
  a06=(a53*a53);
  a15=(a15+a06);
  a15=sqrt(a15);
  a59=atan2(a59,a15);
  a16=(a16-a12);
  a16=(a16+a09);
  a16=(a16-a14);
  a02=(a02*a16);
  a22=(a22-a25);
  a21=(a22*a21);
  a02=(a02-a21);
  a20=(a20+a17);
  a04=(a20*a04);
  a02=(a02-a04);
  a60=(a60*a22);
  a57=(a20*a57);
  a60=(a60+a57);
  a41=(a16*a41);
  a60=(a60+a41);
  a41=(a60*a60);
  a58=(a58*a22);
  a20=(a20*a01);
  a58=(a58+a20);
  a16=(a16*a38);
  a58=(a58+a16);
  a16=(a58*a58);
  a41=(a41+a16);
  a41=sqrt(a41);
  a02=atan2(a02,a41);
  a59=(a59-a02);
  a02=sin(a59);
  a02=(-a02);
  a59=cos(a59);
  a02=atan2(a02,a59);
  if (res[0]!=0) res[0][1]=a02;
  a58=atan2(a58,a60);
  a53=atan2(a53,a31);
  a58=(a58-a53);
  a53=sin(a58);
  a58=cos(a58);
  a53=atan2(a53,a58);
  if (res[0]!=0) res[0][2]=a53;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_h_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_euler_exact_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "mu";
    case 2: return "euler_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_euler_exact_h_casadi__ ## ID
#endif

#include <math.h>
#include "../src/em_math.h"
#define atan2 BS_ATAN2
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
#define casadi_sq CASADI_PREFIX(sq)

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

static casadi_real casadi_sq(casadi_real x) { return x*x;}

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
  casadi_real a48, a49, a50, a51, a52;
  a00=5.0000000000000000e-01;
  a01=1.0000000000000001e-30;
  a02=arg[1]? arg[1][0] : 0;
  a03=casadi_sq(a02);
  a03=(a01+a03);
  a04=arg[1]? arg[1][1] : 0;
  a05=casadi_sq(a04);
  a03=(a03+a05);
  a05=arg[1]? arg[1][2] : 0;
  a06=casadi_sq(a05);
  a03=(a03+a06);
  a03=sqrt(a03);
  a06=(a00*a03);
  a07=sin(a06);
  a07=(a07/a03);
  a03=(a07*a04);
  a08=casadi_sq(a03);
  a09=(a07*a05);
  a10=casadi_sq(a09);
  a11=(a08-a10);
  a06=cos(a06);
  a12=casadi_sq(a06);
  a07=(a07*a02);
  a13=casadi_sq(a07);
  a14=(a12-a13);
  a11=(a11+a14);
  a15=arg[2]? arg[2][1] : 0;
  a16=cos(a15);
  a17=arg[2]? arg[2][0] : 0;
  a18=sin(a17);
  a19=(a16*a18);
  a11=(a11*a19);
  a06=(2.*a06);
  a20=(a06*a09);
  a21=(-a07);
  a21=(2.*a21);
  a22=(a21*a03);
  a23=(a20-a22);
  a15=sin(a15);
  a23=(a23*a15);
  a11=(a11-a23);
  a07=(a06*a07);
  a23=(-a03);
  a23=(2.*a23);
  a23=(a23*a09);
  a24=(a07+a23);
  a17=cos(a17);
  a25=(a16*a17);
  a24=(a24*a25);
  a11=(a11-a24);
  a06=(a06*a03);
  a21=(a21*a09);
  a09=(a06+a21);
  a09=(a09*a15);
  a07=(a07-a23);
  a07=(a07*a19);
  a09=(a09+a07);
  a14=(a10+a14);
  a14=(a14-a08);
  a14=(a14*a25);
  a09=(a09+a14);
  a11=atan2(a11,a09);
  a09=arg[0]? arg[0][3] : 0;
  a09=(a09-a02);
  a02=casadi_sq(a09);
  a02=(a01+a02);
  a14=arg[0]? arg[0][4] : 0;
  a14=(a14-a04);
  a04=casadi_sq(a14);
  a02=(a02+a04);
  a04=arg[0]? arg[0][5] : 0;
  a04=(a04-a05);
  a05=casadi_sq(a04);
  a02=(a02+a05);
  a02=sqrt(a02);
  a05=(a00*a02);
  a07=sin(a05);
  a07=(a07/a02);
  a09=(a09*a07);
  a02=(2.*a09);
  a14=(a14*a07);
  a23=(a02*a14);
  a05=cos(a05);
  a03=(2.*a05);
  a04=(a04*a07);
  a07=(a03*a04);
  a24=(a23-a07);
  a26=arg[0]? arg[0][2] : 0;
  a27=casadi_sq(a26);
  a01=(a01+a27);
  a27=arg[0]? arg[0][1] : 0;
  a28=casadi_sq(a27);
  a01=(a01+a28);
  a28=arg[0]? arg[0][0] : 0;
  a29=casadi_sq(a28);
  a01=(a01+a29);
  a01=sqrt(a01);
  a00=(a00*a01);
  a29=sin(a00);
  a29=(a29/a01);
  a28=(a29*a28);
  a01=(2.*a28);
  a26=(a29*a26);
  a30=(a01*a26);
  a00=cos(a00);
  a31=(2.*a00);
  a29=(a29*a27);
  a27=(a31*a29);
  a32=(a30-a27);
  a33=arg[2]? arg[2][2] : 0;
  a34=cos(a33);
  a35=(a16*a34);
  a36=(a32*a35);
  a37=(a31*a28);
  a38=(2.*a26);
  a38=(a38*a29);
  a39=(a37+a38);
  a33=sin(a33);
  a16=(a16*a33);
  a40=(a39*a16);
  a36=(a36+a40);
  a40=casadi_sq(a26);
  a28=casadi_sq(a28);
  a41=(a40-a28);
  a00=casadi_sq(a00);
  a42=casadi_sq(a29);
  a43=(a00-a42);
  a41=(a41+a43);
  a44=(a41*a15);
  a36=(a36-a44);
  a24=(a24*a36);
  a44=casadi_sq(a14);
  a45=casadi_sq(a04);
  a46=(a44-a45);
  a05=casadi_sq(a05);
  a47=casadi_sq(a09);
  a48=(a05-a47);
  a46=(a46+a48);
  a49=(a34*a18);
  a50=(a15*a49);
  a51=(a33*a17);
  a50=(a50-a51);
  a52=(a32*a50);
  a34=(a34*a17);
  a33=(a33*a18);
  a18=(a15*a33);
  a18=(a34+a18);
  a17=(a39*a18);
  a52=(a52+a17);
  a17=(a41*a19);
  a52=(a52+a17);
  a46=(a46*a52);
  a24=(a24+a46);
  a09=(a03*a09);
  a46=(2.*a14);
  a46=(a46*a04);
  a17=(a09+a46);
  a34=(a15*a34);
  a33=(a33+a34);
  a32=(a32*a33);
  a51=(a15*a51);
  a51=(a51-a49);
  a39=(a39*a51);
  a32=(a32+a39);
  a41=(a41*a25);
  a32=(a32+a41);
  a17=(a17*a32);
  a24=(a24+a17);
  a03=(a03*a14);
  a02=(a02*a04);
  a04=(a03+a02);
  a04=(a04*a36);
  a46=(a46-a09);
  a46=(a46*a52);
  a04=(a04+a46);
  a48=(a45+a48);
  a48=(a48-a44);
  a48=(a48*a32);
  a04=(a04+a48);
  a24=atan2(a24,a04);
  a11=(a11-a24);
  a24=sin(a11);
  a11=cos(a11);
  a24=atan2(a24,a11);
  if (res[0]!=0) res[0][0]=a24;
  a12=(a12-a10);
  a12=(a12+a13);
  a12=(a12-a08);
  a08=(a12*a15);
  a20=(a20+a22);
  a22=(a20*a19);
  a08=(a08+a22);
  a06=(a06-a21);
  a21=(a06*a25);
  a08=(a08-a21);
  a21=(a12*a35);
  a22=(a20*a50);
  a21=(a21-a22);
  a22=(a06*a33);
  a21=(a21+a22);
  a22=casadi_sq(a21);
  a12=(a12*a16);
  a20=(a20*a18);
  a12=(a12-a20);
  a06=(a06*a51);
  a12=(a12+a06);
  a06=casadi_sq(a12);
  a22=(a22+a06);
  a22=sqrt(a22);
  a08=atan2(a08,a22);
  a05=(a05-a45);
  a05=(a05+a47);
  a05=(a05-a44);
  a36=(a05*a36);
  a07=(a07+a23);
  a52=(a07*a52);
  a36=(a36+a52);
  a02=(a02-a03);
  a32=(a02*a32);
  a36=(a36+a32);
  a36=(-a36);
  a43=(a28+a43);
  a43=(a43-a40);
  a32=(a43*a35);
  a01=(a01*a29);
  a31=(a31*a26);
  a26=(a01-a31);
  a29=(a26*a16);
  a32=(a32+a29);
  a27=(a27+a30);
  a30=(a27*a15);
  a32=(a32-a30);
  a32=(a05*a32);
  a30=(a43*a50);
  a29=(a26*a18);
  a30=(a30+a29);
  a29=(a27*a19);
  a30=(a30+a29);
  a30=(a07*a30);
  a32=(a32+a30);
  a43=(a43*a33);
  a26=(a26*a51);
  a43=(a43+a26);
  a27=(a27*a25);
  a43=(a43+a27);
  a43=(a02*a43);
  a32=(a32+a43);
  a43=casadi_sq(a32);
  a31=(a31+a01);
  a35=(a31*a35);
  a00=(a00-a28);
  a00=(a00+a42);
  a00=(a00-a40);
  a16=(a00*a16);
  a35=(a35+a16);
  a38=(a38-a37);
  a15=(a38*a15);
  a35=(a35-a15);
  a05=(a05*a35);
  a50=(a31*a50);
  a18=(a00*a18);
  a50=(a50+a18);
  a19=(a38*a19);
  a50=(a50+a19);
  a07=(a07*a50);
  a05=(a05+a07);
  a31=(a31*a33);
  a00=(a00*a51);
  a31=(a31+a00);
  a38=(a38*a25);
  a31=(a31+a38);
  a02=(a02*a31);
  a05=(a05+a02);
  a02=casadi_sq(a05);
  a43=(a43+a02);
  a43=sqrt(a43);
  a36=atan2(a36,a43);
  a08=(a08-a36);
  a36=sin(a08);
  a08=cos(a08);
  a36=atan2(a36,a08);
  if (res[0]!=0) res[0][1]=a36;
  a12=atan2(a12,a21);
  a05=atan2(a05,a32);
  a12=(a12-a05);
  a05=sin(a12);
  a12=cos(a12);
  a05=atan2(a05,a12);
  if (res[0]!=0) res[0][2]=a05;
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



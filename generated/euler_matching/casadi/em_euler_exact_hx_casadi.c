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
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57;
  a00=arg[2]? arg[2][0] : 0;
  a01=cos(a00);
  a02=arg[2]? arg[2][1] : 0;
  a03=cos(a02);
  a04=(a01*a03);
  a05=5.0000000000000000e-01;
  a06=1.0000000000000001e-30;
  a07=arg[1]? arg[1][0] : 0;
  a08=casadi_sq(a07);
  a09=(a06+a08);
  a10=arg[1]? arg[1][1] : 0;
  a11=casadi_sq(a10);
  a09=(a09+a11);
  a12=arg[1]? arg[1][2] : 0;
  a13=casadi_sq(a12);
  a09=(a09+a13);
  a14=sqrt(a09);
  a15=(a05*a14);
  a16=sin(a15);
  a17=casadi_sq(a16);
  a17=(a17/a09);
  a09=(a17*a10);
  a18=(a09*a12);
  a18=(2.*a18);
  a19=(2.*a07);
  a15=cos(a15);
  a16=(a15*a16);
  a16=(a16/a14);
  a14=(a19*a16);
  a20=(a18-a14);
  a20=(a04*a20);
  a00=sin(a00);
  a21=(a03*a00);
  a13=(a17*a13);
  a11=(a17*a11);
  a22=(a13-a11);
  a08=(a17*a08);
  a15=casadi_sq(a15);
  a23=(a08-a15);
  a22=(a22+a23);
  a22=(a21*a22);
  a20=(a20-a22);
  a02=sin(a02);
  a09=(a19*a09);
  a22=(2.*a12);
  a22=(a22*a16);
  a24=(a09+a22);
  a24=(a02*a24);
  a20=(a20-a24);
  a14=(a14+a18);
  a14=(a21*a14);
  a23=(a11+a23);
  a23=(a23-a13);
  a23=(a04*a23);
  a14=(a14-a23);
  a19=(a19*a17);
  a19=(a19*a12);
  a16=(a16*a10);
  a16=(2.*a16);
  a17=(a19-a16);
  a17=(a02*a17);
  a14=(a14-a17);
  a20=atan2(a20,a14);
  a14=arg[0]? arg[0][1] : 0;
  a17=(2.*a14);
  a23=arg[0]? arg[0][2] : 0;
  a18=casadi_sq(a23);
  a24=(a06+a18);
  a25=casadi_sq(a14);
  a24=(a24+a25);
  a26=arg[0]? arg[0][0] : 0;
  a27=casadi_sq(a26);
  a24=(a24+a27);
  a28=sqrt(a24);
  a29=(a05*a28);
  a30=sin(a29);
  a31=casadi_sq(a30);
  a31=(a31/a24);
  a24=(a31*a23);
  a32=(a17*a24);
  a29=cos(a29);
  a30=(a30*a29);
  a30=(a30/a28);
  a28=(2.*a26);
  a33=(a30*a28);
  a34=(a32+a33);
  a35=arg[2]? arg[2][2] : 0;
  a36=sin(a35);
  a37=(a03*a36);
  a38=(a34*a37);
  a24=(a24*a28);
  a17=(a17*a30);
  a28=(a24-a17);
  a35=cos(a35);
  a39=(a03*a35);
  a40=(a28*a39);
  a38=(a38+a40);
  a29=casadi_sq(a29);
  a27=(a27*a31);
  a40=(a29-a27);
  a18=(a18*a31);
  a25=(a25*a31);
  a41=(a18-a25);
  a42=(a40+a41);
  a43=(a02*a42);
  a38=(a38-a43);
  a43=arg[0]? arg[0][4] : 0;
  a43=(a43-a10);
  a10=arg[0]? arg[0][3] : 0;
  a10=(a10-a07);
  a07=casadi_sq(a10);
  a06=(a06+a07);
  a44=casadi_sq(a43);
  a06=(a06+a44);
  a45=arg[0]? arg[0][5] : 0;
  a45=(a45-a12);
  a12=casadi_sq(a45);
  a06=(a06+a12);
  a46=sqrt(a06);
  a05=(a05*a46);
  a47=sin(a05);
  a48=casadi_sq(a47);
  a48=(a48/a06);
  a06=(a43*a48);
  a49=(2.*a10);
  a50=(a06*a49);
  a45=(2.*a45);
  a05=cos(a05);
  a47=(a47*a05);
  a47=(a47/a46);
  a46=(a45*a47);
  a51=(a50-a46);
  a51=(a38*a51);
  a52=(a01*a35);
  a53=(a00*a36);
  a54=(a02*a53);
  a54=(a52+a54);
  a55=(a54*a34);
  a35=(a00*a35);
  a56=(a02*a35);
  a36=(a01*a36);
  a56=(a56-a36);
  a57=(a56*a28);
  a55=(a55+a57);
  a03=(a03*a42);
  a00=(a00*a03);
  a55=(a55+a00);
  a07=(a07*a48);
  a05=casadi_sq(a05);
  a00=(a07-a05);
  a12=(a12*a48);
  a42=(a00+a12);
  a44=(a44*a48);
  a42=(a42-a44);
  a42=(a55*a42);
  a51=(a51-a42);
  a01=(a01*a03);
  a36=(a02*a36);
  a36=(a36-a35);
  a34=(a34*a36);
  a01=(a01+a34);
  a52=(a02*a52);
  a53=(a53+a52);
  a28=(a28*a53);
  a01=(a01+a28);
  a49=(a49*a47);
  a06=(a06*a45);
  a28=(a49+a06);
  a28=(a01*a28);
  a51=(a51+a28);
  a06=(a06-a49);
  a06=(a55*a06);
  a10=(a10*a48);
  a10=(a10*a45);
  a43=(a43*a47);
  a43=(2.*a43);
  a47=(a10+a43);
  a47=(a38*a47);
  a06=(a06+a47);
  a00=(a00-a12);
  a00=(a00+a44);
  a00=(a01*a00);
  a06=(a06-a00);
  a51=atan2(a51,a06);
  a20=(a20-a51);
  a51=sin(a20);
  a20=cos(a20);
  a51=atan2(a51,a20);
  if (res[0]!=0) res[0][0]=a51;
  a50=(a50+a46);
  a55=(a55*a50);
  a10=(a10-a43);
  a01=(a10*a01);
  a55=(a55+a01);
  a12=(a12+a44);
  a05=(a05-a12);
  a05=(a05+a07);
  a38=(a05*a38);
  a55=(a55+a38);
  a55=(-a55);
  a31=(a31*a14);
  a31=(a31*a26);
  a31=(2.*a31);
  a30=(a30*a23);
  a30=(2.*a30);
  a23=(a31-a30);
  a26=(a54*a23);
  a29=(a29+a27);
  a18=(a18-a29);
  a18=(a18+a25);
  a25=(a56*a18);
  a26=(a26-a25);
  a24=(a24+a17);
  a17=(a24*a21);
  a26=(a26+a17);
  a26=(a50*a26);
  a17=(a24*a04);
  a25=(a23*a36);
  a17=(a17+a25);
  a25=(a18*a53);
  a17=(a17-a25);
  a17=(a10*a17);
  a26=(a26+a17);
  a23=(a23*a37);
  a18=(a18*a39);
  a23=(a23-a18);
  a24=(a02*a24);
  a23=(a23-a24);
  a23=(a05*a23);
  a26=(a26+a23);
  a23=casadi_sq(a26);
  a30=(a30+a31);
  a31=(a56*a30);
  a41=(a41-a40);
  a40=(a54*a41);
  a31=(a31-a40);
  a32=(a32-a33);
  a33=(a32*a21);
  a31=(a31+a33);
  a50=(a50*a31);
  a31=(a32*a04);
  a33=(a30*a53);
  a31=(a31+a33);
  a33=(a41*a36);
  a31=(a31-a33);
  a10=(a10*a31);
  a50=(a50+a10);
  a30=(a30*a39);
  a41=(a41*a37);
  a30=(a30-a41);
  a32=(a02*a32);
  a30=(a30-a32);
  a05=(a05*a30);
  a50=(a50+a05);
  a05=casadi_sq(a50);
  a23=(a23+a05);
  a23=sqrt(a23);
  a55=atan2(a55,a23);
  a15=(a15-a11);
  a15=(a15+a08);
  a15=(a15-a13);
  a02=(a02*a15);
  a09=(a09-a22);
  a21=(a09*a21);
  a02=(a02-a21);
  a19=(a19+a16);
  a04=(a19*a04);
  a02=(a02-a04);
  a54=(a54*a09);
  a36=(a19*a36);
  a54=(a54+a36);
  a37=(a15*a37);
  a54=(a54+a37);
  a37=casadi_sq(a54);
  a56=(a56*a09);
  a19=(a19*a53);
  a56=(a56+a19);
  a15=(a15*a39);
  a56=(a56+a15);
  a15=casadi_sq(a56);
  a37=(a37+a15);
  a37=sqrt(a37);
  a02=atan2(a02,a37);
  a55=(a55-a02);
  a02=sin(a55);
  a02=(-a02);
  a55=cos(a55);
  a02=atan2(a02,a55);
  if (res[0]!=0) res[0][1]=a02;
  a54=atan2(a54,a56);
  a50=atan2(a50,a26);
  a54=(a54-a50);
  a50=sin(a54);
  a54=cos(a54);
  a50=atan2(a50,a54);
  if (res[0]!=0) res[0][2]=a50;
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



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_z_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vd_math.h"
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
CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* vd_dcm_z_casadi:(q_b2n_wxyz[4],mu[3],q_m2n_wxyz[4])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48;
  a00=5.0000000000000000e-01;
  a01=arg[2]? arg[2][1] : 0;
  a02=(2.*a01);
  a03=arg[2]? arg[2][3] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][0] : 0;
  a06=(2.*a05);
  a07=arg[2]? arg[2][2] : 0;
  a08=(a06*a07);
  a09=(a04-a08);
  a10=1.0000000000000001e-30;
  a11=arg[1]? arg[1][0] : 0;
  a12=casadi_sq(a11);
  a10=(a10+a12);
  a12=arg[1]? arg[1][1] : 0;
  a13=casadi_sq(a12);
  a10=(a10+a13);
  a13=arg[1]? arg[1][2] : 0;
  a14=casadi_sq(a13);
  a10=(a10+a14);
  a10=sqrt(a10);
  a14=(a00*a10);
  a15=sin(a14);
  a15=(a15/a10);
  a11=(a15*a11);
  a10=casadi_sq(a11);
  a12=(a15*a12);
  a16=casadi_sq(a12);
  a17=(a10-a16);
  a14=cos(a14);
  a18=casadi_sq(a14);
  a15=(a15*a13);
  a13=casadi_sq(a15);
  a19=(a18-a13);
  a17=(a17+a19);
  a20=(a09*a17);
  a20=(a00*a20);
  a21=(a06*a01);
  a22=(2.*a03);
  a22=(a22*a07);
  a23=(a21+a22);
  a14=(2.*a14);
  a24=(a14*a15);
  a25=(2.*a11);
  a26=(a25*a12);
  a27=(a24+a26);
  a28=(a23*a27);
  a28=(a00*a28);
  a20=(a20+a28);
  a28=casadi_sq(a03);
  a29=casadi_sq(a07);
  a30=(a28-a29);
  a05=casadi_sq(a05);
  a01=casadi_sq(a01);
  a31=(a05-a01);
  a30=(a30+a31);
  a25=(a25*a15);
  a32=(a14*a12);
  a33=(a25-a32);
  a34=(a30*a33);
  a34=(a00*a34);
  a20=(a20+a34);
  a34=arg[0]? arg[0][0] : 0;
  a35=(2.*a34);
  a36=arg[0]? arg[0][3] : 0;
  a37=(a35*a36);
  a38=arg[0]? arg[0][2] : 0;
  a39=(2.*a38);
  a40=arg[0]? arg[0][1] : 0;
  a41=(a39*a40);
  a42=(a37+a41);
  a43=(a20*a42);
  a26=(a26-a24);
  a24=(a09*a26);
  a24=(a00*a24);
  a19=(a16+a19);
  a19=(a19-a10);
  a44=(a23*a19);
  a44=(a00*a44);
  a24=(a24+a44);
  a14=(a14*a11);
  a12=(2.*a12);
  a12=(a12*a15);
  a15=(a14+a12);
  a11=(a30*a15);
  a11=(a00*a11);
  a24=(a24+a11);
  a11=casadi_sq(a38);
  a44=casadi_sq(a36);
  a45=(a11-a44);
  a34=casadi_sq(a34);
  a46=casadi_sq(a40);
  a47=(a34-a46);
  a45=(a45+a47);
  a48=(a24*a45);
  a43=(a43+a48);
  a32=(a32+a25);
  a09=(a09*a32);
  a09=(a00*a09);
  a12=(a12-a14);
  a23=(a23*a12);
  a23=(a00*a23);
  a09=(a09+a23);
  a18=(a18-a16);
  a18=(a18+a13);
  a18=(a18-a10);
  a30=(a30*a18);
  a30=(a00*a30);
  a09=(a09+a30);
  a39=(a39*a36);
  a30=(a35*a40);
  a10=(a39-a30);
  a13=(a09*a10);
  a43=(a43+a13);
  a06=(a06*a03);
  a02=(a02*a07);
  a07=(a06+a02);
  a03=(a07*a17);
  a31=(a29+a31);
  a31=(a31-a28);
  a13=(a31*a27);
  a03=(a03+a13);
  a22=(a22-a21);
  a21=(a22*a33);
  a03=(a03+a21);
  a40=(2.*a40);
  a40=(a40*a36);
  a35=(a35*a38);
  a38=(a40-a35);
  a36=(a03*a38);
  a36=(a00*a36);
  a43=(a43-a36);
  a36=(a07*a26);
  a21=(a31*a19);
  a36=(a36+a21);
  a21=(a22*a15);
  a36=(a36+a21);
  a30=(a30+a39);
  a39=(a36*a30);
  a39=(a00*a39);
  a43=(a43-a39);
  a07=(a07*a32);
  a31=(a31*a12);
  a07=(a07+a31);
  a22=(a22*a18);
  a07=(a07+a22);
  a47=(a44+a47);
  a47=(a47-a11);
  a22=(a07*a47);
  a22=(a00*a22);
  a43=(a43-a22);
  if (res[0]!=0) res[0][0]=a43;
  a05=(a05-a29);
  a05=(a05+a01);
  a05=(a05-a28);
  a17=(a05*a17);
  a02=(a02-a06);
  a27=(a02*a27);
  a17=(a17+a27);
  a08=(a08+a04);
  a33=(a08*a33);
  a17=(a17+a33);
  a38=(a17*a38);
  a38=(a00*a38);
  a26=(a05*a26);
  a19=(a02*a19);
  a26=(a26+a19);
  a15=(a08*a15);
  a26=(a26+a15);
  a30=(a26*a30);
  a30=(a00*a30);
  a38=(a38+a30);
  a05=(a05*a32);
  a02=(a02*a12);
  a05=(a05+a02);
  a08=(a08*a18);
  a05=(a05+a08);
  a47=(a05*a47);
  a47=(a00*a47);
  a38=(a38+a47);
  a34=(a34-a44);
  a34=(a34+a46);
  a34=(a34-a11);
  a20=(a20*a34);
  a38=(a38-a20);
  a41=(a41-a37);
  a24=(a24*a41);
  a38=(a38-a24);
  a35=(a35+a40);
  a09=(a09*a35);
  a38=(a38-a09);
  if (res[0]!=0) res[0][1]=a38;
  a03=(a03*a34);
  a03=(a00*a03);
  a36=(a36*a41);
  a36=(a00*a36);
  a03=(a03+a36);
  a07=(a07*a35);
  a07=(a00*a07);
  a03=(a03+a07);
  a17=(a17*a42);
  a17=(a00*a17);
  a03=(a03-a17);
  a26=(a26*a45);
  a26=(a00*a26);
  a03=(a03-a26);
  a05=(a05*a10);
  a00=(a00*a05);
  a03=(a03-a00);
  if (res[0]!=0) res[0][2]=a03;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_z_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "mu";
    case 2: return "q_m2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



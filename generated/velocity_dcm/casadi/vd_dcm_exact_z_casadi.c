/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_exact_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* vd_dcm_exact_z_casadi:(q_b2n_wxyz[4],mu[3],q_m2n_wxyz[4])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49;
  a00=arg[0]? arg[0][2] : 0;
  a01=arg[0]? arg[0][3] : 0;
  a02=(a00*a01);
  a03=(2.*a02);
  a04=arg[0]? arg[0][0] : 0;
  a05=(2.*a04);
  a06=arg[0]? arg[0][1] : 0;
  a07=(a05*a06);
  a03=(a03-a07);
  a08=5.0000000000000000e-01;
  a09=1.0000000000000001e-30;
  a10=arg[1]? arg[1][0] : 0;
  a11=casadi_sq(a10);
  a09=(a09+a11);
  a12=arg[1]? arg[1][1] : 0;
  a13=casadi_sq(a12);
  a09=(a09+a13);
  a14=arg[1]? arg[1][2] : 0;
  a15=casadi_sq(a14);
  a09=(a09+a15);
  a16=sqrt(a09);
  a17=(a08*a16);
  a18=sin(a17);
  a19=casadi_sq(a18);
  a19=(a19/a09);
  a09=(a19*a12);
  a09=(a09*a14);
  a09=(2.*a09);
  a10=(2.*a10);
  a17=cos(a17);
  a18=(a18*a17);
  a18=(a18/a16);
  a16=(a10*a18);
  a20=(a09-a16);
  a21=arg[2]? arg[2][0] : 0;
  a22=(2.*a21);
  a23=arg[2]? arg[2][1] : 0;
  a24=(a22*a23);
  a25=arg[2]? arg[2][3] : 0;
  a26=(2.*a25);
  a27=arg[2]? arg[2][2] : 0;
  a26=(a26*a27);
  a28=(a24+a26);
  a29=(a20*a28);
  a29=(a08*a29);
  a30=(a23*a25);
  a30=(2.*a30);
  a31=(a22*a27);
  a32=(a30-a31);
  a33=(a19*a14);
  a33=(a10*a33);
  a34=(2.*a12);
  a34=(a18*a34);
  a35=(a33+a34);
  a36=(a32*a35);
  a36=(a08*a36);
  a29=(a29+a36);
  a36=casadi_sq(a25);
  a37=casadi_sq(a27);
  a38=(a36-a37);
  a21=casadi_sq(a21);
  a39=casadi_sq(a23);
  a40=(a21-a39);
  a38=(a38+a40);
  a13=(a19*a13);
  a17=casadi_sq(a17);
  a41=(a13-a17);
  a11=(a19*a11);
  a15=(a19*a15);
  a42=(a11-a15);
  a41=(a41+a42);
  a43=(a38*a41);
  a43=(a08*a43);
  a29=(a29-a43);
  a43=(a03*a29);
  a44=(a05*a01);
  a45=(2.*a00);
  a45=(a45*a06);
  a46=(a44+a45);
  a42=(a17+a42);
  a42=(a42-a13);
  a47=(a32*a42);
  a47=(a08*a47);
  a33=(a33-a34);
  a34=(a38*a33);
  a34=(a08*a34);
  a47=(a47+a34);
  a10=(a10*a19);
  a10=(a10*a12);
  a18=(a18*a14);
  a18=(2.*a18);
  a14=(a10+a18);
  a12=(a14*a28);
  a12=(a08*a12);
  a47=(a47+a12);
  a12=(a46*a47);
  a43=(a43+a12);
  a12=casadi_sq(a00);
  a04=casadi_sq(a04);
  a19=casadi_sq(a06);
  a34=(a04-a19);
  a48=(a12+a34);
  a49=casadi_sq(a01);
  a48=(a48-a49);
  a10=(a10-a18);
  a32=(a32*a10);
  a32=(a08*a32);
  a16=(a16+a09);
  a38=(a38*a16);
  a38=(a08*a38);
  a32=(a32+a38);
  a11=(a11-a17);
  a11=(a11+a15);
  a11=(a11-a13);
  a28=(a11*a28);
  a28=(a08*a28);
  a32=(a32-a28);
  a28=(a48*a32);
  a43=(a43+a28);
  a26=(a26-a24);
  a24=(a26*a16);
  a22=(a22*a25);
  a23=(a23*a27);
  a23=(2.*a23);
  a27=(a22+a23);
  a25=(a27*a10);
  a24=(a24+a25);
  a40=(a37+a40);
  a40=(a40-a36);
  a25=(a40*a11);
  a24=(a24-a25);
  a07=(a08*a07);
  a07=(a07+a02);
  a02=(a24*a07);
  a43=(a43-a02);
  a02=(a26*a33);
  a25=(a27*a42);
  a02=(a02+a25);
  a25=(a40*a14);
  a02=(a02+a25);
  a06=(a06*a01);
  a05=(a05*a00);
  a00=(a08*a05);
  a00=(a06-a00);
  a01=(a02*a00);
  a43=(a43-a01);
  a40=(a20*a40);
  a27=(a35*a27);
  a40=(a40+a27);
  a26=(a41*a26);
  a40=(a40-a26);
  a26=(a08*a49);
  a27=(a08*a12);
  a26=(a26-a27);
  a34=(a08*a34);
  a26=(a26+a34);
  a34=(a40*a26);
  a43=(a43-a34);
  if (res[0]!=0) res[0][0]=a43;
  a31=(a31+a30);
  a16=(a16*a31);
  a21=(a21-a37);
  a21=(a21+a39);
  a21=(a21-a36);
  a10=(a10*a21);
  a16=(a16+a10);
  a23=(a23-a22);
  a11=(a11*a23);
  a16=(a16-a11);
  a07=(a07*a16);
  a33=(a33*a31);
  a14=(a14*a23);
  a33=(a33+a14);
  a42=(a42*a21);
  a33=(a33+a42);
  a00=(a00*a33);
  a07=(a07+a00);
  a20=(a20*a23);
  a35=(a35*a21);
  a20=(a20+a35);
  a41=(a41*a31);
  a20=(a20-a41);
  a26=(a26*a20);
  a07=(a07+a26);
  a06=(2.*a06);
  a05=(a05+a06);
  a29=(a29*a05);
  a07=(a07-a29);
  a04=(a04-a12);
  a04=(a04+a19);
  a04=(a04-a49);
  a47=(a47*a04);
  a07=(a07-a47);
  a45=(a45-a44);
  a32=(a32*a45);
  a07=(a07-a32);
  if (res[0]!=0) res[0][1]=a07;
  a24=(a24*a45);
  a24=(a08*a24);
  a02=(a02*a04);
  a02=(a08*a02);
  a24=(a24+a02);
  a40=(a40*a05);
  a40=(a08*a40);
  a24=(a24+a40);
  a03=(a03*a20);
  a03=(a08*a03);
  a24=(a24-a03);
  a46=(a46*a33);
  a46=(a08*a46);
  a24=(a24-a46);
  a48=(a48*a16);
  a08=(a08*a48);
  a24=(a24-a08);
  if (res[0]!=0) res[0][2]=a24;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_exact_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_z_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_exact_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_exact_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "mu";
    case 2: return "q_m2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_exact_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_exact_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_exact_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



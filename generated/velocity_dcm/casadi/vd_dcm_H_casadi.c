/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_dcm_H_casadi__ ## ID
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
#define casadi_s2 CASADI_PREFIX(s2)
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
CASADI_SYMBOL_EXPORT void vd_dcm_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_dcm_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_dcm_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {15, 1, 1};

/* vd_dcm_H_casadi:(q_m2n_wxyz[4],omega_nm_n[3])->(out_H[15]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15;
  a00=1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[0]? arg[0][1] : 0;
  a02=casadi_sq(a01);
  a03=arg[0]? arg[0][2] : 0;
  a04=casadi_sq(a03);
  a05=(a02-a04);
  a06=arg[0]? arg[0][0] : 0;
  a07=casadi_sq(a06);
  a08=arg[0]? arg[0][3] : 0;
  a09=casadi_sq(a08);
  a10=(a07-a09);
  a11=(a05+a10);
  if (res[0]!=0) res[0][1]=a11;
  a11=(2.*a01);
  a12=(a11*a03);
  a06=(2.*a06);
  a13=(a06*a08);
  a14=(a12-a13);
  if (res[0]!=0) res[0][2]=a14;
  a14=(a06*a03);
  a11=(a11*a08);
  a15=(a14+a11);
  if (res[0]!=0) res[0][3]=a15;
  a15=arg[1]? arg[1][0] : 0;
  if (res[0]!=0) res[0][4]=a15;
  if (res[0]!=0) res[0][5]=a00;
  a13=(a13+a12);
  if (res[0]!=0) res[0][6]=a13;
  a10=(a10-a05);
  if (res[0]!=0) res[0][7]=a10;
  a03=(2.*a03);
  a03=(a03*a08);
  a06=(a06*a01);
  a01=(a03-a06);
  if (res[0]!=0) res[0][8]=a01;
  a01=arg[1]? arg[1][1] : 0;
  if (res[0]!=0) res[0][9]=a01;
  if (res[0]!=0) res[0][10]=a00;
  a11=(a11-a14);
  if (res[0]!=0) res[0][11]=a11;
  a06=(a06+a03);
  if (res[0]!=0) res[0][12]=a06;
  a02=(a02+a04);
  a07=(a07-a02);
  a07=(a07+a09);
  if (res[0]!=0) res[0][13]=a07;
  a07=arg[1]? arg[1][2] : 0;
  if (res[0]!=0) res[0][14]=a07;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_dcm_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_dcm_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_dcm_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_H_casadi_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int vd_dcm_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_dcm_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_m2n_wxyz";
    case 1: return "omega_nm_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_dcm_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_dcm_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_dcm_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_dcm_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



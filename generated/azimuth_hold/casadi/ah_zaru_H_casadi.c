/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ah_zaru_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void ah_zaru_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ah_zaru_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ah_zaru_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {15, 1, 1};

/* ah_zaru_H_casadi:(lon_lat_height[3],q_b2n_wxyz[4])->(out_H[15]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16;
  a00=7.2921149999999999e-05;
  a01=arg[0]? arg[0][1] : 0;
  a02=sin(a01);
  a02=(a00*a02);
  a03=arg[1]? arg[1][0] : 0;
  a04=(2.*a03);
  a05=arg[1]? arg[1][3] : 0;
  a06=(a04*a05);
  a07=arg[1]? arg[1][1] : 0;
  a08=(2.*a07);
  a09=arg[1]? arg[1][2] : 0;
  a10=(a08*a09);
  a11=(a06+a10);
  a11=(a02*a11);
  a01=cos(a01);
  a00=(a00*a01);
  a08=(a08*a05);
  a01=(a04*a09);
  a12=(a08-a01);
  a12=(a00*a12);
  a11=(a11-a12);
  if (res[0]!=0) res[0][0]=a11;
  if (res[0]!=0) res[0][1]=a11;
  a03=casadi_sq(a03);
  a11=casadi_sq(a05);
  a12=(a03-a11);
  a13=casadi_sq(a07);
  a14=(a12+a13);
  a15=casadi_sq(a09);
  a14=(a14-a15);
  a16=(a14*a02);
  a16=(-a16);
  if (res[0]!=0) res[0][2]=a16;
  a14=(a14*a00);
  if (res[0]!=0) res[0][3]=a14;
  a14=-1.;
  if (res[0]!=0) res[0][4]=a14;
  a12=(a12-a13);
  a12=(a12+a15);
  a12=(a02*a12);
  a04=(a04*a07);
  a09=(2.*a09);
  a09=(a09*a05);
  a05=(a04+a09);
  a05=(a00*a05);
  a12=(a12-a05);
  if (res[0]!=0) res[0][5]=a12;
  if (res[0]!=0) res[0][6]=a12;
  a10=(a10-a06);
  a06=(a10*a02);
  a06=(-a06);
  if (res[0]!=0) res[0][7]=a06;
  a10=(a10*a00);
  if (res[0]!=0) res[0][8]=a10;
  if (res[0]!=0) res[0][9]=a14;
  a09=(a09-a04);
  a09=(a02*a09);
  a11=(a11-a13);
  a11=(a11-a15);
  a11=(a11+a03);
  a11=(a00*a11);
  a09=(a09-a11);
  if (res[0]!=0) res[0][10]=a09;
  if (res[0]!=0) res[0][11]=a09;
  a01=(a01+a08);
  a02=(a01*a02);
  a02=(-a02);
  if (res[0]!=0) res[0][12]=a02;
  a01=(a01*a00);
  if (res[0]!=0) res[0][13]=a01;
  if (res[0]!=0) res[0][14]=a14;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_zaru_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ah_zaru_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ah_zaru_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ah_zaru_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ah_zaru_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ah_zaru_H_casadi_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int ah_zaru_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real ah_zaru_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_zaru_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_zaru_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_zaru_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_zaru_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ah_zaru_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_zaru_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



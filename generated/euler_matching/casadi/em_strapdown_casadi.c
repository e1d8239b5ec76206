/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_strapdown_casadi__ ## ID
#endif

#include <math.h>
#include "../src/em_math.h"
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
CASADI_SYMBOL_EXPORT void em_strapdown_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_strapdown_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_strapdown_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* em_strapdown_casadi:(q_b2n_wxyz[4],dtheta_ib_b[3],omega_in_n[3],dt)->(out_q_b2n_wxyz[4]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24;
  a00=5.0000000000000000e-01;
  a01=1.0000000000000001e-30;
  a02=arg[1]? arg[1][0] : 0;
  a03=(a02*a02);
  a03=(a01+a03);
  a04=arg[1]? arg[1][1] : 0;
  a05=(a04*a04);
  a03=(a03+a05);
  a05=arg[1]? arg[1][2] : 0;
  a06=(a05*a05);
  a03=(a03+a06);
  a03=sqrt(a03);
  a06=(a00*a03);
  a07=cos(a06);
  a08=arg[0]? arg[0][0] : 0;
  a09=(a07*a08);
  a06=sin(a06);
  a06=(a06/a03);
  a03=(a06*a05);
  a10=arg[0]? arg[0][3] : 0;
  a11=(a03*a10);
  a09=(a09-a11);
  a11=arg[0]? arg[0][1] : 0;
  a12=(a06*a11);
  a13=(a12*a02);
  a09=(a09-a13);
  a13=arg[0]? arg[0][2] : 0;
  a14=(a06*a13);
  a15=(a14*a04);
  a09=(a09-a15);
  a15=arg[3]? arg[3][0] : 0;
  a16=(a15*a15);
  a17=arg[2]? arg[2][2] : 0;
  a18=(a17*a17);
  a18=(a16*a18);
  a01=(a01+a18);
  a18=arg[2]? arg[2][1] : 0;
  a19=(a18*a18);
  a19=(a16*a19);
  a01=(a01+a19);
  a19=arg[2]? arg[2][0] : 0;
  a20=(a19*a19);
  a16=(a16*a20);
  a01=(a01+a16);
  a01=sqrt(a01);
  a00=(a00*a01);
  a16=cos(a00);
  a20=(a09*a16);
  a03=(a03*a08);
  a21=(a07*a10);
  a03=(a03+a21);
  a21=(a12*a04);
  a03=(a03+a21);
  a21=(a14*a02);
  a03=(a03-a21);
  a00=sin(a00);
  a21=1.;
  a01=(a21/a01);
  a22=(a00*a01);
  a23=(a22*a15);
  a17=(a23*a17);
  a24=(a03*a17);
  a20=(a20+a24);
  a02=(a06*a02);
  a24=(a02*a10);
  a06=(a06*a04);
  a04=(a06*a08);
  a24=(a24+a04);
  a13=(a07*a13);
  a24=(a24+a13);
  a12=(a12*a05);
  a24=(a24-a12);
  a12=(a23*a18);
  a13=(a24*a12);
  a20=(a20+a13);
  a02=(a02*a08);
  a07=(a07*a11);
  a02=(a02+a07);
  a14=(a14*a05);
  a02=(a02+a14);
  a06=(a06*a10);
  a02=(a02-a06);
  a23=(a23*a19);
  a06=(a02*a23);
  a20=(a20+a06);
  a06=(a20*a20);
  a10=(a24*a16);
  a01=(a03*a01);
  a01=(a01*a00);
  a01=(a01*a15);
  a01=(a01*a19);
  a10=(a10+a01);
  a01=(a09*a12);
  a10=(a10-a01);
  a01=(a17*a02);
  a10=(a10-a01);
  a01=(a10*a10);
  a06=(a06+a01);
  a01=(a03*a16);
  a22=(a22*a02);
  a22=(a22*a15);
  a22=(a22*a18);
  a01=(a01+a22);
  a22=(a09*a17);
  a01=(a01-a22);
  a22=(a24*a23);
  a01=(a01-a22);
  a22=(a01*a01);
  a06=(a06+a22);
  a17=(a17*a24);
  a02=(a02*a16);
  a17=(a17+a02);
  a09=(a09*a23);
  a17=(a17-a09);
  a03=(a03*a12);
  a17=(a17-a03);
  a03=(a17*a17);
  a06=(a06+a03);
  a06=sqrt(a06);
  a21=(a21/a06);
  a20=(a20*a21);
  if (res[0]!=0) res[0][0]=a20;
  a17=(a17*a21);
  if (res[0]!=0) res[0][1]=a17;
  a10=(a10*a21);
  if (res[0]!=0) res[0][2]=a10;
  a01=(a01*a21);
  if (res[0]!=0) res[0][3]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_strapdown_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_strapdown_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_strapdown_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_strapdown_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_strapdown_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_strapdown_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int em_strapdown_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_strapdown_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_strapdown_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "dtheta_ib_b";
    case 2: return "omega_in_n";
    case 3: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_strapdown_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_q_b2n_wxyz";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_strapdown_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_strapdown_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_strapdown_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_strapdown_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



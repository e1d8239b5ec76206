/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_euler_exact_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void em_euler_exact_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_euler_exact_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_euler_exact_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};

/* em_euler_exact_z_casadi:(mu[3],euler_b[3],euler_m[3])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21;
  a00=arg[2]? arg[2][0] : 0;
  a01=5.0000000000000000e-01;
  a02=1.0000000000000001e-30;
  a03=arg[0]? arg[0][0] : 0;
  a04=casadi_sq(a03);
  a02=(a02+a04);
  a04=arg[0]? arg[0][1] : 0;
  a05=casadi_sq(a04);
  a02=(a02+a05);
  a05=arg[0]? arg[0][2] : 0;
  a06=casadi_sq(a05);
  a02=(a02+a06);
  a02=sqrt(a02);
  a01=(a01*a02);
  a06=cos(a01);
  a07=casadi_sq(a06);
  a01=sin(a01);
  a01=(a01/a02);
  a03=(a01*a03);
  a02=casadi_sq(a03);
  a08=(a07-a02);
  a05=(a01*a05);
  a09=casadi_sq(a05);
  a10=(a08-a09);
  a01=(a01*a04);
  a04=casadi_sq(a01);
  a10=(a10+a04);
  a11=arg[1]? arg[1][0] : 0;
  a12=sin(a11);
  a13=arg[1]? arg[1][1] : 0;
  a14=cos(a13);
  a15=(a12*a14);
  a10=(a10*a15);
  a06=(2.*a06);
  a16=(a06*a05);
  a17=(-a03);
  a17=(2.*a17);
  a18=(a17*a01);
  a19=(a16-a18);
  a13=sin(a13);
  a19=(a19*a13);
  a10=(a10-a19);
  a03=(a06*a03);
  a19=(-a01);
  a19=(2.*a19);
  a19=(a19*a05);
  a20=(a03+a19);
  a11=cos(a11);
  a21=(a14*a11);
  a20=(a20*a21);
  a10=(a10-a20);
  a06=(a06*a01);
  a17=(a17*a05);
  a05=(a06+a17);
  a05=(a05*a13);
  a03=(a03-a19);
  a03=(a03*a15);
  a05=(a05+a03);
  a08=(a08-a04);
  a08=(a08+a09);
  a08=(a08*a21);
  a05=(a05+a08);
  a10=atan2(a10,a05);
  a00=(a00-a10);
  a10=sin(a00);
  a10=(-a10);
  a00=cos(a00);
  a10=atan2(a10,a00);
  if (res[0]!=0) res[0][0]=a10;
  a10=arg[2]? arg[2][1] : 0;
  a07=(a07-a09);
  a07=(a07+a02);
  a07=(a07-a04);
  a04=(a07*a13);
  a16=(a16+a18);
  a15=(a16*a15);
  a04=(a04+a15);
  a06=(a06-a17);
  a21=(a06*a21);
  a04=(a04-a21);
  a21=arg[1]? arg[1][2] : 0;
  a17=cos(a21);
  a15=(a14*a17);
  a15=(a07*a15);
  a18=(a12*a17);
  a02=(a18*a13);
  a21=sin(a21);
  a09=(a11*a21);
  a02=(a02-a09);
  a02=(a16*a02);
  a15=(a15-a02);
  a12=(a12*a21);
  a11=(a11*a17);
  a17=(a11*a13);
  a17=(a12+a17);
  a17=(a06*a17);
  a15=(a15+a17);
  a17=casadi_sq(a15);
  a14=(a14*a21);
  a07=(a07*a14);
  a12=(a12*a13);
  a11=(a11+a12);
  a16=(a16*a11);
  a07=(a07-a16);
  a09=(a09*a13);
  a09=(a09-a18);
  a06=(a06*a09);
  a07=(a07+a06);
  a06=casadi_sq(a07);
  a17=(a17+a06);
  a17=sqrt(a17);
  a04=atan2(a04,a17);
  a10=(a10-a04);
  a04=sin(a10);
  a04=(-a04);
  a10=cos(a10);
  a04=atan2(a04,a10);
  if (res[0]!=0) res[0][1]=a04;
  a04=arg[2]? arg[2][2] : 0;
  a07=atan2(a07,a15);
  a04=(a04-a07);
  a07=sin(a04);
  a07=(-a07);
  a04=cos(a04);
  a07=atan2(a07,a04);
  if (res[0]!=0) res[0][2]=a07;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_euler_exact_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_euler_exact_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_euler_exact_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_z_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int em_euler_exact_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_euler_exact_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "mu";
    case 1: return "euler_b";
    case 2: return "euler_m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_euler_exact_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_euler_exact_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_euler_exact_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_euler_exact_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



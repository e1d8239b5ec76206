/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_omega_in_n_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void em_omega_in_n_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_omega_in_n_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_omega_in_n_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};

/* em_omega_in_n_casadi:(lat,height,v_n[3])->(out_omega_in_n[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6, a7, a8;
  a0=arg[2]? arg[2][1] : 0;
  a1=arg[1]? arg[1][0] : 0;
  a2=6378137.;
  a3=1.;
  a4=6.6943799901413173e-03;
  a5=arg[0]? arg[0][0] : 0;
  a6=sin(a5);
  a7=casadi_sq(a6);
  a4=(a4*a7);
  a3=(a3-a4);
  a4=sqrt(a3);
  a2=(a2/a4);
  a2=(a1+a2);
  a0=(a0/a2);
  a2=7.2921149999999999e-05;
  a5=cos(a5);
  a7=(a2*a5);
  a7=(a0+a7);
  if (res[0]!=0) res[0][0]=a7;
  a7=arg[2]? arg[2][0] : 0;
  a8=6.3354393272928204e+06;
  a3=(a3*a4);
  a8=(a8/a3);
  a1=(a1+a8);
  a7=(a7/a1);
  a7=(-a7);
  if (res[0]!=0) res[0][1]=a7;
  a5=(a6/a5);
  a0=(a0*a5);
  a2=(a2*a6);
  a0=(a0+a2);
  a0=(-a0);
  if (res[0]!=0) res[0][2]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_omega_in_n_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_omega_in_n_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_omega_in_n_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_omega_in_n_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_omega_in_n_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_omega_in_n_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int em_omega_in_n_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_omega_in_n_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_omega_in_n_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat";
    case 1: return "height";
    case 2: return "v_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_omega_in_n_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_omega_in_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_omega_in_n_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_omega_in_n_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_omega_in_n_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_omega_in_n_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



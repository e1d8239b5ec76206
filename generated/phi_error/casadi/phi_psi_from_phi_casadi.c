/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) phi_psi_from_phi_casadi__ ## ID
#endif

#include <math.h>
#include "../src/phi_math.h"
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
CASADI_SYMBOL_EXPORT void phi_psi_from_phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int phi_psi_from_phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int phi_psi_from_phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {17, 1, 1};

/* phi_psi_from_phi_casadi:(lon_lat_height[3],v_n[3])->(out_T[17]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a0, a1, a2, a3, a4, a5, a6;
  a0=1.;
  if (res[0]!=0) res[0][0]=a0;
  if (res[0]!=0) res[0][1]=a0;
  if (res[0]!=0) res[0][2]=a0;
  a1=arg[0]? arg[0][1] : 0;
  a2=cos(a1);
  a3=arg[1]? arg[1][2] : 0;
  a4=(a2*a3);
  a1=sin(a1);
  a5=arg[1]? arg[1][1] : 0;
  a6=(a1*a5);
  a4=(a4-a6);
  if (res[0]!=0) res[0][3]=a4;
  if (res[0]!=0) res[0][4]=a0;
  a4=arg[1]? arg[1][0] : 0;
  a6=(a1*a4);
  if (res[0]!=0) res[0][5]=a6;
  if (res[0]!=0) res[0][6]=a3;
  if (res[0]!=0) res[0][7]=a0;
  a4=(a2*a4);
  a4=(-a4);
  if (res[0]!=0) res[0][8]=a4;
  a5=(-a5);
  if (res[0]!=0) res[0][9]=a5;
  if (res[0]!=0) res[0][10]=a0;
  if (res[0]!=0) res[0][11]=a0;
  if (res[0]!=0) res[0][12]=a0;
  a2=(-a2);
  if (res[0]!=0) res[0][13]=a2;
  if (res[0]!=0) res[0][14]=a0;
  a1=(-a1);
  if (res[0]!=0) res[0][15]=a1;
  if (res[0]!=0) res[0][16]=a0;
  return 0;
}

CASADI_SYMBOL_EXPORT int phi_psi_from_phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int phi_psi_from_phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void phi_psi_from_phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void phi_psi_from_phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void phi_psi_from_phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int phi_psi_from_phi_casadi_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int phi_psi_from_phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real phi_psi_from_phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* phi_psi_from_phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* phi_psi_from_phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_T";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* phi_psi_from_phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* phi_psi_from_phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int phi_psi_from_phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int phi_psi_from_phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



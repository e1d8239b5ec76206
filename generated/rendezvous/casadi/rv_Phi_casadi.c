/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) rv_Phi_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void rv_Phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int rv_Phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int rv_Phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[3] = {32, 1, 1};

/* rv_Phi_casadi:(orbit_rate,dt)->(out_Phi[32]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  a00=1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[1]? arg[1][0] : 0;
  if (res[0]!=0) res[0][1]=a01;
  a02=2.;
  a03=arg[0]? arg[0][0] : 0;
  a02=(a02*a03);
  a02=(a02*a01);
  a04=(a01*a02);
  a05=5.0000000000000000e-01;
  a04=(a04*a05);
  if (res[0]!=0) res[0][2]=a04;
  a03=(a03*a03);
  a06=(a03*a01);
  a07=(a01*a06);
  a07=(a07*a05);
  a07=(a00-a07);
  if (res[0]!=0) res[0][3]=a07;
  if (res[0]!=0) res[0][4]=a01;
  a08=3.;
  a08=(a08*a03);
  a08=(a08*a01);
  a03=(a01*a08);
  a03=(a03*a05);
  a03=(a00+a03);
  if (res[0]!=0) res[0][5]=a03;
  a09=(-a04);
  if (res[0]!=0) res[0][6]=a09;
  if (res[0]!=0) res[0][7]=a01;
  a10=(a02*a08);
  a10=(a10*a05);
  if (res[0]!=0) res[0][8]=a10;
  a11=(a02*a02);
  a11=(a11*a05);
  a11=(a00-a11);
  if (res[0]!=0) res[0][9]=a11;
  if (res[0]!=0) res[0][10]=a02;
  a06=(-a06);
  if (res[0]!=0) res[0][11]=a06;
  if (res[0]!=0) res[0][12]=a07;
  if (res[0]!=0) res[0][13]=a08;
  a05=(-a02);
  if (res[0]!=0) res[0][14]=a05;
  if (res[0]!=0) res[0][15]=a07;
  if (res[0]!=0) res[0][16]=a00;
  if (res[0]!=0) res[0][17]=a01;
  if (res[0]!=0) res[0][18]=a04;
  if (res[0]!=0) res[0][19]=a07;
  if (res[0]!=0) res[0][20]=a01;
  if (res[0]!=0) res[0][21]=a03;
  if (res[0]!=0) res[0][22]=a09;
  if (res[0]!=0) res[0][23]=a01;
  if (res[0]!=0) res[0][24]=a10;
  if (res[0]!=0) res[0][25]=a11;
  if (res[0]!=0) res[0][26]=a02;
  if (res[0]!=0) res[0][27]=a06;
  if (res[0]!=0) res[0][28]=a07;
  if (res[0]!=0) res[0][29]=a08;
  if (res[0]!=0) res[0][30]=a05;
  if (res[0]!=0) res[0][31]=a07;
  return 0;
}

CASADI_SYMBOL_EXPORT int rv_Phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rv_Phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rv_Phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rv_Phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void rv_Phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rv_Phi_casadi_n_in(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_int rv_Phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rv_Phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rv_Phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "orbit_rate";
    case 1: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rv_Phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Phi";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rv_Phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rv_Phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rv_Phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rv_Phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



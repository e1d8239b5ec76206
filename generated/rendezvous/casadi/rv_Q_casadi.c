/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) rv_Q_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void rv_Q_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int rv_Q_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int rv_Q_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {1, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {20, 1, 1};

/* rv_Q_casadi:(orbit_rate,dt,drag_noise[3])->(out_Q[20]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20;
  a00=3.;
  a01=arg[1]? arg[1][0] : 0;
  a02=(a00*a01);
  a03=2.5000000000000000e-01;
  a02=(a02*a03);
  a04=arg[2]? arg[2][0] : 0;
  a05=2.;
  a06=(a05*a01);
  a06=(a06/a00);
  a07=(a04*a06);
  a08=(a07*a07);
  a09=arg[0]? arg[0][0] : 0;
  a10=(a05*a09);
  a11=arg[2]? arg[2][2] : 0;
  a12=(a10*a11);
  a13=(a01*a01);
  a05=(a05*a13);
  a13=9.;
  a05=(a05/a13);
  a13=(a12*a05);
  a14=(a13*a13);
  a08=(a08+a14);
  a08=(a02*a08);
  if (res[0]!=0) res[0][0]=a08;
  a08=(a11*a06);
  a14=(a08*a13);
  a15=(a10*a04);
  a16=(a15*a05);
  a17=(a16*a07);
  a14=(a14-a17);
  a14=(a02*a14);
  if (res[0]!=0) res[0][1]=a14;
  a17=(a10*a15);
  a17=(a17*a05);
  a17=(a04-a17);
  a18=(a17*a07);
  a19=(a12*a06);
  a20=(a19*a13);
  a18=(a18+a20);
  a18=(a02*a18);
  if (res[0]!=0) res[0][2]=a18;
  a09=(a09*a09);
  a00=(a00*a09);
  a00=(a00*a11);
  a10=(a10*a12);
  a00=(a00-a10);
  a00=(a00*a05);
  a00=(a11+a00);
  a13=(a00*a13);
  a15=(a15*a06);
  a07=(a15*a07);
  a13=(a13-a07);
  a13=(a02*a13);
  if (res[0]!=0) res[0][3]=a13;
  a07=arg[2]? arg[2][1] : 0;
  a06=(a07*a06);
  a10=(a06*a06);
  a10=(a02*a10);
  if (res[0]!=0) res[0][4]=a10;
  a09=(a09*a07);
  a09=(a09*a05);
  a09=(a07-a09);
  a06=(a09*a06);
  a06=(a02*a06);
  if (res[0]!=0) res[0][5]=a06;
  if (res[0]!=0) res[0][6]=a14;
  a14=(a16*a16);
  a05=(a08*a08);
  a14=(a14+a05);
  a14=(a02*a14);
  if (res[0]!=0) res[0][7]=a14;
  a14=(a19*a08);
  a05=(a17*a16);
  a14=(a14-a05);
  a14=(a02*a14);
  if (res[0]!=0) res[0][8]=a14;
  a16=(a15*a16);
  a08=(a00*a08);
  a16=(a16+a08);
  a16=(a02*a16);
  if (res[0]!=0) res[0][9]=a16;
  if (res[0]!=0) res[0][10]=a18;
  if (res[0]!=0) res[0][11]=a14;
  a01=(a01*a03);
  a04=(a04*a04);
  a04=(a01*a04);
  a03=(a17*a17);
  a14=(a19*a19);
  a03=(a03+a14);
  a03=(a02*a03);
  a04=(a04+a03);
  if (res[0]!=0) res[0][12]=a04;
  a19=(a00*a19);
  a17=(a15*a17);
  a19=(a19-a17);
  a19=(a02*a19);
  if (res[0]!=0) res[0][13]=a19;
  if (res[0]!=0) res[0][14]=a06;
  a07=(a07*a07);
  a07=(a01*a07);
  a09=(a09*a09);
  a09=(a02*a09);
  a07=(a07+a09);
  if (res[0]!=0) res[0][15]=a07;
  if (res[0]!=0) res[0][16]=a13;
  if (res[0]!=0) res[0][17]=a16;
  if (res[0]!=0) res[0][18]=a19;
  a11=(a11*a11);
  a01=(a01*a11);
  a15=(a15*a15);
  a00=(a00*a00);
  a15=(a15+a00);
  a02=(a02*a15);
  a01=(a01+a02);
  if (res[0]!=0) res[0][19]=a01;
  return 0;
}

CASADI_SYMBOL_EXPORT int rv_Q_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int rv_Q_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void rv_Q_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void rv_Q_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void rv_Q_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int rv_Q_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int rv_Q_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real rv_Q_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rv_Q_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "orbit_rate";
    case 1: return "dt";
    case 2: return "drag_noise";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* rv_Q_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Q";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rv_Q_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* rv_Q_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int rv_Q_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int rv_Q_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



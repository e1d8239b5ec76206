/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) sd_compensated_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void sd_compensated_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int sd_compensated_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int sd_compensated_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};

/* sd_compensated_casadi:(dtheta_ib_b[3],dv_b[3],dtheta_before[3],dv_before[3],dtheta_second[3],dv_second[3],dtheta_third[3],dv_third[3])->(out_dtheta_ib_b[3],out_dv_b[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15;
  a00=arg[0]? arg[0][0] : 0;
  a01=3.5714285714285713e-03;
  a02=arg[6]? arg[6][2] : 0;
  a02=(a01*a02);
  a03=5.1190476190476189e-02;
  a04=arg[2]? arg[2][2] : 0;
  a04=(a03*a04);
  a02=(a02+a04);
  a04=3.0952380952380953e-02;
  a05=arg[4]? arg[4][2] : 0;
  a05=(a04*a05);
  a02=(a02-a05);
  a05=arg[0]? arg[0][1] : 0;
  a06=(a02*a05);
  a06=(a00-a06);
  a07=arg[6]? arg[6][1] : 0;
  a07=(a01*a07);
  a08=arg[2]? arg[2][1] : 0;
  a08=(a03*a08);
  a07=(a07+a08);
  a08=arg[4]? arg[4][1] : 0;
  a08=(a04*a08);
  a07=(a07-a08);
  a08=arg[0]? arg[0][2] : 0;
  a09=(a07*a08);
  a06=(a06+a09);
  if (res[0]!=0) res[0][0]=a06;
  a06=(a02*a00);
  a06=(a05+a06);
  a09=arg[6]? arg[6][0] : 0;
  a09=(a01*a09);
  a10=arg[2]? arg[2][0] : 0;
  a10=(a03*a10);
  a09=(a09+a10);
  a10=arg[4]? arg[4][0] : 0;
  a10=(a04*a10);
  a09=(a09-a10);
  a10=(a09*a08);
  a06=(a06-a10);
  if (res[0]!=0) res[0][1]=a06;
  a06=(a09*a05);
  a06=(a08+a06);
  a10=(a07*a00);
  a06=(a06-a10);
  if (res[0]!=0) res[0][2]=a06;
  a06=arg[1]? arg[1][0] : 0;
  a10=arg[1]? arg[1][1] : 0;
  a11=(a02*a10);
  a11=(a06-a11);
  a12=arg[1]? arg[1][2] : 0;
  a13=(a07*a12);
  a11=(a11+a13);
  a13=arg[7]? arg[7][1] : 0;
  a13=(a01*a13);
  a14=arg[3]? arg[3][1] : 0;
  a14=(a03*a14);
  a13=(a13+a14);
  a14=arg[5]? arg[5][1] : 0;
  a14=(a04*a14);
  a13=(a13-a14);
  a14=(a13*a08);
  a11=(a11+a14);
  a14=arg[7]? arg[7][2] : 0;
  a14=(a01*a14);
  a15=arg[3]? arg[3][2] : 0;
  a15=(a03*a15);
  a14=(a14+a15);
  a15=arg[5]? arg[5][2] : 0;
  a15=(a04*a15);
  a14=(a14-a15);
  a15=(a14*a05);
  a11=(a11-a15);
  if (res[1]!=0) res[1][0]=a11;
  a02=(a02*a06);
  a02=(a10+a02);
  a11=(a09*a12);
  a02=(a02-a11);
  a14=(a14*a00);
  a02=(a02+a14);
  a14=arg[7]? arg[7][0] : 0;
  a01=(a01*a14);
  a14=arg[3]? arg[3][0] : 0;
  a03=(a03*a14);
  a01=(a01+a03);
  a03=arg[5]? arg[5][0] : 0;
  a04=(a04*a03);
  a01=(a01-a04);
  a08=(a01*a08);
  a02=(a02-a08);
  if (res[1]!=0) res[1][1]=a02;
  a09=(a09*a10);
  a12=(a12+a09);
  a07=(a07*a06);
  a12=(a12-a07);
  a01=(a01*a05);
  a12=(a12+a01);
  a13=(a13*a00);
  a12=(a12-a13);
  if (res[1]!=0) res[1][2]=a12;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_compensated_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int sd_compensated_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void sd_compensated_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void sd_compensated_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void sd_compensated_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int sd_compensated_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int sd_compensated_casadi_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real sd_compensated_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_compensated_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "dtheta_ib_b";
    case 1: return "dv_b";
    case 2: return "dtheta_before";
    case 3: return "dv_before";
    case 4: return "dtheta_second";
    case 5: return "dv_second";
    case 6: return "dtheta_third";
    case 7: return "dv_third";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* sd_compensated_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_dtheta_ib_b";
    case 1: return "out_dv_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_compensated_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s0;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* sd_compensated_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int sd_compensated_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int sd_compensated_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



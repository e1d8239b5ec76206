/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) ah_Qc_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void ah_Qc_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int ah_Qc_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int ah_Qc_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {24, 1, 1};

/* ah_Qc_casadi:(q_b2n_wxyz[4],gyro_noise[3],accel_noise[3],gyro_bias_noise[3],accel_bias_noise[3])->(out_Qc[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21;
  a00=arg[0]? arg[0][1] : 0;
  a01=casadi_sq(a00);
  a02=arg[0]? arg[0][2] : 0;
  a03=casadi_sq(a02);
  a04=(a01-a03);
  a05=arg[0]? arg[0][0] : 0;
  a06=casadi_sq(a05);
  a07=arg[0]? arg[0][3] : 0;
  a08=casadi_sq(a07);
  a09=(a06-a08);
  a10=(a04+a09);
  a11=arg[2]? arg[2][0] : 0;
  a11=casadi_sq(a11);
  a12=(a10*a11);
  a12=(a12*a10);
  a13=(2.*a00);
  a14=(a13*a02);
  a05=(2.*a05);
  a15=(a05*a07);
  a16=(a14-a15);
  a17=arg[2]? arg[2][1] : 0;
  a17=casadi_sq(a17);
  a18=(a16*a17);
  a18=(a18*a16);
  a12=(a12+a18);
  a18=(a05*a02);
  a13=(a13*a07);
  a19=(a18+a13);
  a20=arg[2]? arg[2][2] : 0;
  a20=casadi_sq(a20);
  a21=(a19*a20);
  a21=(a21*a19);
  a12=(a12+a21);
  if (res[0]!=0) res[0][0]=a12;
  a15=(a15+a14);
  a14=(a15*a11);
  a12=(a14*a10);
  a09=(a09-a04);
  a04=(a09*a17);
  a21=(a04*a16);
  a12=(a12+a21);
  a02=(2.*a02);
  a02=(a02*a07);
  a05=(a05*a00);
  a00=(a02-a05);
  a07=(a00*a20);
  a21=(a07*a19);
  a12=(a12+a21);
  if (res[0]!=0) res[0][1]=a12;
  a13=(a13-a18);
  a11=(a13*a11);
  a18=(a11*a10);
  a05=(a05+a02);
  a17=(a05*a17);
  a02=(a17*a16);
  a18=(a18+a02);
  a01=(a01+a03);
  a06=(a06-a01);
  a06=(a06+a08);
  a20=(a06*a20);
  a08=(a20*a19);
  a18=(a18+a08);
  if (res[0]!=0) res[0][2]=a18;
  if (res[0]!=0) res[0][3]=a12;
  a14=(a14*a15);
  a04=(a04*a09);
  a14=(a14+a04);
  a07=(a07*a00);
  a14=(a14+a07);
  if (res[0]!=0) res[0][4]=a14;
  a14=(a11*a15);
  a07=(a17*a09);
  a14=(a14+a07);
  a07=(a20*a00);
  a14=(a14+a07);
  if (res[0]!=0) res[0][5]=a14;
  if (res[0]!=0) res[0][6]=a18;
  if (res[0]!=0) res[0][7]=a14;
  a11=(a11*a13);
  a17=(a17*a05);
  a11=(a11+a17);
  a20=(a20*a06);
  a11=(a11+a20);
  if (res[0]!=0) res[0][8]=a11;
  a11=arg[1]? arg[1][0] : 0;
  a11=casadi_sq(a11);
  a20=(a10*a11);
  a20=(a20*a10);
  a17=arg[1]? arg[1][1] : 0;
  a17=casadi_sq(a17);
  a14=(a16*a17);
  a14=(a14*a16);
  a20=(a20+a14);
  a14=arg[1]? arg[1][2] : 0;
  a14=casadi_sq(a14);
  a18=(a19*a14);
  a18=(a18*a19);
  a20=(a20+a18);
  if (res[0]!=0) res[0][9]=a20;
  a20=(a15*a11);
  a18=(a20*a10);
  a07=(a09*a17);
  a04=(a07*a16);
  a18=(a18+a04);
  a04=(a00*a14);
  a12=(a04*a19);
  a18=(a18+a12);
  if (res[0]!=0) res[0][10]=a18;
  a11=(a13*a11);
  a10=(a11*a10);
  a17=(a05*a17);
  a16=(a17*a16);
  a10=(a10+a16);
  a14=(a06*a14);
  a19=(a14*a19);
  a10=(a10+a19);
  if (res[0]!=0) res[0][11]=a10;
  if (res[0]!=0) res[0][12]=a18;
  a20=(a20*a15);
  a07=(a07*a09);
  a20=(a20+a07);
  a04=(a04*a00);
  a20=(a20+a04);
  if (res[0]!=0) res[0][13]=a20;
  a15=(a11*a15);
  a09=(a17*a09);
  a15=(a15+a09);
  a00=(a14*a00);
  a15=(a15+a00);
  if (res[0]!=0) res[0][14]=a15;
  if (res[0]!=0) res[0][15]=a10;
  if (res[0]!=0) res[0][16]=a15;
  a11=(a11*a13);
  a17=(a17*a05);
  a11=(a11+a17);
  a14=(a14*a06);
  a11=(a11+a14);
  if (res[0]!=0) res[0][17]=a11;
  a11=arg[3]? arg[3][0] : 0;
  a11=casadi_sq(a11);
  if (res[0]!=0) res[0][18]=a11;
  a11=arg[3]? arg[3][1] : 0;
  a11=casadi_sq(a11);
  if (res[0]!=0) res[0][19]=a11;
  a11=arg[3]? arg[3][2] : 0;
  a11=casadi_sq(a11);
  if (res[0]!=0) res[0][20]=a11;
  a11=arg[4]? arg[4][0] : 0;
  a11=casadi_sq(a11);
  if (res[0]!=0) res[0][21]=a11;
  a11=arg[4]? arg[4][1] : 0;
  a11=casadi_sq(a11);
  if (res[0]!=0) res[0][22]=a11;
  a11=arg[4]? arg[4][2] : 0;
  a11=casadi_sq(a11);
  if (res[0]!=0) res[0][23]=a11;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_Qc_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int ah_Qc_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void ah_Qc_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void ah_Qc_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void ah_Qc_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int ah_Qc_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int ah_Qc_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real ah_Qc_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_Qc_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "gyro_noise";
    case 2: return "accel_noise";
    case 3: return "gyro_bias_noise";
    case 4: return "accel_bias_noise";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* ah_Qc_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Qc";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_Qc_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* ah_Qc_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int ah_Qc_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int ah_Qc_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



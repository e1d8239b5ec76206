/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_feedback_casadi__ ## ID
#endif

#include <math.h>
#include "../src/val_math.h"
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
#define casadi_s3 CASADI_PREFIX(s3)

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
CASADI_SYMBOL_EXPORT void val_feedback_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_feedback_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_feedback_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {19, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};

/* val_feedback_casadi:(x[19],v_n[3],q_b2n_wxyz[4],gyro_bias[3],accel_bias[3],q_b2m_wxyz[4],tau,lever_b[3])->(out_v_n[3],out_q_b2n_wxyz[4],out_gyro_bias[3],out_accel_bias[3],out_q_b2m_wxyz[4],out_tau,out_lever_b[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[0]? arg[0][3] : 0;
  a00=(a00-a01);
  if (res[0]!=0) res[0][0]=a00;
  a00=arg[1]? arg[1][1] : 0;
  a01=arg[0]? arg[0][4] : 0;
  a00=(a00-a01);
  if (res[0]!=0) res[0][1]=a00;
  a00=arg[1]? arg[1][2] : 0;
  a01=arg[0]? arg[0][5] : 0;
  a00=(a00-a01);
  if (res[0]!=0) res[0][2]=a00;
  a00=arg[2]? arg[2][0] : 0;
  a01=5.0000000000000000e-01;
  a02=1.0000000000000001e-30;
  a03=arg[0]? arg[0][2] : 0;
  a04=(a03*a03);
  a04=(a02+a04);
  a05=arg[0]? arg[0][1] : 0;
  a06=(a05*a05);
  a04=(a04+a06);
  a06=arg[0]? arg[0][0] : 0;
  a07=(a06*a06);
  a04=(a04+a07);
  a04=sqrt(a04);
  a07=(a01*a04);
  a08=cos(a07);
  a09=(a00*a08);
  a10=arg[2]? arg[2][1] : 0;
  a07=sin(a07);
  a07=(a07/a04);
  a06=(a07*a06);
  a04=(a10*a06);
  a09=(a09-a04);
  a04=arg[2]? arg[2][2] : 0;
  a05=(a07*a05);
  a11=(a04*a05);
  a09=(a09-a11);
  a11=arg[2]? arg[2][3] : 0;
  a07=(a07*a03);
  a03=(a11*a07);
  a09=(a09-a03);
  a03=1.;
  a12=(a09*a09);
  a13=(a00*a06);
  a14=(a10*a08);
  a13=(a13+a14);
  a14=(a11*a05);
  a13=(a13+a14);
  a14=(a04*a07);
  a13=(a13-a14);
  a14=(a13*a13);
  a12=(a12+a14);
  a14=(a00*a05);
  a15=(a10*a07);
  a14=(a14+a15);
  a15=(a04*a08);
  a14=(a14+a15);
  a15=(a11*a06);
  a14=(a14-a15);
  a15=(a14*a14);
  a12=(a12+a15);
  a00=(a00*a07);
  a04=(a04*a06);
  a00=(a00+a04);
  a11=(a11*a08);
  a00=(a00+a11);
  a10=(a10*a05);
  a00=(a00-a10);
  a10=(a00*a00);
  a12=(a12+a10);
  a12=sqrt(a12);
  a12=(a03/a12);
  a09=(a09*a12);
  if (res[1]!=0) res[1][0]=a09;
  a13=(a13*a12);
  if (res[1]!=0) res[1][1]=a13;
  a14=(a14*a12);
  if (res[1]!=0) res[1][2]=a14;
  a00=(a00*a12);
  if (res[1]!=0) res[1][3]=a00;
  a00=arg[3]? arg[3][0] : 0;
  a12=arg[0]? arg[0][6] : 0;
  a00=(a00-a12);
  if (res[2]!=0) res[2][0]=a00;
  a00=arg[3]? arg[3][1] : 0;
  a12=arg[0]? arg[0][7] : 0;
  a00=(a00-a12);
  if (res[2]!=0) res[2][1]=a00;
  a00=arg[3]? arg[3][2] : 0;
  a12=arg[0]? arg[0][8] : 0;
  a00=(a00-a12);
  if (res[2]!=0) res[2][2]=a00;
  a00=arg[4]? arg[4][0] : 0;
  a12=arg[0]? arg[0][9] : 0;
  a00=(a00-a12);
  if (res[3]!=0) res[3][0]=a00;
  a00=arg[4]? arg[4][1] : 0;
  a12=arg[0]? arg[0][10] : 0;
  a00=(a00-a12);
  if (res[3]!=0) res[3][1]=a00;
  a00=arg[4]? arg[4][2] : 0;
  a12=arg[0]? arg[0][11] : 0;
  a00=(a00-a12);
  if (res[3]!=0) res[3][2]=a00;
  a00=arg[5]? arg[5][0] : 0;
  a12=arg[0]? arg[0][12] : 0;
  a14=(a12*a12);
  a02=(a02+a14);
  a14=arg[0]? arg[0][13] : 0;
  a13=(a14*a14);
  a02=(a02+a13);
  a13=arg[0]? arg[0][14] : 0;
  a09=(a13*a13);
  a02=(a02+a09);
  a02=sqrt(a02);
  a01=(a01*a02);
  a09=cos(a01);
  a10=(a00*a09);
  a05=arg[5]? arg[5][1] : 0;
  a01=sin(a01);
  a01=(a01/a02);
  a12=(a01*a12);
  a02=(a05*a12);
  a10=(a10-a02);
  a02=arg[5]? arg[5][2] : 0;
  a14=(a01*a14);
  a11=(a02*a14);
  a10=(a10-a11);
  a11=arg[5]? arg[5][3] : 0;
  a01=(a01*a13);
  a13=(a11*a01);
  a10=(a10-a13);
  a13=(a10*a10);
  a08=(a00*a12);
  a04=(a05*a09);
  a08=(a08+a04);
  a04=(a11*a14);
  a08=(a08+a04);
  a04=(a02*a01);
  a08=(a08-a04);
  a04=(a08*a08);
  a13=(a13+a04);
  a04=(a00*a14);
  a06=(a05*a01);
  a04=(a04+a06);
  a06=(a02*a09);
  a04=(a04+a06);
  a06=(a11*a12);
  a04=(a04-a06);
  a06=(a04*a04);
  a13=(a13+a06);
  a00=(a00*a01);
  a02=(a02*a12);
  a00=(a00+a02);
  a11=(a11*a09);
  a00=(a00+a11);
  a05=(a05*a14);
  a00=(a00-a05);
  a05=(a00*a00);
  a13=(a13+a05);
  a13=sqrt(a13);
  a03=(a03/a13);
  a10=(a10*a03);
  if (res[4]!=0) res[4][0]=a10;
  a08=(a08*a03);
  if (res[4]!=0) res[4][1]=a08;
  a04=(a04*a03);
  if (res[4]!=0) res[4][2]=a04;
  a00=(a00*a03);
  if (res[4]!=0) res[4][3]=a00;
  a00=arg[6]? arg[6][0] : 0;
  a03=arg[0]? arg[0][15] : 0;
  a00=(a00-a03);
  if (res[5]!=0) res[5][0]=a00;
  a00=arg[7]? arg[7][0] : 0;
  a03=arg[0]? arg[0][16] : 0;
  a00=(a00-a03);
  if (res[6]!=0) res[6][0]=a00;
  a00=arg[7]? arg[7][1] : 0;
  a03=arg[0]? arg[0][17] : 0;
  a00=(a00-a03);
  if (res[6]!=0) res[6][1]=a00;
  a00=arg[7]? arg[7][2] : 0;
  a03=arg[0]? arg[0][18] : 0;
  a00=(a00-a03);
  if (res[6]!=0) res[6][2]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_feedback_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_feedback_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_feedback_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_feedback_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_feedback_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_feedback_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int val_feedback_casadi_n_out(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_real val_feedback_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_feedback_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "gyro_bias";
    case 4: return "accel_bias";
    case 5: return "q_b2m_wxyz";
    case 6: return "tau";
    case 7: return "lever_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_feedback_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_v_n";
    case 1: return "out_q_b2n_wxyz";
    case 2: return "out_gyro_bias";
    case 3: return "out_accel_bias";
    case 4: return "out_q_b2m_wxyz";
    case 5: return "out_tau";
    case 6: return "out_lever_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_feedback_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s1;
    case 4: return casadi_s1;
    case 5: return casadi_s2;
    case 6: return casadi_s3;
    case 7: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_feedback_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    case 1: return casadi_s2;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s2;
    case 5: return casadi_s3;
    case 6: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_feedback_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 7;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_feedback_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 7*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



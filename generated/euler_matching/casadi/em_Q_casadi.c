/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) em_Q_casadi__ ## ID
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
#define casadi_s3 CASADI_PREFIX(s3)
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
CASADI_SYMBOL_EXPORT void em_Q_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int em_Q_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int em_Q_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {4, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {9, 1, 1};

/* em_Q_casadi:(q_b2n_wxyz[4],omega_in_n[3],dt,gyro_noise[3])->(out_Q[9]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27;
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
  a11=arg[3]? arg[3][0] : 0;
  a11=casadi_sq(a11);
  a12=(a10*a11);
  a12=(a12*a10);
  a13=(2.*a07);
  a14=(a13*a05);
  a02=(2.*a02);
  a15=(a02*a00);
  a16=(a14-a15);
  a17=arg[3]? arg[3][1] : 0;
  a17=casadi_sq(a17);
  a18=(a16*a17);
  a18=(a18*a16);
  a12=(a12+a18);
  a18=(a02*a05);
  a13=(a13*a00);
  a19=(a18+a13);
  a20=arg[3]? arg[3][2] : 0;
  a20=casadi_sq(a20);
  a21=(a19*a20);
  a21=(a21*a19);
  a12=(a12+a21);
  a21=arg[2]? arg[2][0] : 0;
  a22=(a12*a21);
  a23=arg[1]? arg[1][2] : 0;
  a14=(a14+a15);
  a15=(a14*a11);
  a24=(a15*a10);
  a09=(a09-a04);
  a04=(a09*a17);
  a25=(a04*a16);
  a24=(a24-a25);
  a05=(a05*a00);
  a05=(2.*a05);
  a02=(a02*a07);
  a07=(a05-a02);
  a00=(a07*a20);
  a25=(a00*a19);
  a24=(a24-a25);
  a25=(a23*a24);
  a26=arg[1]? arg[1][1] : 0;
  a01=(a01+a03);
  a06=(a06-a01);
  a06=(a06+a08);
  a20=(a06*a20);
  a19=(a20*a19);
  a18=(a18-a13);
  a11=(a18*a11);
  a10=(a11*a10);
  a05=(a05+a02);
  a17=(a05*a17);
  a16=(a17*a16);
  a10=(a10+a16);
  a19=(a19-a10);
  a10=(a26*a19);
  a16=(a25-a10);
  a02=(2.*a16);
  a13=casadi_sq(a21);
  a08=2.;
  a08=(a13/a08);
  a02=(a02*a08);
  a22=(a22+a02);
  a02=arg[1]? arg[1][0] : 0;
  a01=(a02*a19);
  a03=(a23*a12);
  a01=(a01-a03);
  a03=(a23*a01);
  a12=(a26*a12);
  a27=(a02*a24);
  a12=(a12-a27);
  a27=(a26*a12);
  a03=(a03-a27);
  a03=(2.*a03);
  a15=(a15*a14);
  a04=(a04*a09);
  a15=(a15+a04);
  a00=(a00*a07);
  a15=(a15+a00);
  a00=(a23*a15);
  a09=(a17*a09);
  a14=(a11*a14);
  a09=(a09-a14);
  a07=(a20*a07);
  a09=(a09-a07);
  a07=(a26*a09);
  a00=(a00-a07);
  a07=(2.*a00);
  a07=(a07*a23);
  a14=(a23*a09);
  a11=(a11*a18);
  a17=(a17*a05);
  a11=(a11+a17);
  a20=(a20*a06);
  a11=(a11+a20);
  a20=(a26*a11);
  a14=(a14-a20);
  a20=(2.*a14);
  a20=(a20*a26);
  a07=(a07-a20);
  a03=(a03+a07);
  a13=(a13*a21);
  a07=6.;
  a13=(a13/a07);
  a03=(a03*a13);
  a22=(a22+a03);
  if (res[0]!=0) res[0][0]=a22;
  a22=(a24*a21);
  a03=(a01+a00);
  a03=(a03*a08);
  a22=(a22+a03);
  a03=(a02*a12);
  a07=(a23*a16);
  a03=(a03-a07);
  a07=(a02*a09);
  a25=(a07-a25);
  a20=(a23*a25);
  a24=(a26*a24);
  a06=(a02*a15);
  a24=(a24-a06);
  a06=(a26*a24);
  a20=(a20-a06);
  a03=(a03+a20);
  a20=(2.*a25);
  a06=(a20*a23);
  a17=(a02*a11);
  a05=(a23*a19);
  a17=(a17-a05);
  a05=(2.*a17);
  a18=(a05*a26);
  a06=(a06-a18);
  a03=(a03+a06);
  a03=(a03*a13);
  a22=(a22+a03);
  if (res[0]!=0) res[0][1]=a22;
  a19=(a19*a21);
  a03=(a12+a14);
  a03=(a03*a08);
  a19=(a19+a03);
  a16=(a26*a16);
  a03=(a02*a01);
  a16=(a16-a03);
  a03=(a23*a17);
  a10=(a10-a07);
  a07=(a26*a10);
  a03=(a03-a07);
  a16=(a16+a03);
  a03=(2.*a24);
  a07=(a03*a23);
  a06=(2.*a10);
  a18=(a06*a26);
  a07=(a07-a18);
  a16=(a16+a07);
  a16=(a16*a13);
  a19=(a19+a16);
  if (res[0]!=0) res[0][2]=a19;
  if (res[0]!=0) res[0][3]=a22;
  a15=(a15*a21);
  a20=(a20*a08);
  a15=(a15+a20);
  a20=(a02*a24);
  a22=(a23*a00);
  a20=(a20-a22);
  a20=(2.*a20);
  a05=(a05*a02);
  a01=(2.*a01);
  a01=(a01*a23);
  a05=(a05-a01);
  a20=(a20+a05);
  a20=(a20*a13);
  a15=(a15+a20);
  if (res[0]!=0) res[0][4]=a15;
  a09=(a09*a21);
  a24=(a24+a17);
  a24=(a24*a08);
  a09=(a09+a24);
  a00=(a26*a00);
  a25=(a02*a25);
  a00=(a00-a25);
  a10=(a02*a10);
  a25=(a23*a14);
  a10=(a10-a25);
  a00=(a00+a10);
  a10=(a06*a02);
  a12=(2.*a12);
  a23=(a12*a23);
  a10=(a10-a23);
  a00=(a00+a10);
  a00=(a00*a13);
  a09=(a09+a00);
  if (res[0]!=0) res[0][5]=a09;
  if (res[0]!=0) res[0][6]=a19;
  if (res[0]!=0) res[0][7]=a09;
  a11=(a11*a21);
  a06=(a06*a08);
  a11=(a11+a06);
  a14=(a26*a14);
  a17=(a02*a17);
  a14=(a14-a17);
  a14=(2.*a14);
  a12=(a12*a26);
  a03=(a03*a02);
  a12=(a12-a03);
  a14=(a14+a12);
  a14=(a14*a13);
  a11=(a11+a14);
  if (res[0]!=0) res[0][8]=a11;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_Q_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int em_Q_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void em_Q_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void em_Q_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void em_Q_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int em_Q_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int em_Q_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real em_Q_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_Q_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "q_b2n_wxyz";
    case 1: return "omega_in_n";
    case 2: return "dt";
    case 3: return "gyro_noise";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* em_Q_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Q";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_Q_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* em_Q_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int em_Q_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int em_Q_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



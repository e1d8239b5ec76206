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
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33;
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
  a04=(a04+a09);
  a10=arg[3]? arg[3][0] : 0;
  a10=casadi_sq(a10);
  a11=(a04*a10);
  a12=(a11*a04);
  a13=(2.*a07);
  a14=(a13*a05);
  a02=(2.*a02);
  a15=(a02*a00);
  a16=(a14-a15);
  a17=arg[3]? arg[3][1] : 0;
  a17=casadi_sq(a17);
  a18=(a16*a17);
  a19=(a18*a16);
  a12=(a12+a19);
  a19=(a02*a05);
  a13=(a13*a00);
  a20=(a19+a13);
  a21=arg[3]? arg[3][2] : 0;
  a21=casadi_sq(a21);
  a22=(a20*a21);
  a23=(a22*a20);
  a12=(a12+a23);
  a23=arg[2]? arg[2][0] : 0;
  a24=(a12*a23);
  a25=arg[1]? arg[1][2] : 0;
  a14=(a14+a15);
  a15=(a14*a10);
  a26=(a15*a04);
  a27=(a03-a01);
  a27=(a27+a09);
  a09=(a27*a17);
  a28=(a09*a16);
  a26=(a26-a28);
  a05=(a05*a00);
  a05=(2.*a05);
  a02=(a02*a07);
  a07=(a05-a02);
  a00=(a07*a21);
  a28=(a00*a20);
  a26=(a26-a28);
  a28=(a25*a26);
  a29=arg[1]? arg[1][1] : 0;
  a01=(a01+a03);
  a06=(a06-a01);
  a06=(a06+a08);
  a21=(a06*a21);
  a20=(a21*a20);
  a19=(a19-a13);
  a10=(a19*a10);
  a04=(a10*a04);
  a05=(a05+a02);
  a17=(a05*a17);
  a16=(a17*a16);
  a04=(a04+a16);
  a20=(a20-a04);
  a04=(a29*a20);
  a28=(a28-a04);
  a04=(2.*a28);
  a16=casadi_sq(a23);
  a02=2.;
  a02=(a16/a02);
  a13=(a04*a02);
  a24=(a24+a13);
  a13=arg[1]? arg[1][0] : 0;
  a08=(a13*a20);
  a01=(a25*a12);
  a08=(a08-a01);
  a01=(a25*a08);
  a12=(a29*a12);
  a03=(a13*a26);
  a12=(a12-a03);
  a03=(a29*a12);
  a01=(a01-a03);
  a01=(2.*a01);
  a03=(a15*a14);
  a30=(a09*a27);
  a03=(a03+a30);
  a30=(a00*a07);
  a03=(a03+a30);
  a30=(a25*a03);
  a31=(a17*a27);
  a32=(a10*a14);
  a31=(a31-a32);
  a32=(a21*a07);
  a31=(a31-a32);
  a32=(a29*a31);
  a30=(a30-a32);
  a32=(2.*a30);
  a33=(a32*a25);
  a09=(a09*a05);
  a15=(a15*a19);
  a09=(a09-a15);
  a00=(a00*a06);
  a09=(a09-a00);
  a00=(a25*a09);
  a10=(a10*a19);
  a17=(a17*a05);
  a10=(a10+a17);
  a21=(a21*a06);
  a10=(a10+a21);
  a21=(a29*a10);
  a00=(a00-a21);
  a21=(2.*a00);
  a17=(a21*a29);
  a33=(a33-a17);
  a01=(a01+a33);
  a16=(a16*a23);
  a33=6.;
  a16=(a16/a33);
  a01=(a01*a16);
  a24=(a24+a01);
  if (res[0]!=0) res[0][0]=a24;
  a14=(a11*a14);
  a27=(a18*a27);
  a14=(a14-a27);
  a07=(a22*a07);
  a14=(a14-a07);
  a07=(a14*a23);
  a27=(a30+a08);
  a27=(a27*a02);
  a07=(a07+a27);
  a27=(a13*a31);
  a24=(a25*a14);
  a27=(a27-a24);
  a24=(a25*a27);
  a14=(a29*a14);
  a01=(a13*a03);
  a14=(a14-a01);
  a01=(a29*a14);
  a24=(a24-a01);
  a01=(a13*a12);
  a33=(a25*a28);
  a01=(a01-a33);
  a33=(a24+a01);
  a21=(a21*a13);
  a17=(a04*a25);
  a21=(a21-a17);
  a33=(a33+a21);
  a33=(a33*a16);
  a07=(a07+a33);
  if (res[0]!=0) res[0][1]=a07;
  a22=(a22*a06);
  a11=(a11*a19);
  a18=(a18*a05);
  a11=(a11+a18);
  a22=(a22-a11);
  a11=(a22*a23);
  a18=(a00+a12);
  a18=(a18*a02);
  a11=(a11+a18);
  a18=(a13*a10);
  a05=(a25*a22);
  a18=(a18-a05);
  a05=(a25*a18);
  a22=(a29*a22);
  a19=(a13*a09);
  a22=(a22-a19);
  a19=(a29*a22);
  a05=(a05-a19);
  a28=(a29*a28);
  a19=(a13*a08);
  a28=(a28-a19);
  a19=(a05+a28);
  a04=(a04*a29);
  a32=(a32*a13);
  a04=(a04-a32);
  a19=(a19+a04);
  a19=(a19*a16);
  a11=(a11+a19);
  if (res[0]!=0) res[0][2]=a11;
  a26=(a26*a23);
  a11=(a08+a30);
  a11=(a11*a02);
  a26=(a26+a11);
  a01=(a01+a24);
  a24=(2.*a27);
  a11=(a24*a25);
  a19=(2.*a18);
  a04=(a19*a29);
  a11=(a11-a04);
  a01=(a01+a11);
  a01=(a01*a16);
  a26=(a26+a01);
  if (res[0]!=0) res[0][3]=a26;
  a03=(a03*a23);
  a26=(a24*a02);
  a03=(a03+a26);
  a26=(a13*a14);
  a01=(a25*a30);
  a26=(a26-a01);
  a26=(2.*a26);
  a19=(a19*a13);
  a08=(2.*a08);
  a01=(a08*a25);
  a19=(a19-a01);
  a26=(a26+a19);
  a26=(a26*a16);
  a03=(a03+a26);
  if (res[0]!=0) res[0][4]=a03;
  a09=(a09*a23);
  a03=(a18+a14);
  a03=(a03*a02);
  a09=(a09+a03);
  a03=(a13*a22);
  a26=(a25*a00);
  a03=(a03-a26);
  a30=(a29*a30);
  a27=(a13*a27);
  a30=(a30-a27);
  a27=(a03+a30);
  a08=(a08*a29);
  a24=(a24*a13);
  a08=(a08-a24);
  a27=(a27+a08);
  a27=(a27*a16);
  a09=(a09+a27);
  if (res[0]!=0) res[0][5]=a09;
  a20=(a20*a23);
  a09=(a12+a00);
  a09=(a09*a02);
  a20=(a20+a09);
  a28=(a28+a05);
  a05=(2.*a14);
  a09=(a05*a25);
  a22=(2.*a22);
  a27=(a22*a29);
  a09=(a09-a27);
  a28=(a28+a09);
  a28=(a28*a16);
  a20=(a20+a28);
  if (res[0]!=0) res[0][6]=a20;
  a31=(a31*a23);
  a14=(a14+a18);
  a14=(a14*a02);
  a31=(a31+a14);
  a30=(a30+a03);
  a03=(a22*a13);
  a12=(2.*a12);
  a25=(a12*a25);
  a03=(a03-a25);
  a30=(a30+a03);
  a30=(a30*a16);
  a31=(a31+a30);
  if (res[0]!=0) res[0][7]=a31;
  a10=(a10*a23);
  a22=(a22*a02);
  a10=(a10+a22);
  a00=(a29*a00);
  a18=(a13*a18);
  a00=(a00-a18);
  a00=(2.*a00);
  a12=(a12*a29);
  a05=(a05*a13);
  a12=(a12-a05);
  a00=(a00+a12);
  a00=(a00*a16);
  a10=(a10+a00);
  if (res[0]!=0) res[0][8]=a10;
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



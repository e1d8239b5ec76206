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
  a00=arg[2]? arg[2][0] : 0;
  a01=2.5000000000000000e-01;
  a02=(a00*a01);
  a03=arg[0]? arg[0][1] : 0;
  a04=(a03*a03);
  a05=arg[0]? arg[0][2] : 0;
  a06=(a05*a05);
  a07=(a04-a06);
  a08=arg[0]? arg[0][0] : 0;
  a09=(a08*a08);
  a10=arg[0]? arg[0][3] : 0;
  a11=(a10*a10);
  a12=(a09-a11);
  a13=(a07+a12);
  a14=arg[3]? arg[3][0] : 0;
  a13=(a13*a14);
  a15=(a13*a13);
  a16=2.;
  a17=(a16*a03);
  a18=(a17*a05);
  a08=(a16*a08);
  a19=(a08*a10);
  a20=(a18-a19);
  a21=arg[3]? arg[3][1] : 0;
  a20=(a20*a21);
  a22=(a20*a20);
  a15=(a15+a22);
  a22=(a08*a05);
  a17=(a17*a10);
  a23=(a22+a17);
  a24=arg[3]? arg[3][2] : 0;
  a23=(a23*a24);
  a25=(a23*a23);
  a15=(a15+a25);
  a15=(a02*a15);
  a25=3.;
  a26=(a25*a00);
  a26=(a26*a01);
  a01=arg[1]? arg[1][1] : 0;
  a17=(a17-a22);
  a17=(a17*a14);
  a22=(a01*a17);
  a27=arg[1]? arg[1][2] : 0;
  a19=(a19+a18);
  a19=(a19*a14);
  a14=(a27*a19);
  a22=(a22-a14);
  a14=(a16*a00);
  a14=(a14/a25);
  a25=(a22*a14);
  a25=(a25-a13);
  a18=(a27*a13);
  a28=arg[1]? arg[1][0] : 0;
  a29=(a28*a17);
  a18=(a18-a29);
  a29=(a27*a18);
  a30=(a28*a19);
  a31=(a01*a13);
  a30=(a30-a31);
  a31=(a01*a30);
  a29=(a29-a31);
  a00=(a00*a00);
  a00=(a16*a00);
  a31=9.;
  a00=(a00/a31);
  a29=(a29*a00);
  a25=(a25+a29);
  a29=(a25*a25);
  a08=(a08*a03);
  a16=(a16*a05);
  a16=(a16*a10);
  a10=(a08+a16);
  a10=(a10*a21);
  a05=(a01*a10);
  a12=(a12-a07);
  a12=(a12*a21);
  a21=(a27*a12);
  a05=(a05-a21);
  a21=(a05*a14);
  a21=(a21-a20);
  a07=(a27*a20);
  a03=(a28*a10);
  a07=(a07-a03);
  a03=(a27*a07);
  a31=(a28*a12);
  a32=(a01*a20);
  a31=(a31-a32);
  a32=(a01*a31);
  a03=(a03-a32);
  a03=(a03*a00);
  a21=(a21+a03);
  a03=(a21*a21);
  a29=(a29+a03);
  a04=(a04+a06);
  a09=(a09-a04);
  a09=(a09+a11);
  a09=(a09*a24);
  a11=(a01*a09);
  a16=(a16-a08);
  a16=(a16*a24);
  a24=(a27*a16);
  a11=(a11-a24);
  a24=(a11*a14);
  a24=(a24-a23);
  a08=(a27*a23);
  a04=(a28*a09);
  a08=(a08-a04);
  a04=(a27*a08);
  a06=(a28*a16);
  a03=(a01*a23);
  a06=(a06-a03);
  a03=(a01*a06);
  a04=(a04-a03);
  a04=(a04*a00);
  a24=(a24+a04);
  a04=(a24*a24);
  a29=(a29+a04);
  a29=(a26*a29);
  a15=(a15+a29);
  if (res[0]!=0) res[0][0]=a15;
  a15=(a19*a13);
  a29=(a12*a20);
  a15=(a15+a29);
  a29=(a16*a23);
  a15=(a15+a29);
  a15=(a02*a15);
  a29=(a18*a14);
  a29=(a29-a19);
  a04=(a28*a30);
  a03=(a27*a22);
  a04=(a04-a03);
  a04=(a04*a00);
  a29=(a29+a04);
  a04=(a29*a25);
  a03=(a07*a14);
  a03=(a03-a12);
  a32=(a28*a31);
  a33=(a27*a05);
  a32=(a32-a33);
  a32=(a32*a00);
  a03=(a03+a32);
  a32=(a03*a21);
  a04=(a04+a32);
  a32=(a08*a14);
  a32=(a32-a16);
  a33=(a28*a06);
  a27=(a27*a11);
  a33=(a33-a27);
  a33=(a33*a00);
  a32=(a32+a33);
  a33=(a32*a24);
  a04=(a04+a33);
  a04=(a26*a04);
  a15=(a15+a04);
  if (res[0]!=0) res[0][1]=a15;
  a13=(a17*a13);
  a20=(a10*a20);
  a13=(a13+a20);
  a23=(a09*a23);
  a13=(a13+a23);
  a13=(a02*a13);
  a30=(a30*a14);
  a30=(a30-a17);
  a22=(a01*a22);
  a18=(a28*a18);
  a22=(a22-a18);
  a22=(a22*a00);
  a30=(a30+a22);
  a25=(a30*a25);
  a31=(a31*a14);
  a31=(a31-a10);
  a05=(a01*a05);
  a07=(a28*a07);
  a05=(a05-a07);
  a05=(a05*a00);
  a31=(a31+a05);
  a21=(a31*a21);
  a25=(a25+a21);
  a06=(a06*a14);
  a06=(a06-a09);
  a01=(a01*a11);
  a28=(a28*a08);
  a01=(a01-a28);
  a01=(a01*a00);
  a06=(a06+a01);
  a24=(a06*a24);
  a25=(a25+a24);
  a25=(a26*a25);
  a13=(a13+a25);
  if (res[0]!=0) res[0][2]=a13;
  if (res[0]!=0) res[0][3]=a15;
  a15=(a19*a19);
  a25=(a12*a12);
  a15=(a15+a25);
  a25=(a16*a16);
  a15=(a15+a25);
  a15=(a02*a15);
  a25=(a29*a29);
  a24=(a03*a03);
  a25=(a25+a24);
  a24=(a32*a32);
  a25=(a25+a24);
  a25=(a26*a25);
  a15=(a15+a25);
  if (res[0]!=0) res[0][4]=a15;
  a19=(a17*a19);
  a12=(a10*a12);
  a19=(a19+a12);
  a16=(a09*a16);
  a19=(a19+a16);
  a19=(a02*a19);
  a29=(a30*a29);
  a03=(a31*a03);
  a29=(a29+a03);
  a32=(a06*a32);
  a29=(a29+a32);
  a29=(a26*a29);
  a19=(a19+a29);
  if (res[0]!=0) res[0][5]=a19;
  if (res[0]!=0) res[0][6]=a13;
  if (res[0]!=0) res[0][7]=a19;
  a17=(a17*a17);
  a10=(a10*a10);
  a17=(a17+a10);
  a09=(a09*a09);
  a17=(a17+a09);
  a02=(a02*a17);
  a30=(a30*a30);
  a31=(a31*a31);
  a30=(a30+a31);
  a06=(a06*a06);
  a30=(a30+a06);
  a26=(a26*a30);
  a02=(a02+a26);
  if (res[0]!=0) res[0][8]=a02;
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



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_expected_casadi__ ## ID
#endif

#include <math.h>
#include "../src/va_math.h"
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
CASADI_SYMBOL_EXPORT void va_expected_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_expected_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_expected_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};

/* va_expected_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],lever_b[3])->(out_v_m_n[3],out_q_m2n_wxyz[4],out_omega_nb_n[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=2.;
  a03=arg[2]? arg[2][1] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][3] : 0;
  a06=(a04*a05);
  a07=arg[2]? arg[2][0] : 0;
  a08=(a02*a07);
  a09=arg[2]? arg[2][2] : 0;
  a10=(a08*a09);
  a11=(a06-a10);
  a12=(a01*a11);
  a13=arg[5]? arg[5][1] : 0;
  a14=(a08*a03);
  a02=(a02*a09);
  a02=(a02*a05);
  a15=(a14+a02);
  a16=(a13*a15);
  a12=(a12+a16);
  a16=arg[5]? arg[5][2] : 0;
  a17=(a07*a07);
  a18=(a09*a09);
  a19=(a17-a18);
  a20=(a03*a03);
  a21=(a19-a20);
  a22=(a05*a05);
  a21=(a21+a22);
  a23=(a16*a21);
  a12=(a12+a23);
  a23=arg[0]? arg[0][2] : 0;
  a24=6.3354393272928204e+06;
  a25=1.;
  a26=6.6943799901413173e-03;
  a27=arg[0]? arg[0][0] : 0;
  a28=sin(a27);
  a29=(a28*a28);
  a26=(a26*a29);
  a26=(a25-a26);
  a29=sqrt(a26);
  a26=(a26*a29);
  a24=(a24/a26);
  a24=(a23+a24);
  a24=(a00/a24);
  a26=(a12*a24);
  a00=(a00-a26);
  a26=arg[4]? arg[4][2] : 0;
  a04=(a04*a09);
  a08=(a08*a05);
  a30=(a04-a08);
  a31=(a26*a30);
  a32=arg[4]? arg[4][1] : 0;
  a10=(a10+a06);
  a06=(a32*a10);
  a31=(a31-a06);
  a31=(a01*a31);
  a06=arg[4]? arg[4][0] : 0;
  a33=(a06*a10);
  a19=(a19+a20);
  a19=(a19-a22);
  a34=(a26*a19);
  a33=(a33-a34);
  a33=(a13*a33);
  a31=(a31+a33);
  a33=(a32*a19);
  a34=(a06*a30);
  a33=(a33-a34);
  a33=(a16*a33);
  a31=(a31+a33);
  a00=(a00-a31);
  a08=(a08+a04);
  a04=(a01*a08);
  a20=(a20+a22);
  a17=(a17-a20);
  a17=(a17+a18);
  a18=(a13*a17);
  a04=(a04+a18);
  a02=(a02-a14);
  a14=(a16*a02);
  a04=(a04+a14);
  a14=arg[1]? arg[1][1] : 0;
  a18=6378137.;
  a18=(a18/a29);
  a23=(a23+a18);
  a23=(a14/a23);
  a27=cos(a27);
  a18=(a28/a27);
  a18=(a23*a18);
  a29=7.2921149999999999e-05;
  a28=(a29*a28);
  a18=(a18+a28);
  a28=(a04*a18);
  a00=(a00+a28);
  if (res[0]!=0) res[0][0]=a00;
  a00=(a01*a19);
  a28=(a13*a30);
  a00=(a00+a28);
  a28=(a16*a10);
  a00=(a00+a28);
  a28=(a00*a18);
  a14=(a14-a28);
  a28=(a26*a17);
  a20=(a32*a02);
  a28=(a28-a20);
  a28=(a01*a28);
  a20=(a06*a02);
  a22=(a26*a08);
  a20=(a20-a22);
  a20=(a13*a20);
  a28=(a28+a20);
  a20=(a32*a08);
  a22=(a06*a17);
  a20=(a20-a22);
  a20=(a16*a20);
  a28=(a28+a20);
  a14=(a14-a28);
  a29=(a29*a27);
  a23=(a23+a29);
  a12=(a12*a23);
  a14=(a14-a12);
  if (res[0]!=0) res[0][1]=a14;
  a14=arg[1]? arg[1][2] : 0;
  a04=(a04*a23);
  a14=(a14+a04);
  a04=(a26*a15);
  a12=(a32*a21);
  a04=(a04-a12);
  a01=(a01*a04);
  a04=(a06*a21);
  a12=(a26*a11);
  a04=(a04-a12);
  a13=(a13*a04);
  a01=(a01+a13);
  a13=(a32*a11);
  a04=(a06*a15);
  a13=(a13-a04);
  a16=(a16*a13);
  a01=(a01+a16);
  a14=(a14-a01);
  a00=(a00*a24);
  a14=(a14+a00);
  if (res[0]!=0) res[0][2]=a14;
  a14=arg[3]? arg[3][0] : 0;
  a00=(a14*a07);
  a01=arg[3]? arg[3][1] : 0;
  a16=(a01*a03);
  a00=(a00+a16);
  a16=arg[3]? arg[3][2] : 0;
  a13=(a16*a09);
  a00=(a00+a13);
  a13=arg[3]? arg[3][3] : 0;
  a04=(a13*a05);
  a00=(a00+a04);
  a04=(a00*a00);
  a12=(a14*a03);
  a29=(a16*a05);
  a12=(a12+a29);
  a29=(a01*a07);
  a12=(a12-a29);
  a29=(a13*a09);
  a12=(a12-a29);
  a29=(a12*a12);
  a04=(a04+a29);
  a29=(a14*a09);
  a27=(a13*a03);
  a29=(a29+a27);
  a27=(a01*a05);
  a29=(a29-a27);
  a27=(a16*a07);
  a29=(a29-a27);
  a27=(a29*a29);
  a04=(a04+a27);
  a14=(a14*a05);
  a01=(a01*a09);
  a14=(a14+a01);
  a16=(a16*a03);
  a14=(a14-a16);
  a13=(a13*a07);
  a14=(a14-a13);
  a13=(a14*a14);
  a04=(a04+a13);
  a04=sqrt(a04);
  a25=(a25/a04);
  a00=(a00*a25);
  if (res[1]!=0) res[1][0]=a00;
  a12=(a12*a25);
  if (res[1]!=0) res[1][1]=a12;
  a29=(a29*a25);
  if (res[1]!=0) res[1][2]=a29;
  a14=(a14*a25);
  if (res[1]!=0) res[1][3]=a14;
  a19=(a06*a19);
  a30=(a32*a30);
  a19=(a19+a30);
  a10=(a26*a10);
  a19=(a19+a10);
  a19=(a19-a23);
  if (res[2]!=0) res[2][0]=a19;
  a08=(a06*a08);
  a17=(a32*a17);
  a08=(a08+a17);
  a02=(a26*a02);
  a08=(a08+a02);
  a08=(a08+a24);
  if (res[2]!=0) res[2][1]=a08;
  a06=(a06*a11);
  a32=(a32*a15);
  a06=(a06+a32);
  a26=(a26*a21);
  a06=(a06+a26);
  a06=(a06+a18);
  if (res[2]!=0) res[2][2]=a06;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_expected_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_expected_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_expected_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_expected_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_expected_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_expected_casadi_n_in(void) { return 6;}

CASADI_SYMBOL_EXPORT casadi_int va_expected_casadi_n_out(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_real va_expected_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_expected_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "lever_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_expected_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_v_m_n";
    case 1: return "out_q_m2n_wxyz";
    case 2: return "out_omega_nb_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_expected_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_expected_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_expected_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6;
  if (sz_res) *sz_res = 3;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_expected_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 3*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



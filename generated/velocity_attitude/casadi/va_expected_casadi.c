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
  casadi_real a24, a25, a26, a27, a28, a29, a30;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=2.;
  a03=arg[2]? arg[2][0] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][3] : 0;
  a06=(a04*a05);
  a07=arg[2]? arg[2][1] : 0;
  a08=(a02*a07);
  a09=arg[2]? arg[2][2] : 0;
  a08=(a08*a09);
  a10=(a06+a08);
  a11=7.2921149999999999e-05;
  a12=arg[0]? arg[0][0] : 0;
  a13=sin(a12);
  a14=(a11*a13);
  a15=arg[1]? arg[1][1] : 0;
  a16=arg[0]? arg[0][2] : 0;
  a17=6378137.;
  a18=1.;
  a19=6.6943799901413173e-03;
  a20=(a13*a13);
  a19=(a19*a20);
  a19=(a18-a19);
  a20=sqrt(a19);
  a17=(a17/a20);
  a17=(a16+a17);
  a17=(a15/a17);
  a12=cos(a12);
  a13=(a13/a12);
  a13=(a17*a13);
  a14=(a14+a13);
  a13=(a10*a14);
  a21=(a07*a05);
  a21=(a02*a21);
  a22=(a04*a09);
  a23=(a21-a22);
  a24=6.3354393272928204e+06;
  a19=(a19*a20);
  a24=(a24/a19);
  a16=(a16+a24);
  a16=(a00/a16);
  a24=(a23*a16);
  a13=(a13-a24);
  a13=(a01*a13);
  a00=(a00+a13);
  a13=arg[5]? arg[5][1] : 0;
  a24=(a03*a03);
  a19=(a07*a07);
  a20=(a24-a19);
  a25=(a05*a05);
  a26=(a20-a25);
  a27=(a09*a09);
  a26=(a26+a27);
  a28=(a14*a26);
  a04=(a04*a07);
  a29=(a09*a05);
  a02=(a02*a29);
  a29=(a04+a02);
  a30=(a16*a29);
  a28=(a28-a30);
  a28=(a13*a28);
  a00=(a00+a28);
  a28=arg[5]? arg[5][2] : 0;
  a02=(a02-a04);
  a04=(a14*a02);
  a20=(a25+a20);
  a20=(a20-a27);
  a30=(a16*a20);
  a04=(a04-a30);
  a04=(a28*a04);
  a00=(a00+a04);
  a08=(a08-a06);
  a06=arg[4]? arg[4][2] : 0;
  a04=(a08*a06);
  a22=(a22+a21);
  a21=arg[4]? arg[4][1] : 0;
  a30=(a22*a21);
  a04=(a04-a30);
  a04=(a01*a04);
  a00=(a00-a04);
  a04=arg[4]? arg[4][0] : 0;
  a30=(a22*a04);
  a24=(a24-a25);
  a24=(a24+a19);
  a24=(a24-a27);
  a27=(a24*a06);
  a30=(a30-a27);
  a30=(a13*a30);
  a00=(a00-a30);
  a30=(a24*a21);
  a27=(a08*a04);
  a30=(a30-a27);
  a30=(a28*a30);
  a00=(a00-a30);
  if (res[0]!=0) res[0][0]=a00;
  a00=(a24*a14);
  a11=(a11*a12);
  a12=(a17+a11);
  a30=(a23*a12);
  a00=(a00+a30);
  a00=(a01*a00);
  a15=(a15-a00);
  a00=(a29*a12);
  a30=(a14*a08);
  a00=(a00+a30);
  a00=(a13*a00);
  a15=(a15-a00);
  a00=(a20*a12);
  a30=(a14*a22);
  a00=(a00+a30);
  a00=(a28*a00);
  a15=(a15-a00);
  a00=(a26*a06);
  a30=(a02*a21);
  a00=(a00-a30);
  a00=(a01*a00);
  a15=(a15-a00);
  a00=(a02*a04);
  a30=(a10*a06);
  a00=(a00-a30);
  a00=(a13*a00);
  a15=(a15-a00);
  a00=(a10*a21);
  a30=(a26*a04);
  a00=(a00-a30);
  a00=(a28*a00);
  a15=(a15-a00);
  if (res[0]!=0) res[0][1]=a15;
  a15=arg[1]? arg[1][2] : 0;
  a00=(a24*a16);
  a30=(a10*a12);
  a00=(a00+a30);
  a00=(a01*a00);
  a15=(a15+a00);
  a00=(a16*a08);
  a30=(a26*a12);
  a00=(a00+a30);
  a00=(a13*a00);
  a15=(a15+a00);
  a00=(a16*a22);
  a12=(a02*a12);
  a00=(a00+a12);
  a00=(a28*a00);
  a15=(a15+a00);
  a00=(a29*a06);
  a12=(a20*a21);
  a00=(a00-a12);
  a01=(a01*a00);
  a15=(a15-a01);
  a01=(a20*a04);
  a00=(a23*a06);
  a01=(a01-a00);
  a13=(a13*a01);
  a15=(a15-a13);
  a13=(a23*a21);
  a01=(a29*a04);
  a13=(a13-a01);
  a28=(a28*a13);
  a15=(a15-a28);
  if (res[0]!=0) res[0][2]=a15;
  a15=arg[3]? arg[3][0] : 0;
  a28=(a15*a03);
  a13=arg[3]? arg[3][1] : 0;
  a01=(a13*a07);
  a28=(a28+a01);
  a01=arg[3]? arg[3][2] : 0;
  a00=(a01*a09);
  a28=(a28+a00);
  a00=arg[3]? arg[3][3] : 0;
  a12=(a00*a05);
  a28=(a28+a12);
  a12=(a28*a28);
  a30=(a15*a07);
  a27=(a01*a05);
  a30=(a30+a27);
  a27=(a13*a03);
  a30=(a30-a27);
  a27=(a00*a09);
  a30=(a30-a27);
  a27=(a30*a30);
  a12=(a12+a27);
  a27=(a15*a09);
  a19=(a00*a07);
  a27=(a27+a19);
  a19=(a13*a05);
  a27=(a27-a19);
  a19=(a01*a03);
  a27=(a27-a19);
  a19=(a27*a27);
  a12=(a12+a19);
  a15=(a15*a05);
  a13=(a13*a09);
  a15=(a15+a13);
  a01=(a01*a07);
  a15=(a15-a01);
  a00=(a00*a03);
  a15=(a15-a00);
  a00=(a15*a15);
  a12=(a12+a00);
  a12=sqrt(a12);
  a18=(a18/a12);
  a28=(a28*a18);
  if (res[1]!=0) res[1][0]=a28;
  a30=(a30*a18);
  if (res[1]!=0) res[1][1]=a30;
  a27=(a27*a18);
  if (res[1]!=0) res[1][2]=a27;
  a15=(a15*a18);
  if (res[1]!=0) res[1][3]=a15;
  a24=(a24*a04);
  a22=(a22*a06);
  a24=(a24+a22);
  a08=(a08*a21);
  a24=(a24+a08);
  a24=(a24-a17);
  a24=(a24-a11);
  if (res[2]!=0) res[2][0]=a24;
  a10=(a10*a04);
  a16=(a16+a10);
  a26=(a26*a21);
  a16=(a16+a26);
  a02=(a02*a06);
  a16=(a16+a02);
  if (res[2]!=0) res[2][1]=a16;
  a23=(a23*a04);
  a14=(a14+a23);
  a29=(a29*a21);
  a14=(a14+a29);
  a20=(a20*a06);
  a14=(a14+a20);
  if (res[2]!=0) res[2][2]=a14;
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



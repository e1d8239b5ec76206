/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_euler_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void va_euler_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_euler_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_euler_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {17, 1, 1};

/* va_euler_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],omega_ib_b[3],euler_m[3])->(out_H[17]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38;
  a00=arg[4]? arg[4][1] : 0;
  a01=sin(a00);
  a02=arg[4]? arg[4][0] : 0;
  a03=sin(a02);
  a04=1.;
  a00=cos(a00);
  a05=(a04/a00);
  a06=(a03*a05);
  a07=arg[4]? arg[4][2] : 0;
  a08=cos(a07);
  a09=(a03*a08);
  a10=(a01*a09);
  a07=sin(a07);
  a02=cos(a02);
  a11=(a07*a02);
  a10=(a10-a11);
  a12=(a06*a10);
  a13=(a01*a12);
  a05=(a02*a05);
  a14=(a03*a07);
  a15=(a08*a02);
  a16=(a01*a15);
  a16=(a14+a16);
  a17=(a05*a16);
  a18=(a01*a17);
  a13=(a13+a18);
  a18=(a00*a08);
  a13=(a13+a18);
  a18=(-a13);
  if (res[0]!=0) res[0][0]=a18;
  a14=(a01*a14);
  a15=(a15+a14);
  a14=(a06*a15);
  a18=(a01*a14);
  a11=(a01*a11);
  a11=(a11-a09);
  a09=(a05*a11);
  a01=(a01*a09);
  a18=(a18+a01);
  a00=(a00*a07);
  a18=(a18+a00);
  a00=(-a18);
  if (res[0]!=0) res[0][1]=a00;
  if (res[0]!=0) res[0][2]=a04;
  a15=(a18*a15);
  a10=(a13*a10);
  a15=(a15+a10);
  if (res[0]!=0) res[0][3]=a15;
  a11=(a18*a11);
  a16=(a13*a16);
  a11=(a11+a16);
  if (res[0]!=0) res[0][4]=a11;
  a11=arg[1]? arg[1][1] : 0;
  a16=arg[0]? arg[0][2] : 0;
  a15=6378137.;
  a10=6.6943799901413173e-03;
  a00=arg[0]? arg[0][0] : 0;
  a01=sin(a00);
  a19=(a01*a01);
  a10=(a10*a19);
  a04=(a04-a10);
  a10=sqrt(a04);
  a15=(a15/a10);
  a15=(a16+a15);
  a11=(a11/a15);
  a15=7.2921149999999999e-05;
  a00=cos(a00);
  a19=(a15*a00);
  a19=(a11+a19);
  a20=arg[3]? arg[3][0] : 0;
  a21=arg[2]? arg[2][1] : 0;
  a22=(a21*a21);
  a23=arg[2]? arg[2][2] : 0;
  a24=(a23*a23);
  a25=(a22-a24);
  a26=arg[2]? arg[2][0] : 0;
  a27=(a26*a26);
  a28=arg[2]? arg[2][3] : 0;
  a29=(a28*a28);
  a30=(a27-a29);
  a25=(a25+a30);
  a25=(a20*a25);
  a19=(a19-a25);
  a25=arg[3]? arg[3][1] : 0;
  a31=2.;
  a32=(a31*a21);
  a33=(a32*a23);
  a26=(a31*a26);
  a34=(a26*a28);
  a35=(a33-a34);
  a35=(a25*a35);
  a19=(a19-a35);
  a35=arg[3]? arg[3][2] : 0;
  a36=(a26*a23);
  a32=(a32*a28);
  a37=(a36+a32);
  a37=(a35*a37);
  a19=(a19-a37);
  a13=(a13*a19);
  a37=arg[1]? arg[1][0] : 0;
  a38=6.3354393272928204e+06;
  a04=(a04*a10);
  a38=(a38/a04);
  a16=(a16+a38);
  a37=(a37/a16);
  a34=(a34+a33);
  a34=(a20*a34);
  a37=(a37+a34);
  a30=(a24+a30);
  a30=(a30-a22);
  a30=(a25*a30);
  a37=(a37+a30);
  a31=(a31*a23);
  a31=(a31*a28);
  a26=(a26*a21);
  a21=(a31-a26);
  a21=(a35*a21);
  a37=(a37+a21);
  a18=(a18*a37);
  a13=(a13-a18);
  if (res[0]!=0) res[0][5]=a13;
  if (res[0]!=0) res[0][6]=a07;
  a13=(-a08);
  if (res[0]!=0) res[0][7]=a13;
  if (res[0]!=0) res[0][8]=a02;
  a03=(-a03);
  if (res[0]!=0) res[0][9]=a03;
  a07=(a07*a19);
  a08=(a08*a37);
  a07=(a07+a08);
  a07=(-a07);
  if (res[0]!=0) res[0][10]=a07;
  a12=(a12+a17);
  a17=(-a12);
  if (res[0]!=0) res[0][11]=a17;
  a14=(a14+a09);
  a09=(-a14);
  if (res[0]!=0) res[0][12]=a09;
  a09=-1.;
  if (res[0]!=0) res[0][13]=a09;
  if (res[0]!=0) res[0][14]=a06;
  if (res[0]!=0) res[0][15]=a05;
  a12=(a12*a19);
  a14=(a14*a37);
  a12=(a12-a14);
  a00=(a01/a00);
  a11=(a11*a00);
  a15=(a15*a01);
  a11=(a11+a15);
  a32=(a32-a36);
  a20=(a20*a32);
  a11=(a11+a20);
  a26=(a26+a31);
  a25=(a25*a26);
  a11=(a11+a25);
  a27=(a27-a24);
  a27=(a27+a29);
  a27=(a27-a22);
  a35=(a35*a27);
  a11=(a11+a35);
  a12=(a12-a11);
  if (res[0]!=0) res[0][16]=a12;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_euler_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_euler_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_euler_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_euler_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_euler_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_euler_H_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int va_euler_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_euler_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_euler_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "omega_ib_b";
    case 4: return "euler_m";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_euler_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_euler_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_euler_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_euler_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_euler_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_F_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void va_F_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_F_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_F_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {41, 1, 1};

/* va_F_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],f_b[3])->(out_F[41]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27;
  a00=arg[0]? arg[0][0] : 0;
  a01=sin(a00);
  a00=cos(a00);
  a02=(a01/a00);
  a03=arg[1]? arg[1][1] : 0;
  a04=1.;
  a05=arg[0]? arg[0][2] : 0;
  a06=6378137.;
  a07=6.6943799901413173e-03;
  a08=(a01*a01);
  a07=(a07*a08);
  a07=(a04-a07);
  a08=sqrt(a07);
  a06=(a06/a08);
  a06=(a05+a06);
  a06=(a04/a06);
  a03=(a03*a06);
  a09=(a02*a03);
  a10=7.2921149999999999e-05;
  a01=(a10*a01);
  a11=(a09+a01);
  a12=(-a11);
  if (res[0]!=0) res[0][0]=a12;
  a12=arg[1]? arg[1][0] : 0;
  a13=6.3354393272928204e+06;
  a07=(a07*a08);
  a13=(a13/a07);
  a05=(a05+a13);
  a04=(a04/a05);
  a05=(a12*a04);
  if (res[0]!=0) res[0][1]=a05;
  if (res[0]!=0) res[0][2]=a06;
  a13=arg[2]? arg[2][0] : 0;
  a07=(a13*a13);
  a08=arg[2]? arg[2][3] : 0;
  a14=(a08*a08);
  a15=(a07-a14);
  a16=arg[2]? arg[2][1] : 0;
  a17=(a16*a16);
  a18=(a15+a17);
  a19=arg[2]? arg[2][2] : 0;
  a20=(a19*a19);
  a18=(a18-a20);
  if (res[0]!=0) res[0][3]=a18;
  a21=2.;
  a22=(a21*a16);
  a23=(a22*a19);
  a13=(a21*a13);
  a24=(a13*a08);
  a25=(a23-a24);
  if (res[0]!=0) res[0][4]=a25;
  a26=(a13*a19);
  a22=(a22*a08);
  a27=(a26+a22);
  if (res[0]!=0) res[0][5]=a27;
  if (res[0]!=0) res[0][6]=a11;
  a10=(a10*a00);
  a10=(a03+a10);
  if (res[0]!=0) res[0][7]=a10;
  a11=(-a04);
  if (res[0]!=0) res[0][8]=a11;
  a24=(a24+a23);
  if (res[0]!=0) res[0][9]=a24;
  a15=(a15-a17);
  a15=(a15+a20);
  if (res[0]!=0) res[0][10]=a15;
  a19=(a21*a19);
  a19=(a19*a08);
  a13=(a13*a16);
  a16=(a19-a13);
  if (res[0]!=0) res[0][11]=a16;
  a08=(-a05);
  if (res[0]!=0) res[0][12]=a08;
  a10=(-a10);
  if (res[0]!=0) res[0][13]=a10;
  a02=(a02*a06);
  a10=(-a02);
  if (res[0]!=0) res[0][14]=a10;
  a22=(a22-a26);
  if (res[0]!=0) res[0][15]=a22;
  a13=(a13+a19);
  if (res[0]!=0) res[0][16]=a13;
  a14=(a14-a17);
  a14=(a14-a20);
  a14=(a14+a07);
  if (res[0]!=0) res[0][17]=a14;
  a07=arg[3]? arg[3][0] : 0;
  a20=(a07*a22);
  a17=arg[3]? arg[3][1] : 0;
  a19=(a17*a13);
  a20=(a20+a19);
  a19=arg[3]? arg[3][2] : 0;
  a26=(a19*a14);
  a20=(a20+a26);
  a26=(-a20);
  if (res[0]!=0) res[0][18]=a26;
  a26=(a07*a24);
  a10=(a17*a15);
  a26=(a26+a10);
  a10=(a19*a16);
  a26=(a26+a10);
  if (res[0]!=0) res[0][19]=a26;
  a10=arg[1]? arg[1][2] : 0;
  a04=(a10*a04);
  if (res[0]!=0) res[0][20]=a04;
  a01=(-a01);
  a01=(a21*a01);
  a01=(a01-a09);
  a09=(a01-a09);
  if (res[0]!=0) res[0][21]=a09;
  if (res[0]!=0) res[0][22]=a05;
  a09=(-a18);
  if (res[0]!=0) res[0][23]=a09;
  a09=(-a25);
  if (res[0]!=0) res[0][24]=a09;
  a09=(-a27);
  if (res[0]!=0) res[0][25]=a09;
  if (res[0]!=0) res[0][26]=a20;
  a07=(a07*a18);
  a17=(a17*a25);
  a07=(a07+a17);
  a19=(a19*a27);
  a07=(a07+a19);
  a19=(-a07);
  if (res[0]!=0) res[0][27]=a19;
  a01=(-a01);
  if (res[0]!=0) res[0][28]=a01;
  a10=(a10*a06);
  a12=(a12*a02);
  a10=(a10+a12);
  if (res[0]!=0) res[0][29]=a10;
  a10=1.4584230000000000e-04;
  a10=(a10*a00);
  a10=(a10+a03);
  if (res[0]!=0) res[0][30]=a10;
  a24=(-a24);
  if (res[0]!=0) res[0][31]=a24;
  a15=(-a15);
  if (res[0]!=0) res[0][32]=a15;
  a16=(-a16);
  if (res[0]!=0) res[0][33]=a16;
  a26=(-a26);
  if (res[0]!=0) res[0][34]=a26;
  if (res[0]!=0) res[0][35]=a07;
  a21=(a21*a05);
  a21=(-a21);
  if (res[0]!=0) res[0][36]=a21;
  a10=(a10+a03);
  a10=(-a10);
  if (res[0]!=0) res[0][37]=a10;
  a22=(-a22);
  if (res[0]!=0) res[0][38]=a22;
  a13=(-a13);
  if (res[0]!=0) res[0][39]=a13;
  a14=(-a14);
  if (res[0]!=0) res[0][40]=a14;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_F_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_F_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_F_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_F_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_F_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_F_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int va_F_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_F_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_F_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_F_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_F";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_F_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_F_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_F_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_F_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



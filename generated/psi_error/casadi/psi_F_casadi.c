/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) psi_F_casadi__ ## ID
#endif

#include <math.h>
#include "../src/psi_math.h"
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
CASADI_SYMBOL_EXPORT void psi_F_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int psi_F_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int psi_F_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {33, 1, 1};

/* psi_F_casadi:(lon_lat_height[3],v_n[3],f_n[3])->(out_F[33]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21;
  a00=arg[1]? arg[1][2] : 0;
  a01=1.;
  a02=arg[0]? arg[0][2] : 0;
  a03=6378137.;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][1] : 0;
  a06=sin(a05);
  a07=(a06*a06);
  a08=(a04*a07);
  a08=(a01-a08);
  a09=sqrt(a08);
  a10=(a01/a09);
  a03=(a03*a10);
  a11=(a02+a03);
  a12=(a01/a11);
  a13=(a00*a12);
  a14=arg[1]? arg[1][1] : 0;
  a15=6.3354393272928204e+06;
  a09=(a08*a09);
  a15=(a15/a09);
  a09=(a02+a15);
  a16=(a01/a09);
  a17=(a14*a16);
  a05=cos(a05);
  a18=(a05*a06);
  a08=(a01/a08);
  a19=(a18*a08);
  a03=(a19*a03);
  a03=(a04*a03);
  a03=(a03*a12);
  a20=(a01/a05);
  a21=(a06*a20);
  a03=(a03-a21);
  a03=(a17*a03);
  a13=(a13+a03);
  a13=(-a13);
  if (res[0]!=0) res[0][0]=a13;
  a20=(a12*a20);
  a13=(a20*a09);
  a03=arg[1]? arg[1][0] : 0;
  a03=(a03*a12);
  a21=(a21*a03);
  a13=(a13*a21);
  if (res[0]!=0) res[0][1]=a13;
  a13=(a20*a03);
  a13=(-a13);
  if (res[0]!=0) res[0][2]=a13;
  if (res[0]!=0) res[0][3]=a20;
  a11=(a05*a11);
  a20=(a11*a16);
  a20=(a20*a21);
  a20=(-a20);
  if (res[0]!=0) res[0][4]=a20;
  a00=(a00*a16);
  a20=2.0083139970423949e-02;
  a19=(a19*a15);
  a20=(a20*a19);
  a20=(a14*a20);
  a09=(a09*a09);
  a20=(a20/a09);
  a00=(a00+a20);
  a00=(-a00);
  if (res[0]!=0) res[0][5]=a00;
  a00=(a17*a16);
  a00=(-a00);
  if (res[0]!=0) res[0][6]=a00;
  if (res[0]!=0) res[0][7]=a16;
  a11=(a11*a03);
  if (res[0]!=0) res[0][8]=a11;
  if (res[0]!=0) res[0][9]=a14;
  if (res[0]!=0) res[0][10]=a01;
  a14=7.3745167729419953e-14;
  a11=(a02*a02);
  a14=(a14*a11);
  a01=(a01+a14);
  a14=1.5678559428873979e-07;
  a11=2.0136051943431768e+00;
  a16=1.3411242658989924e-02;
  a16=(a16*a07);
  a11=(a11-a16);
  a11=(a02*a11);
  a14=(a14*a11);
  a01=(a01-a14);
  a14=9.7803253359000006e+00;
  a11=1.8894147482439335e-02;
  a11=(a11*a07);
  a11=(a14+a11);
  a11=(a11*a10);
  a16=(a01*a11);
  a00=(a05*a16);
  a00=(-a00);
  if (res[0]!=0) res[0][11]=a00;
  a00=1.4584230000000000e-04;
  a20=(a00*a06);
  a20=(a20+a21);
  if (res[0]!=0) res[0][12]=a20;
  a00=(a00*a05);
  a00=(a00+a03);
  a09=(-a00);
  if (res[0]!=0) res[0][13]=a09;
  a09=arg[2]? arg[2][2] : 0;
  a19=(-a09);
  if (res[0]!=0) res[0][14]=a19;
  a19=arg[2]? arg[2][1] : 0;
  if (res[0]!=0) res[0][15]=a19;
  a16=(-a16);
  if (res[0]!=0) res[0][16]=a16;
  a20=(-a20);
  if (res[0]!=0) res[0][17]=a20;
  a20=(-a17);
  if (res[0]!=0) res[0][18]=a20;
  if (res[0]!=0) res[0][19]=a09;
  a09=arg[2]? arg[2][0] : 0;
  a16=(-a09);
  if (res[0]!=0) res[0][20]=a16;
  a16=4.2053793008804680e-09;
  a15=(a18*a02);
  a15=(a15*a11);
  a16=(a16*a15);
  a18=(a18*a10);
  a18=(a18*a01);
  a01=3.8637053131731361e-03;
  a10=1.2932555768154467e-05;
  a10=(a10*a07);
  a04=(a04+a10);
  a04=(a04*a08);
  a01=(a01+a04);
  a18=(a18*a01);
  a14=(a14*a18);
  a16=(a16+a14);
  a16=(-a16);
  if (res[0]!=0) res[0][21]=a16;
  a16=1.4749033545883991e-13;
  a16=(a16*a02);
  a02=2.1026896504402340e-09;
  a02=(a02*a07);
  a16=(a16+a02);
  a02=3.1570428705798834e-07;
  a16=(a16-a02);
  a16=(a16*a11);
  a16=(-a16);
  if (res[0]!=0) res[0][22]=a16;
  if (res[0]!=0) res[0][23]=a00;
  if (res[0]!=0) res[0][24]=a17;
  a19=(-a19);
  if (res[0]!=0) res[0][25]=a19;
  if (res[0]!=0) res[0][26]=a09;
  a09=7.2921149999999999e-05;
  a06=(a09*a06);
  a21=(a21+a06);
  if (res[0]!=0) res[0][27]=a21;
  a09=(a09*a05);
  a03=(a03+a09);
  a09=(-a03);
  if (res[0]!=0) res[0][28]=a09;
  a21=(-a21);
  if (res[0]!=0) res[0][29]=a21;
  if (res[0]!=0) res[0][30]=a20;
  if (res[0]!=0) res[0][31]=a03;
  if (res[0]!=0) res[0][32]=a17;
  return 0;
}

CASADI_SYMBOL_EXPORT int psi_F_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int psi_F_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void psi_F_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void psi_F_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void psi_F_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int psi_F_casadi_n_in(void) { return 3;}

CASADI_SYMBOL_EXPORT casadi_int psi_F_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real psi_F_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* psi_F_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "f_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* psi_F_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_F";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* psi_F_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* psi_F_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int psi_F_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int psi_F_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



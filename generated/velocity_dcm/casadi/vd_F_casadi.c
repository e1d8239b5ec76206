/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_F_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vd_math.h"
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
CASADI_SYMBOL_EXPORT void vd_F_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_F_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_F_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {18, 1, 1};

/* vd_F_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],f_b[3])->(out_F[18]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[0]? arg[0][2] : 0;
  a02=6378137.;
  a03=1.;
  a04=6.6943799901413173e-03;
  a05=arg[0]? arg[0][1] : 0;
  a06=sin(a05);
  a07=casadi_sq(a06);
  a04=(a04*a07);
  a03=(a03-a04);
  a04=sqrt(a03);
  a02=(a02/a04);
  a02=(a01+a02);
  a00=(a00/a02);
  a05=cos(a05);
  a02=(a06/a05);
  a02=(a00*a02);
  a07=1.4584230000000000e-04;
  a08=(a07*a06);
  a08=(a02+a08);
  if (res[0]!=0) res[0][0]=a08;
  a07=(a07*a05);
  a07=(a00+a07);
  a09=(-a07);
  if (res[0]!=0) res[0][1]=a09;
  a09=arg[3]? arg[3][0] : 0;
  a10=arg[2]? arg[2][1] : 0;
  a11=arg[2]? arg[2][3] : 0;
  a12=(a10*a11);
  a12=(2.*a12);
  a13=arg[2]? arg[2][0] : 0;
  a14=(2.*a13);
  a15=arg[2]? arg[2][2] : 0;
  a16=(a14*a15);
  a17=(a12-a16);
  a17=(a09*a17);
  a18=arg[3]? arg[3][1] : 0;
  a19=(a14*a10);
  a20=(2.*a11);
  a20=(a20*a15);
  a21=(a19+a20);
  a21=(a18*a21);
  a17=(a17+a21);
  a21=arg[3]? arg[3][2] : 0;
  a22=casadi_sq(a11);
  a23=casadi_sq(a15);
  a24=(a22-a23);
  a13=casadi_sq(a13);
  a25=casadi_sq(a10);
  a26=(a13-a25);
  a24=(a24+a26);
  a24=(a21*a24);
  a17=(a17+a24);
  a24=(-a17);
  if (res[0]!=0) res[0][2]=a24;
  a14=(a14*a11);
  a10=(a10*a15);
  a10=(2.*a10);
  a15=(a14+a10);
  a15=(a09*a15);
  a26=(a23+a26);
  a26=(a26-a22);
  a26=(a18*a26);
  a15=(a15+a26);
  a20=(a20-a19);
  a20=(a21*a20);
  a15=(a15+a20);
  if (res[0]!=0) res[0][3]=a15;
  a08=(-a08);
  if (res[0]!=0) res[0][4]=a08;
  a08=arg[1]? arg[1][1] : 0;
  a20=6.3354393272928204e+06;
  a03=(a03*a04);
  a20=(a20/a03);
  a01=(a01+a20);
  a08=(a08/a01);
  a01=(-a08);
  if (res[0]!=0) res[0][5]=a01;
  if (res[0]!=0) res[0][6]=a17;
  a13=(a13-a23);
  a13=(a13+a25);
  a13=(a13-a22);
  a09=(a09*a13);
  a10=(a10-a14);
  a18=(a18*a10);
  a09=(a09+a18);
  a16=(a16+a12);
  a21=(a21*a16);
  a09=(a09+a21);
  a21=(-a09);
  if (res[0]!=0) res[0][7]=a21;
  if (res[0]!=0) res[0][8]=a07;
  if (res[0]!=0) res[0][9]=a08;
  a15=(-a15);
  if (res[0]!=0) res[0][10]=a15;
  if (res[0]!=0) res[0][11]=a09;
  a09=7.2921149999999999e-05;
  a06=(a09*a06);
  a02=(a02+a06);
  if (res[0]!=0) res[0][12]=a02;
  a09=(a09*a05);
  a00=(a00+a09);
  a09=(-a00);
  if (res[0]!=0) res[0][13]=a09;
  a02=(-a02);
  if (res[0]!=0) res[0][14]=a02;
  if (res[0]!=0) res[0][15]=a01;
  if (res[0]!=0) res[0][16]=a00;
  if (res[0]!=0) res[0][17]=a08;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_F_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_F_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_F_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_F_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_F_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_F_casadi_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int vd_F_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_F_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_F_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_F_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_F";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_F_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_F_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_F_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_F_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



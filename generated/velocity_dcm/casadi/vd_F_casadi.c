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
  a00=1.4584230000000000e-04;
  a01=arg[0]? arg[0][1] : 0;
  a02=sin(a01);
  a03=(a00*a02);
  a04=arg[1]? arg[1][0] : 0;
  a05=arg[0]? arg[0][2] : 0;
  a06=6378137.;
  a07=1.;
  a08=6.6943799901413173e-03;
  a09=casadi_sq(a02);
  a08=(a08*a09);
  a07=(a07-a08);
  a08=sqrt(a07);
  a06=(a06/a08);
  a06=(a05+a06);
  a04=(a04/a06);
  a01=cos(a01);
  a06=(a02/a01);
  a06=(a04*a06);
  a03=(a03+a06);
  if (res[0]!=0) res[0][0]=a03;
  a00=(a00*a01);
  a00=(a00+a04);
  a09=(-a00);
  if (res[0]!=0) res[0][1]=a09;
  a09=arg[3]? arg[3][0] : 0;
  a10=arg[2]? arg[2][1] : 0;
  a11=(2.*a10);
  a12=arg[2]? arg[2][3] : 0;
  a13=(a11*a12);
  a14=arg[2]? arg[2][0] : 0;
  a15=(2.*a14);
  a16=arg[2]? arg[2][2] : 0;
  a17=(a15*a16);
  a18=(a13-a17);
  a18=(a09*a18);
  a19=arg[3]? arg[3][1] : 0;
  a20=(a15*a10);
  a21=(2.*a12);
  a21=(a21*a16);
  a22=(a20+a21);
  a22=(a19*a22);
  a18=(a18+a22);
  a22=arg[3]? arg[3][2] : 0;
  a14=casadi_sq(a14);
  a10=casadi_sq(a10);
  a23=(a14-a10);
  a24=casadi_sq(a12);
  a25=(a23+a24);
  a26=casadi_sq(a16);
  a25=(a25-a26);
  a25=(a22*a25);
  a18=(a18+a25);
  a25=(-a18);
  if (res[0]!=0) res[0][2]=a25;
  a15=(a15*a12);
  a11=(a11*a16);
  a16=(a15+a11);
  a16=(a09*a16);
  a23=(a23-a24);
  a23=(a23+a26);
  a23=(a19*a23);
  a16=(a16+a23);
  a21=(a21-a20);
  a21=(a22*a21);
  a16=(a16+a21);
  if (res[0]!=0) res[0][3]=a16;
  a03=(-a03);
  if (res[0]!=0) res[0][4]=a03;
  a03=arg[1]? arg[1][1] : 0;
  a21=6.3354393272928204e+06;
  a07=(a07*a08);
  a21=(a21/a07);
  a05=(a05+a21);
  a03=(a03/a05);
  a05=(-a03);
  if (res[0]!=0) res[0][5]=a05;
  if (res[0]!=0) res[0][6]=a18;
  a14=(a14+a10);
  a14=(a14-a24);
  a14=(a14-a26);
  a09=(a09*a14);
  a11=(a11-a15);
  a19=(a19*a11);
  a09=(a09+a19);
  a17=(a17+a13);
  a22=(a22*a17);
  a09=(a09+a22);
  a22=(-a09);
  if (res[0]!=0) res[0][7]=a22;
  if (res[0]!=0) res[0][8]=a00;
  if (res[0]!=0) res[0][9]=a03;
  a16=(-a16);
  if (res[0]!=0) res[0][10]=a16;
  if (res[0]!=0) res[0][11]=a09;
  a09=7.2921149999999999e-05;
  a02=(a09*a02);
  a06=(a06+a02);
  if (res[0]!=0) res[0][12]=a06;
  a09=(a09*a01);
  a04=(a04+a09);
  a09=(-a04);
  if (res[0]!=0) res[0][13]=a09;
  a06=(-a06);
  if (res[0]!=0) res[0][14]=a06;
  if (res[0]!=0) res[0][15]=a05;
  if (res[0]!=0) res[0][16]=a04;
  if (res[0]!=0) res[0][17]=a03;
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



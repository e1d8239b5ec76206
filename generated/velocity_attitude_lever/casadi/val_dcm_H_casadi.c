/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_dcm_H_casadi__ ## ID
#endif

#include <math.h>
#include "../src/val_math.h"
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
CASADI_SYMBOL_EXPORT void val_dcm_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_dcm_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_dcm_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {15, 1, 1};

/* val_dcm_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3])->(out_H[15]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40;
  a00=-1.;
  if (res[0]!=0) res[0][0]=a00;
  a01=arg[3]? arg[3][0] : 0;
  a02=arg[2]? arg[2][1] : 0;
  a03=(a01*a02);
  a04=arg[3]? arg[3][2] : 0;
  a05=arg[2]? arg[2][3] : 0;
  a06=(a04*a05);
  a03=(a03+a06);
  a06=arg[3]? arg[3][1] : 0;
  a07=arg[2]? arg[2][0] : 0;
  a08=(a06*a07);
  a03=(a03-a08);
  a08=arg[3]? arg[3][3] : 0;
  a09=arg[2]? arg[2][2] : 0;
  a10=(a08*a09);
  a03=(a03-a10);
  a10=casadi_sq(a03);
  a11=(a01*a09);
  a12=(a08*a02);
  a11=(a11+a12);
  a12=(a06*a05);
  a11=(a11-a12);
  a12=(a04*a07);
  a11=(a11-a12);
  a12=casadi_sq(a11);
  a13=(a10-a12);
  a14=(a01*a07);
  a15=(a06*a02);
  a14=(a14+a15);
  a15=(a04*a09);
  a14=(a14+a15);
  a15=(a08*a05);
  a14=(a14+a15);
  a15=casadi_sq(a14);
  a01=(a01*a05);
  a06=(a06*a09);
  a01=(a01+a06);
  a04=(a04*a02);
  a01=(a01-a04);
  a08=(a08*a07);
  a01=(a01-a08);
  a08=casadi_sq(a01);
  a04=(a15-a08);
  a06=(a13+a04);
  if (res[0]!=0) res[0][1]=a06;
  a06=(2.*a03);
  a16=(a06*a11);
  a14=(2.*a14);
  a17=(a14*a01);
  a18=(a16-a17);
  if (res[0]!=0) res[0][2]=a18;
  a18=(a14*a11);
  a06=(a06*a01);
  a19=(a18+a06);
  if (res[0]!=0) res[0][3]=a19;
  a19=arg[1]? arg[1][1] : 0;
  a20=arg[0]? arg[0][2] : 0;
  a21=6378137.;
  a22=1.;
  a23=6.6943799901413173e-03;
  a24=arg[0]? arg[0][0] : 0;
  a25=sin(a24);
  a26=casadi_sq(a25);
  a23=(a23*a26);
  a22=(a22-a23);
  a23=sqrt(a22);
  a21=(a21/a23);
  a21=(a20+a21);
  a19=(a19/a21);
  a21=7.2921149999999999e-05;
  a24=cos(a24);
  a26=(a21*a24);
  a26=(a19+a26);
  a27=arg[4]? arg[4][0] : 0;
  a28=casadi_sq(a02);
  a29=casadi_sq(a09);
  a30=(a28-a29);
  a31=casadi_sq(a07);
  a32=casadi_sq(a05);
  a33=(a31-a32);
  a30=(a30+a33);
  a30=(a27*a30);
  a34=arg[4]? arg[4][1] : 0;
  a35=(2.*a02);
  a36=(a35*a09);
  a07=(2.*a07);
  a37=(a07*a05);
  a38=(a36-a37);
  a38=(a34*a38);
  a30=(a30+a38);
  a38=arg[4]? arg[4][2] : 0;
  a39=(a07*a09);
  a35=(a35*a05);
  a40=(a39+a35);
  a40=(a38*a40);
  a30=(a30+a40);
  a26=(a26-a30);
  if (res[0]!=0) res[0][4]=a26;
  if (res[0]!=0) res[0][5]=a00;
  a17=(a17+a16);
  if (res[0]!=0) res[0][6]=a17;
  a04=(a04-a13);
  if (res[0]!=0) res[0][7]=a04;
  a11=(2.*a11);
  a11=(a11*a01);
  a14=(a14*a03);
  a03=(a11-a14);
  if (res[0]!=0) res[0][8]=a03;
  a37=(a37+a36);
  a37=(a27*a37);
  a33=(a29+a33);
  a33=(a33-a28);
  a33=(a34*a33);
  a37=(a37+a33);
  a09=(2.*a09);
  a09=(a09*a05);
  a07=(a07*a02);
  a02=(a09-a07);
  a02=(a38*a02);
  a37=(a37+a02);
  a02=arg[1]? arg[1][0] : 0;
  a05=6.3354393272928204e+06;
  a22=(a22*a23);
  a05=(a05/a22);
  a20=(a20+a05);
  a02=(a02/a20);
  a37=(a37+a02);
  a37=(-a37);
  if (res[0]!=0) res[0][9]=a37;
  if (res[0]!=0) res[0][10]=a00;
  a06=(a06-a18);
  if (res[0]!=0) res[0][11]=a06;
  a14=(a14+a11);
  if (res[0]!=0) res[0][12]=a14;
  a12=(a12+a10);
  a15=(a15-a12);
  a15=(a15+a08);
  if (res[0]!=0) res[0][13]=a15;
  a35=(a35-a39);
  a27=(a27*a35);
  a07=(a07+a09);
  a34=(a34*a07);
  a27=(a27+a34);
  a31=(a31-a29);
  a31=(a31+a32);
  a31=(a31-a28);
  a38=(a38*a31);
  a27=(a27+a38);
  a24=(a25/a24);
  a19=(a19*a24);
  a21=(a21*a25);
  a19=(a19+a21);
  a27=(a27+a19);
  a27=(-a27);
  if (res[0]!=0) res[0][14]=a27;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_dcm_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_dcm_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_dcm_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_dcm_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_dcm_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_dcm_H_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int val_dcm_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real val_dcm_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_dcm_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_dcm_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_dcm_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_dcm_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_dcm_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_dcm_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



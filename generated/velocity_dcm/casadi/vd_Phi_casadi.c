/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vd_Phi_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vd_Phi_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vd_Phi_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vd_Phi_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {31, 1, 1};

/* vd_Phi_casadi:(lon_lat_height[3],v_n[3],q_b2n_wxyz[4],f_b[3],dt)->(out_Phi[31]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31;
  a00=1.;
  a01=1.4584230000000000e-04;
  a02=arg[0]? arg[0][1] : 0;
  a03=sin(a02);
  a04=(a01*a03);
  a05=arg[1]? arg[1][0] : 0;
  a06=arg[0]? arg[0][2] : 0;
  a07=6378137.;
  a08=6.6943799901413173e-03;
  a09=(a03*a03);
  a08=(a08*a09);
  a08=(a00-a08);
  a09=sqrt(a08);
  a07=(a07/a09);
  a07=(a06+a07);
  a05=(a05/a07);
  a02=cos(a02);
  a07=(a03/a02);
  a07=(a05*a07);
  a04=(a04+a07);
  a10=arg[4]? arg[4][0] : 0;
  a04=(a04*a10);
  a11=(a04*a04);
  a01=(a01*a02);
  a01=(a01+a05);
  a01=(a01*a10);
  a12=(a01*a01);
  a13=(a11+a12);
  a14=5.0000000000000000e-01;
  a13=(a13*a14);
  a13=(a00-a13);
  if (res[0]!=0) res[0][0]=a13;
  a13=arg[1]? arg[1][1] : 0;
  a15=6.3354393272928204e+06;
  a08=(a08*a09);
  a15=(a15/a08);
  a06=(a06+a15);
  a13=(a13/a06);
  a13=(a13*a10);
  a06=(a13*a01);
  a06=(a06*a14);
  a15=(a04-a06);
  if (res[0]!=0) res[0][1]=a15;
  a15=(a13*a04);
  a15=(a15*a14);
  a08=(a01+a15);
  a08=(-a08);
  if (res[0]!=0) res[0][2]=a08;
  a08=arg[3]? arg[3][0] : 0;
  a09=2.;
  a16=arg[2]? arg[2][1] : 0;
  a17=(a09*a16);
  a18=arg[2]? arg[2][3] : 0;
  a19=(a17*a18);
  a20=arg[2]? arg[2][0] : 0;
  a21=(a09*a20);
  a22=arg[2]? arg[2][2] : 0;
  a23=(a21*a22);
  a24=(a19-a23);
  a24=(a08*a24);
  a25=arg[3]? arg[3][1] : 0;
  a26=(a21*a16);
  a09=(a09*a18);
  a09=(a09*a22);
  a27=(a26+a09);
  a27=(a25*a27);
  a24=(a24+a27);
  a27=arg[3]? arg[3][2] : 0;
  a20=(a20*a20);
  a16=(a16*a16);
  a28=(a20-a16);
  a29=(a18*a18);
  a30=(a28+a29);
  a31=(a22*a22);
  a30=(a30-a31);
  a30=(a27*a30);
  a24=(a24+a30);
  a24=(a24*a10);
  a30=(a04*a24);
  a21=(a21*a18);
  a17=(a17*a22);
  a22=(a21+a17);
  a22=(a08*a22);
  a28=(a28-a29);
  a28=(a28+a31);
  a28=(a25*a28);
  a22=(a22+a28);
  a09=(a09-a26);
  a09=(a27*a09);
  a22=(a22+a09);
  a22=(a22*a10);
  a09=(a01*a22);
  a26=(a30+a09);
  a28=7.2921149999999999e-05;
  a03=(a28*a03);
  a07=(a07+a03);
  a07=(a07*a10);
  a03=(a24*a07);
  a26=(a26+a03);
  a28=(a28*a02);
  a05=(a05+a28);
  a05=(a05*a10);
  a28=(a22*a05);
  a26=(a26+a28);
  a26=(a26*a14);
  if (res[0]!=0) res[0][3]=a26;
  a26=(a13*a22);
  a20=(a20+a16);
  a20=(a20-a29);
  a20=(a20-a31);
  a08=(a08*a20);
  a17=(a17-a21);
  a25=(a25*a17);
  a08=(a08+a25);
  a23=(a23+a19);
  a27=(a27*a23);
  a08=(a08+a27);
  a08=(a08*a10);
  a10=(a01*a08);
  a10=(a26-a10);
  a10=(a10*a14);
  a10=(a10-a24);
  if (res[0]!=0) res[0][4]=a10;
  a10=(a13*a24);
  a27=(a04*a08);
  a27=(a10-a27);
  a27=(a27*a14);
  a27=(a22+a27);
  if (res[0]!=0) res[0][5]=a27;
  a06=(a04+a06);
  a06=(-a06);
  if (res[0]!=0) res[0][6]=a06;
  a06=(a13*a13);
  a11=(a11+a06);
  a11=(a11*a14);
  a11=(a00-a11);
  if (res[0]!=0) res[0][7]=a11;
  a11=(a01*a04);
  a11=(a11*a14);
  a27=(a11-a13);
  if (res[0]!=0) res[0][8]=a27;
  a27=(a08*a05);
  a26=(a26-a27);
  a26=(a26*a14);
  a26=(a24+a26);
  if (res[0]!=0) res[0][9]=a26;
  a26=(a13*a08);
  a30=(a30-a26);
  a30=(a30+a03);
  a30=(a30-a26);
  a30=(a30*a14);
  if (res[0]!=0) res[0][10]=a30;
  a04=(a04*a22);
  a30=(a24*a05);
  a04=(a04+a30);
  a04=(a04*a14);
  a04=(a08+a04);
  a04=(-a04);
  if (res[0]!=0) res[0][11]=a04;
  a15=(a01-a15);
  if (res[0]!=0) res[0][12]=a15;
  a11=(a13+a11);
  if (res[0]!=0) res[0][13]=a11;
  a12=(a12+a06);
  a12=(a12*a14);
  a12=(a00-a12);
  if (res[0]!=0) res[0][14]=a12;
  a12=(a08*a07);
  a10=(a10-a12);
  a10=(a10*a14);
  a10=(a10-a22);
  if (res[0]!=0) res[0][15]=a10;
  a01=(a01*a24);
  a22=(a22*a07);
  a01=(a01+a22);
  a01=(a01*a14);
  a08=(a08-a01);
  if (res[0]!=0) res[0][16]=a08;
  a09=(a09-a26);
  a09=(a09+a28);
  a09=(a09-a26);
  a09=(a09*a14);
  if (res[0]!=0) res[0][17]=a09;
  a09=(a07*a07);
  a26=(a05*a05);
  a28=(a09+a26);
  a28=(a28*a14);
  a28=(a00-a28);
  if (res[0]!=0) res[0][18]=a28;
  a28=(a13*a05);
  a28=(a28*a14);
  a08=(a07-a28);
  if (res[0]!=0) res[0][19]=a08;
  a08=(a13*a07);
  a08=(a08*a14);
  a01=(a05+a08);
  a01=(-a01);
  if (res[0]!=0) res[0][20]=a01;
  a28=(a07+a28);
  a28=(-a28);
  if (res[0]!=0) res[0][21]=a28;
  a09=(a09+a06);
  a09=(a09*a14);
  a09=(a00-a09);
  if (res[0]!=0) res[0][22]=a09;
  a07=(a05*a07);
  a07=(a07*a14);
  a09=(a07-a13);
  if (res[0]!=0) res[0][23]=a09;
  a05=(a05-a08);
  if (res[0]!=0) res[0][24]=a05;
  a13=(a13+a07);
  if (res[0]!=0) res[0][25]=a13;
  a26=(a26+a06);
  a26=(a26*a14);
  a26=(a00-a26);
  if (res[0]!=0) res[0][26]=a26;
  if (res[0]!=0) res[0][27]=a00;
  if (res[0]!=0) res[0][28]=a00;
  if (res[0]!=0) res[0][29]=a00;
  if (res[0]!=0) res[0][30]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_Phi_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vd_Phi_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vd_Phi_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vd_Phi_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vd_Phi_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vd_Phi_casadi_n_in(void) { return 5;}

CASADI_SYMBOL_EXPORT casadi_int vd_Phi_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vd_Phi_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_Phi_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lon_lat_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "f_b";
    case 4: return "dt";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vd_Phi_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_Phi";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_Phi_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vd_Phi_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vd_Phi_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vd_Phi_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 5*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



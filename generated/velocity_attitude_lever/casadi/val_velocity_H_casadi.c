/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_velocity_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void val_velocity_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_velocity_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_velocity_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {33, 1, 1};

/* val_velocity_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],omega_ib_b[3],lever_b[3],a_n[3])->(out_H[33]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37;
  a00=arg[4]? arg[4][0] : 0;
  a01=arg[2]? arg[2][1] : 0;
  a02=(2.*a01);
  a03=arg[2]? arg[2][3] : 0;
  a04=(a02*a03);
  a05=arg[2]? arg[2][0] : 0;
  a06=(2.*a05);
  a07=arg[2]? arg[2][2] : 0;
  a08=(a06*a07);
  a09=(a04-a08);
  a10=(a00*a09);
  a11=arg[4]? arg[4][1] : 0;
  a12=(a06*a01);
  a13=(2.*a03);
  a13=(a13*a07);
  a14=(a12+a13);
  a15=(a11*a14);
  a10=(a10+a15);
  a15=arg[4]? arg[4][2] : 0;
  a05=casadi_sq(a05);
  a01=casadi_sq(a01);
  a16=(a05-a01);
  a17=casadi_sq(a03);
  a18=(a16+a17);
  a19=casadi_sq(a07);
  a18=(a18-a19);
  a20=(a15*a18);
  a10=(a10+a20);
  a20=arg[1]? arg[1][1] : 0;
  a21=arg[0]? arg[0][2] : 0;
  a22=6378137.;
  a23=1.;
  a24=6.6943799901413173e-03;
  a25=arg[0]? arg[0][0] : 0;
  a26=sin(a25);
  a27=casadi_sq(a26);
  a24=(a24*a27);
  a24=(a23-a24);
  a27=sqrt(a24);
  a22=(a22/a27);
  a22=(a21+a22);
  a20=(a20/a22);
  a25=cos(a25);
  a22=(a26/a25);
  a22=(a20*a22);
  a28=7.2921149999999999e-05;
  a26=(a28*a26);
  a22=(a22+a26);
  a26=(a10*a22);
  a06=(a06*a03);
  a02=(a02*a07);
  a07=(a06+a02);
  a03=(a00*a07);
  a16=(a16-a17);
  a16=(a16+a19);
  a29=(a11*a16);
  a03=(a03+a29);
  a13=(a13-a12);
  a12=(a15*a13);
  a03=(a03+a12);
  a12=arg[1]? arg[1][0] : 0;
  a29=6.3354393272928204e+06;
  a24=(a24*a27);
  a29=(a29/a24);
  a21=(a21+a29);
  a12=(a12/a21);
  a21=(a03*a12);
  a29=(a26+a21);
  if (res[0]!=0) res[0][0]=a29;
  a29=arg[3]? arg[3][2] : 0;
  a24=(a29*a14);
  a27=arg[3]? arg[3][1] : 0;
  a30=(a27*a18);
  a24=(a24-a30);
  a30=(a24*a00);
  a31=arg[3]? arg[3][0] : 0;
  a32=(a31*a18);
  a33=(a29*a09);
  a32=(a32-a33);
  a33=(a32*a11);
  a30=(a30+a33);
  a33=(a27*a09);
  a34=(a31*a14);
  a33=(a33-a34);
  a34=(a33*a15);
  a30=(a30+a34);
  a05=(a05+a01);
  a05=(a05-a17);
  a05=(a05-a19);
  a19=(a00*a05);
  a02=(a02-a06);
  a06=(a11*a02);
  a19=(a19+a06);
  a08=(a08+a04);
  a04=(a15*a08);
  a19=(a19+a04);
  a04=(a19*a12);
  a04=(a30-a04);
  if (res[0]!=0) res[0][1]=a04;
  a04=(a19*a22);
  a06=(a29*a16);
  a17=(a27*a13);
  a06=(a06-a17);
  a17=(a06*a00);
  a01=(a31*a13);
  a34=(a29*a07);
  a01=(a01-a34);
  a34=(a01*a11);
  a17=(a17+a34);
  a34=(a27*a07);
  a35=(a31*a16);
  a34=(a34-a35);
  a35=(a34*a15);
  a17=(a17+a35);
  a04=(a04+a17);
  a04=(-a04);
  if (res[0]!=0) res[0][2]=a04;
  if (res[0]!=0) res[0][3]=a23;
  a04=(a11*a08);
  a35=(a15*a02);
  a04=(a04-a35);
  if (res[0]!=0) res[0][4]=a04;
  a04=(a15*a05);
  a35=(a00*a08);
  a04=(a04-a35);
  if (res[0]!=0) res[0][5]=a04;
  a04=(a00*a02);
  a35=(a11*a05);
  a04=(a04-a35);
  if (res[0]!=0) res[0][6]=a04;
  a04=arg[5]? arg[5][0] : 0;
  a04=(-a04);
  if (res[0]!=0) res[0][7]=a04;
  a04=(a07*a22);
  a35=(a09*a12);
  a36=(a29*a02);
  a37=(a27*a08);
  a36=(a36-a37);
  a35=(a35+a36);
  a04=(a04-a35);
  if (res[0]!=0) res[0][8]=a04;
  a04=(a16*a22);
  a35=(a14*a12);
  a37=(a31*a08);
  a29=(a29*a05);
  a37=(a37-a29);
  a35=(a35+a37);
  a04=(a04-a35);
  if (res[0]!=0) res[0][9]=a04;
  a04=(a13*a22);
  a35=(a18*a12);
  a27=(a27*a05);
  a31=(a31*a02);
  a27=(a27-a31);
  a35=(a35+a27);
  a04=(a04-a35);
  if (res[0]!=0) res[0][10]=a04;
  a28=(a28*a25);
  a20=(a20+a28);
  a28=(a03*a20);
  a28=(a28-a30);
  if (res[0]!=0) res[0][11]=a28;
  a19=(a19*a20);
  a26=(a26-a19);
  if (res[0]!=0) res[0][12]=a26;
  a36=(a36*a00);
  a37=(a37*a11);
  a36=(a36+a37);
  a27=(a27*a15);
  a36=(a36+a27);
  a03=(a03*a22);
  a03=(a36-a03);
  if (res[0]!=0) res[0][13]=a03;
  if (res[0]!=0) res[0][14]=a23;
  a03=(a11*a13);
  a27=(a15*a16);
  a03=(a03-a27);
  if (res[0]!=0) res[0][15]=a03;
  a03=(a15*a07);
  a27=(a00*a13);
  a03=(a03-a27);
  if (res[0]!=0) res[0][16]=a03;
  a03=(a00*a16);
  a27=(a11*a07);
  a03=(a03-a27);
  if (res[0]!=0) res[0][17]=a03;
  a03=arg[5]? arg[5][1] : 0;
  a03=(-a03);
  if (res[0]!=0) res[0][18]=a03;
  a03=(a05*a22);
  a03=(a03+a06);
  a06=(a09*a20);
  a03=(a03+a06);
  a03=(-a03);
  if (res[0]!=0) res[0][19]=a03;
  a03=(a02*a22);
  a03=(a03+a01);
  a01=(a14*a20);
  a03=(a03+a01);
  a03=(-a03);
  if (res[0]!=0) res[0][20]=a03;
  a22=(a08*a22);
  a22=(a22+a34);
  a34=(a18*a20);
  a22=(a22+a34);
  a22=(-a22);
  if (res[0]!=0) res[0][21]=a22;
  a22=(a10*a20);
  a22=(a22+a17);
  if (res[0]!=0) res[0][22]=a22;
  a10=(a10*a12);
  a10=(a10+a36);
  a10=(-a10);
  if (res[0]!=0) res[0][23]=a10;
  a21=(a21-a19);
  if (res[0]!=0) res[0][24]=a21;
  if (res[0]!=0) res[0][25]=a23;
  a23=(a11*a18);
  a21=(a15*a14);
  a23=(a23-a21);
  if (res[0]!=0) res[0][26]=a23;
  a15=(a15*a09);
  a18=(a00*a18);
  a15=(a15-a18);
  if (res[0]!=0) res[0][27]=a15;
  a00=(a00*a14);
  a11=(a11*a09);
  a00=(a00-a11);
  if (res[0]!=0) res[0][28]=a00;
  a00=arg[5]? arg[5][2] : 0;
  a00=(-a00);
  if (res[0]!=0) res[0][29]=a00;
  a07=(a07*a20);
  a07=(a07-a24);
  a05=(a05*a12);
  a07=(a07+a05);
  if (res[0]!=0) res[0][30]=a07;
  a16=(a16*a20);
  a16=(a16-a32);
  a02=(a02*a12);
  a16=(a16+a02);
  if (res[0]!=0) res[0][31]=a16;
  a13=(a13*a20);
  a13=(a13-a33);
  a08=(a08*a12);
  a13=(a13+a08);
  if (res[0]!=0) res[0][32]=a13;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_velocity_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_velocity_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_velocity_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_velocity_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_velocity_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_velocity_H_casadi_n_in(void) { return 6;}

CASADI_SYMBOL_EXPORT casadi_int val_velocity_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real val_velocity_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_velocity_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "omega_ib_b";
    case 4: return "lever_b";
    case 5: return "a_n";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_velocity_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_velocity_H_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s0;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_velocity_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_velocity_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_velocity_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_velocity_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void va_velocity_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_velocity_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_velocity_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {24, 1, 1};

/* va_velocity_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],omega_ib_b[3],lever_b[3],a_n[3])->(out_H[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34;
  a00=7.2921149999999999e-05;
  a01=arg[0]? arg[0][0] : 0;
  a02=sin(a01);
  a03=(a00*a02);
  a04=arg[1]? arg[1][1] : 0;
  a05=arg[0]? arg[0][2] : 0;
  a06=6378137.;
  a07=1.;
  a08=6.6943799901413173e-03;
  a09=(a02*a02);
  a08=(a08*a09);
  a08=(a07-a08);
  a09=sqrt(a08);
  a06=(a06/a09);
  a06=(a05+a06);
  a04=(a04/a06);
  a01=cos(a01);
  a02=(a02/a01);
  a02=(a04*a02);
  a03=(a03+a02);
  a02=2.;
  a06=arg[2]? arg[2][0] : 0;
  a10=(a02*a06);
  a11=arg[2]? arg[2][1] : 0;
  a12=(a10*a11);
  a13=arg[2]? arg[2][3] : 0;
  a14=(a02*a13);
  a15=arg[2]? arg[2][2] : 0;
  a16=(a14*a15);
  a17=(a12+a16);
  a18=arg[4]? arg[4][1] : 0;
  a19=(a17*a18);
  a20=(a10*a15);
  a14=(a14*a11);
  a21=(a20-a14);
  a22=arg[4]? arg[4][0] : 0;
  a23=(a21*a22);
  a19=(a19-a23);
  a23=(a13*a13);
  a06=(a06*a06);
  a24=(a11*a11);
  a25=(a06-a24);
  a26=(a23+a25);
  a27=(a15*a15);
  a26=(a26-a27);
  a28=arg[4]? arg[4][2] : 0;
  a29=(a26*a28);
  a19=(a19+a29);
  a29=(a03*a19);
  a25=(a25-a23);
  a25=(a25+a27);
  a30=(a25*a18);
  a10=(a10*a13);
  a11=(a11*a15);
  a02=(a02*a11);
  a11=(a10+a02);
  a15=(a11*a22);
  a30=(a30+a15);
  a12=(a12-a16);
  a16=(a12*a28);
  a30=(a30-a16);
  a16=arg[1]? arg[1][0] : 0;
  a15=6.3354393272928204e+06;
  a08=(a08*a09);
  a15=(a15/a08);
  a05=(a05+a15);
  a05=(a07/a05);
  a15=(a16*a05);
  a08=(a30*a15);
  a09=(a29+a08);
  if (res[0]!=0) res[0][0]=a09;
  a09=arg[3]? arg[3][2] : 0;
  a13=(a17*a09);
  a31=arg[3]? arg[3][1] : 0;
  a32=(a26*a31);
  a13=(a13-a32);
  a13=(a22*a13);
  a32=arg[3]? arg[3][0] : 0;
  a33=(a26*a32);
  a34=(a21*a09);
  a33=(a33+a34);
  a33=(a18*a33);
  a13=(a13+a33);
  a33=(a21*a31);
  a34=(a17*a32);
  a33=(a33+a34);
  a33=(a28*a33);
  a13=(a13-a33);
  a20=(a20+a14);
  a14=(a20*a28);
  a10=(a10-a02);
  a02=(a10*a18);
  a14=(a14-a02);
  a06=(a06-a23);
  a06=(a06+a24);
  a06=(a06-a27);
  a27=(a06*a22);
  a14=(a14+a27);
  a15=(a15*a14);
  a15=(a13-a15);
  if (res[0]!=0) res[0][1]=a15;
  a15=(a03*a14);
  a27=(a25*a09);
  a24=(a12*a31);
  a27=(a27+a24);
  a27=(a22*a27);
  a24=(a12*a32);
  a23=(a11*a09);
  a24=(a24+a23);
  a24=(a18*a24);
  a27=(a27-a24);
  a24=(a11*a31);
  a23=(a25*a32);
  a24=(a24-a23);
  a24=(a28*a24);
  a27=(a27+a24);
  a15=(a15+a27);
  a15=(-a15);
  if (res[0]!=0) res[0][2]=a15;
  if (res[0]!=0) res[0][3]=a07;
  a15=(a10*a28);
  a24=(a20*a18);
  a15=(a15+a24);
  if (res[0]!=0) res[0][4]=a15;
  a15=(a06*a28);
  a24=(a20*a22);
  a15=(a15-a24);
  if (res[0]!=0) res[0][5]=a15;
  a15=(a06*a18);
  a24=(a10*a22);
  a15=(a15+a24);
  a15=(-a15);
  if (res[0]!=0) res[0][6]=a15;
  a15=arg[5]? arg[5][0] : 0;
  a15=(-a15);
  if (res[0]!=0) res[0][7]=a15;
  a00=(a00*a01);
  a04=(a04+a00);
  a00=(a30*a04);
  a00=(a00-a13);
  if (res[0]!=0) res[0][8]=a00;
  a14=(a14*a04);
  a29=(a29-a14);
  if (res[0]!=0) res[0][9]=a29;
  a29=(a20*a32);
  a00=(a06*a09);
  a29=(a29-a00);
  a29=(a18*a29);
  a09=(a10*a09);
  a20=(a20*a31);
  a09=(a09+a20);
  a09=(a22*a09);
  a29=(a29-a09);
  a06=(a06*a31);
  a10=(a10*a32);
  a06=(a06+a10);
  a06=(a28*a06);
  a29=(a29+a06);
  a30=(a30*a03);
  a30=(a29-a30);
  if (res[0]!=0) res[0][10]=a30;
  if (res[0]!=0) res[0][11]=a07;
  a30=(a25*a28);
  a03=(a12*a18);
  a30=(a30+a03);
  a30=(-a30);
  if (res[0]!=0) res[0][12]=a30;
  a12=(a12*a22);
  a30=(a11*a28);
  a12=(a12+a30);
  if (res[0]!=0) res[0][13]=a12;
  a25=(a25*a22);
  a11=(a11*a18);
  a25=(a25-a11);
  if (res[0]!=0) res[0][14]=a25;
  a25=arg[5]? arg[5][1] : 0;
  a25=(-a25);
  if (res[0]!=0) res[0][15]=a25;
  a04=(a19*a04);
  a27=(a27+a04);
  if (res[0]!=0) res[0][16]=a27;
  a19=(a19*a05);
  a19=(a19*a16);
  a19=(a19+a29);
  a19=(-a19);
  if (res[0]!=0) res[0][17]=a19;
  a08=(a08-a14);
  if (res[0]!=0) res[0][18]=a08;
  if (res[0]!=0) res[0][19]=a07;
  a07=(a26*a18);
  a08=(a17*a28);
  a07=(a07-a08);
  if (res[0]!=0) res[0][20]=a07;
  a26=(a26*a22);
  a28=(a21*a28);
  a26=(a26+a28);
  a26=(-a26);
  if (res[0]!=0) res[0][21]=a26;
  a21=(a21*a18);
  a17=(a17*a22);
  a21=(a21+a17);
  if (res[0]!=0) res[0][22]=a21;
  a21=arg[5]? arg[5][2] : 0;
  a21=(-a21);
  if (res[0]!=0) res[0][23]=a21;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_velocity_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_velocity_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_velocity_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_velocity_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_velocity_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_velocity_H_casadi_n_in(void) { return 6;}

CASADI_SYMBOL_EXPORT casadi_int va_velocity_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_velocity_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_velocity_H_casadi_name_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const char* va_velocity_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_velocity_H_casadi_sparsity_in(casadi_int i) {
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

CASADI_SYMBOL_EXPORT const casadi_int* va_velocity_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_velocity_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_velocity_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 6*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



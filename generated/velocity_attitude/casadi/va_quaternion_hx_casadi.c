/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_quaternion_h_casadi__ ## ID
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
#define casadi_s3 CASADI_PREFIX(s3)
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
CASADI_SYMBOL_EXPORT void va_quaternion_h_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_quaternion_h_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_quaternion_h_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {16, 1, 1};
static const casadi_int casadi_s1[3] = {3, 1, 1};
static const casadi_int casadi_s2[3] = {4, 1, 1};
static const casadi_int casadi_s3[3] = {1, 1, 1};

/* va_quaternion_h_casadi:(x[16],lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag)->(out_h[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41;
  a00=arg[4]? arg[4][0] : 0;
  a01=arg[3]? arg[3][1] : 0;
  a02=(a00*a01);
  a03=arg[4]? arg[4][2] : 0;
  a04=arg[3]? arg[3][3] : 0;
  a05=(a03*a04);
  a02=(a02+a05);
  a05=arg[4]? arg[4][1] : 0;
  a06=arg[3]? arg[3][0] : 0;
  a07=(a05*a06);
  a02=(a02-a07);
  a07=arg[4]? arg[4][3] : 0;
  a08=arg[3]? arg[3][2] : 0;
  a09=(a07*a08);
  a02=(a02-a09);
  a09=5.0000000000000000e-01;
  a10=1.0000000000000001e-30;
  a11=arg[7]? arg[7][0] : 0;
  a12=casadi_sq(a11);
  a13=arg[2]? arg[2][0] : 0;
  a14=arg[1]? arg[1][2] : 0;
  a15=6.3354393272928204e+06;
  a16=1.;
  a17=6.6943799901413173e-03;
  a18=arg[1]? arg[1][0] : 0;
  a19=sin(a18);
  a20=casadi_sq(a19);
  a17=(a17*a20);
  a16=(a16-a17);
  a17=sqrt(a16);
  a16=(a16*a17);
  a15=(a15/a16);
  a15=(a14+a15);
  a13=(a13/a15);
  a15=arg[5]? arg[5][0] : 0;
  a16=(2.*a06);
  a20=(a16*a04);
  a21=(2.*a08);
  a21=(a21*a01);
  a22=(a20+a21);
  a22=(a15*a22);
  a22=(a13+a22);
  a23=arg[5]? arg[5][1] : 0;
  a24=casadi_sq(a06);
  a25=casadi_sq(a01);
  a26=(a24-a25);
  a27=casadi_sq(a04);
  a28=(a26-a27);
  a29=casadi_sq(a08);
  a28=(a28+a29);
  a28=(a23*a28);
  a22=(a22+a28);
  a28=arg[5]? arg[5][2] : 0;
  a30=(a08*a04);
  a30=(2.*a30);
  a31=(a16*a01);
  a32=(a30-a31);
  a32=(a28*a32);
  a22=(a22+a32);
  a32=casadi_sq(a22);
  a32=(a12*a32);
  a32=(a10+a32);
  a24=(a24-a27);
  a24=(a24+a25);
  a24=(a24-a29);
  a24=(a15*a24);
  a25=7.2921149999999999e-05;
  a18=cos(a18);
  a33=(a25*a18);
  a34=arg[2]? arg[2][1] : 0;
  a35=6378137.;
  a35=(a35/a17);
  a14=(a14+a35);
  a34=(a34/a14);
  a33=(a33+a34);
  a24=(a24-a33);
  a21=(a21-a20);
  a21=(a23*a21);
  a24=(a24+a21);
  a16=(a16*a08);
  a21=(a01*a04);
  a21=(2.*a21);
  a20=(a16+a21);
  a20=(a28*a20);
  a24=(a24+a20);
  a20=casadi_sq(a24);
  a20=(a12*a20);
  a32=(a32+a20);
  a25=(a25*a19);
  a19=(a19/a18);
  a34=(a34*a19);
  a25=(a25+a34);
  a21=(a21-a16);
  a21=(a15*a21);
  a21=(a25+a21);
  a31=(a31+a30);
  a31=(a23*a31);
  a21=(a21+a31);
  a27=(a27+a26);
  a27=(a27-a29);
  a27=(a28*a27);
  a21=(a21+a27);
  a27=casadi_sq(a21);
  a12=(a12*a27);
  a32=(a32+a12);
  a32=sqrt(a32);
  a12=(a09*a32);
  a27=cos(a12);
  a29=(a02*a27);
  a12=sin(a12);
  a12=(a11*a12);
  a12=(a12/a32);
  a32=(a00*a06);
  a26=(a05*a01);
  a32=(a32+a26);
  a26=(a03*a08);
  a32=(a32+a26);
  a26=(a07*a04);
  a32=(a32+a26);
  a26=(a12*a32);
  a31=(a24*a26);
  a29=(a29-a31);
  a31=(a00*a04);
  a30=(a05*a08);
  a31=(a31+a30);
  a30=(a03*a01);
  a31=(a31-a30);
  a30=(a07*a06);
  a31=(a31-a30);
  a30=(a22*a12);
  a16=(a31*a30);
  a29=(a29-a16);
  a16=(a00*a08);
  a34=(a07*a01);
  a16=(a16+a34);
  a34=(a05*a04);
  a16=(a16-a34);
  a34=(a03*a06);
  a16=(a16-a34);
  a34=(a12*a16);
  a19=(a21*a34);
  a29=(a29+a19);
  a19=arg[6]? arg[6][1] : 0;
  a18=(a29*a19);
  a20=(a27*a31);
  a34=(a24*a34);
  a14=(a21*a26);
  a34=(a34+a14);
  a20=(a20-a34);
  a34=(a02*a30);
  a20=(a20+a34);
  a34=arg[6]? arg[6][3] : 0;
  a14=(a20*a34);
  a18=(a18+a14);
  a14=(a27*a16);
  a22=(a22*a26);
  a02=(a02*a12);
  a26=(a21*a02);
  a22=(a22+a26);
  a14=(a14-a22);
  a31=(a31*a12);
  a12=(a24*a31);
  a14=(a14+a12);
  a12=arg[6]? arg[6][2] : 0;
  a22=(a14*a12);
  a18=(a18+a22);
  a27=(a27*a32);
  a24=(a24*a02);
  a27=(a27+a24);
  a21=(a21*a31);
  a27=(a27+a21);
  a30=(a30*a16);
  a27=(a27+a30);
  a30=arg[6]? arg[6][0] : 0;
  a16=(a27*a30);
  a18=(a18+a16);
  a16=0.;
  a18=(a18<a16);
  a21=(!a18);
  a21=(a21-a18);
  a21=(2.*a21);
  a18=(a29*a30);
  a31=(a20*a12);
  a18=(a18+a31);
  a31=(a14*a34);
  a18=(a18-a31);
  a31=(a27*a19);
  a18=(a18-a31);
  a18=(a21*a18);
  a31=arg[0]? arg[0][15] : 0;
  a11=(a11-a31);
  a31=casadi_sq(a11);
  a24=arg[0]? arg[0][6] : 0;
  a24=(a24+a15);
  a15=arg[0]? arg[0][2] : 0;
  a02=casadi_sq(a15);
  a02=(a10+a02);
  a32=arg[0]? arg[0][1] : 0;
  a22=casadi_sq(a32);
  a02=(a02+a22);
  a22=arg[0]? arg[0][0] : 0;
  a26=casadi_sq(a22);
  a02=(a02+a26);
  a02=sqrt(a02);
  a26=(a09*a02);
  a35=cos(a26);
  a17=(a35*a04);
  a26=sin(a26);
  a26=(a26/a02);
  a02=(a26*a22);
  a36=(a02*a08);
  a17=(a17+a36);
  a36=(a26*a15);
  a37=(a36*a06);
  a17=(a17+a37);
  a37=(a26*a32);
  a38=(a37*a01);
  a17=(a17-a38);
  a38=(a35*a06);
  a04=(a26*a04);
  a39=(a04*a15);
  a38=(a38-a39);
  a39=(a02*a01);
  a38=(a38-a39);
  a26=(a26*a08);
  a39=(a26*a32);
  a38=(a38-a39);
  a39=(2.*a38);
  a40=(a17*a39);
  a41=(a35*a01);
  a32=(a04*a32);
  a41=(a41+a32);
  a02=(a02*a06);
  a41=(a41+a02);
  a26=(a26*a15);
  a41=(a41-a26);
  a35=(a35*a08);
  a36=(a36*a01);
  a35=(a35+a36);
  a37=(a37*a06);
  a35=(a35+a37);
  a04=(a04*a22);
  a35=(a35-a04);
  a04=(2.*a35);
  a22=(a41*a04);
  a37=(a40+a22);
  a37=(a24*a37);
  a13=(a13+a37);
  a37=arg[0]? arg[0][8] : 0;
  a37=(a37+a28);
  a04=(a17*a04);
  a28=(a41*a39);
  a06=(a04-a28);
  a06=(a37*a06);
  a13=(a13+a06);
  a06=arg[0]? arg[0][7] : 0;
  a06=(a06+a23);
  a23=casadi_sq(a41);
  a36=casadi_sq(a38);
  a01=(a23-a36);
  a08=casadi_sq(a17);
  a26=casadi_sq(a35);
  a15=(a08-a26);
  a01=(a01+a15);
  a01=(a06*a01);
  a13=(a13-a01);
  a01=casadi_sq(a13);
  a01=(a31*a01);
  a01=(a10+a01);
  a02=(a41*a17);
  a02=(2.*a02);
  a39=(a35*a39);
  a32=(a02+a39);
  a32=(a37*a32);
  a08=(a08-a36);
  a08=(a08+a26);
  a08=(a08-a23);
  a08=(a24*a08);
  a33=(a33+a08);
  a32=(a32-a33);
  a22=(a22-a40);
  a22=(a06*a22);
  a32=(a32+a22);
  a22=casadi_sq(a32);
  a22=(a31*a22);
  a01=(a01+a22);
  a02=(a02-a39);
  a24=(a24*a02);
  a25=(a25+a24);
  a36=(a36+a15);
  a36=(a36-a23);
  a37=(a37*a36);
  a25=(a25+a37);
  a04=(a04+a28);
  a06=(a06*a04);
  a25=(a25+a06);
  a06=casadi_sq(a25);
  a31=(a31*a06);
  a01=(a01+a31);
  a01=sqrt(a01);
  a31=(a09*a01);
  a06=cos(a31);
  a04=arg[0]? arg[0][12] : 0;
  a28=casadi_sq(a04);
  a10=(a10+a28);
  a28=arg[0]? arg[0][13] : 0;
  a37=casadi_sq(a28);
  a10=(a10+a37);
  a37=arg[0]? arg[0][14] : 0;
  a36=casadi_sq(a37);
  a10=(a10+a36);
  a10=sqrt(a10);
  a09=(a09*a10);
  a36=sin(a09);
  a36=(a36/a10);
  a04=(a36*a04);
  a10=(a04*a07);
  a09=cos(a09);
  a23=(a09*a03);
  a10=(a10-a23);
  a23=(a36*a37);
  a15=(a23*a05);
  a10=(a10-a15);
  a15=(a36*a28);
  a24=(a15*a00);
  a10=(a10-a24);
  a24=(a41*a10);
  a02=(a09*a00);
  a39=(a04*a05);
  a02=(a02-a39);
  a36=(a36*a07);
  a37=(a36*a37);
  a02=(a02-a37);
  a37=(a15*a03);
  a02=(a02-a37);
  a37=(a02*a17);
  a24=(a24+a37);
  a15=(a15*a05);
  a07=(a09*a07);
  a15=(a15-a07);
  a07=(a04*a03);
  a15=(a15-a07);
  a07=(a23*a00);
  a15=(a15-a07);
  a07=(a15*a38);
  a24=(a24+a07);
  a23=(a23*a03);
  a09=(a09*a05);
  a23=(a23-a09);
  a04=(a04*a00);
  a23=(a23-a04);
  a36=(a36*a28);
  a23=(a23-a36);
  a36=(a35*a23);
  a24=(a24-a36);
  a36=(a06*a24);
  a31=sin(a31);
  a11=(a11*a31);
  a11=(a11/a01);
  a01=(a02*a35);
  a31=(a17*a23);
  a01=(a01+a31);
  a31=(a10*a38);
  a01=(a01+a31);
  a31=(a41*a15);
  a01=(a01-a31);
  a31=(a11*a01);
  a28=(a32*a31);
  a04=(a02*a38);
  a00=(a41*a23);
  a04=(a04-a00);
  a00=(a35*a10);
  a04=(a04-a00);
  a00=(a15*a17);
  a04=(a04-a00);
  a00=(a11*a04);
  a09=(a25*a00);
  a28=(a28+a09);
  a36=(a36-a28);
  a41=(a41*a02);
  a35=(a35*a15);
  a41=(a41+a35);
  a23=(a23*a38);
  a41=(a41+a23);
  a17=(a17*a10);
  a41=(a41-a17);
  a17=(a13*a11);
  a10=(a41*a17);
  a36=(a36+a10);
  a10=(a36*a34);
  a23=(a06*a01);
  a38=(a41*a11);
  a35=(a38*a25);
  a13=(a13*a00);
  a35=(a35+a13);
  a23=(a23-a35);
  a11=(a24*a11);
  a35=(a11*a32);
  a23=(a23+a35);
  a35=(a23*a12);
  a10=(a10+a35);
  a04=(a06*a04);
  a11=(a11*a25);
  a04=(a04+a11);
  a38=(a38*a32);
  a04=(a04+a38);
  a01=(a17*a01);
  a04=(a04+a01);
  a01=(a04*a30);
  a10=(a10+a01);
  a41=(a41*a06);
  a32=(a32*a00);
  a41=(a41-a32);
  a24=(a24*a17);
  a41=(a41-a24);
  a25=(a25*a31);
  a41=(a41+a25);
  a25=(a41*a19);
  a10=(a10+a25);
  a10=(a10<a16);
  a16=(!a10);
  a16=(a16-a10);
  a16=(2.*a16);
  a10=(a36*a12);
  a25=(a41*a30);
  a10=(a10+a25);
  a25=(a23*a34);
  a10=(a10-a25);
  a25=(a04*a19);
  a10=(a10-a25);
  a10=(a16*a10);
  a18=(a18-a10);
  if (res[0]!=0) res[0][0]=a18;
  a18=(a29*a34);
  a10=(a14*a30);
  a18=(a18+a10);
  a10=(a20*a19);
  a18=(a18-a10);
  a10=(a27*a12);
  a18=(a18-a10);
  a18=(a21*a18);
  a10=(a23*a30);
  a25=(a41*a34);
  a10=(a10+a25);
  a25=(a36*a19);
  a10=(a10-a25);
  a25=(a04*a12);
  a10=(a10-a25);
  a10=(a16*a10);
  a18=(a18-a10);
  if (res[0]!=0) res[0][1]=a18;
  a20=(a20*a30);
  a14=(a14*a19);
  a20=(a20+a14);
  a29=(a29*a12);
  a20=(a20-a29);
  a27=(a27*a34);
  a20=(a20-a27);
  a21=(a21*a20);
  a36=(a36*a30);
  a23=(a23*a19);
  a36=(a36+a23);
  a04=(a04*a34);
  a36=(a36-a04);
  a41=(a41*a12);
  a36=(a36-a41);
  a16=(a16*a36);
  a21=(a21-a16);
  if (res[0]!=0) res[0][2]=a21;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_quaternion_h_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_quaternion_h_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_quaternion_h_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_quaternion_h_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_quaternion_h_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_quaternion_h_casadi_n_in(void) { return 8;}

CASADI_SYMBOL_EXPORT casadi_int va_quaternion_h_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_quaternion_h_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_quaternion_h_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "x";
    case 1: return "lat_lon_height";
    case 2: return "v_n";
    case 3: return "q_b2n_wxyz";
    case 4: return "q_b2m_wxyz";
    case 5: return "omega_ib_b";
    case 6: return "q_m2n_wxyz";
    case 7: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_quaternion_h_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_h";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_quaternion_h_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s1;
    case 3: return casadi_s2;
    case 4: return casadi_s2;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_quaternion_h_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_quaternion_h_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_quaternion_h_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 8*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



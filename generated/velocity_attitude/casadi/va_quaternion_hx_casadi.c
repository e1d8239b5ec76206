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
  a00=arg[6]? arg[6][0] : 0;
  a01=5.0000000000000000e-01;
  a02=1.0000000000000001e-30;
  a03=arg[7]? arg[7][0] : 0;
  a04=casadi_sq(a03);
  a05=arg[2]? arg[2][1] : 0;
  a06=arg[1]? arg[1][2] : 0;
  a07=6378137.;
  a08=1.;
  a09=6.6943799901413173e-03;
  a10=arg[1]? arg[1][0] : 0;
  a11=sin(a10);
  a12=casadi_sq(a11);
  a09=(a09*a12);
  a08=(a08-a09);
  a09=sqrt(a08);
  a07=(a07/a09);
  a07=(a06+a07);
  a05=(a05/a07);
  a10=cos(a10);
  a07=(a11/a10);
  a07=(a05*a07);
  a12=7.2921149999999999e-05;
  a11=(a12*a11);
  a07=(a07+a11);
  a11=arg[5]? arg[5][0] : 0;
  a13=arg[3]? arg[3][1] : 0;
  a14=(2.*a13);
  a15=arg[3]? arg[3][3] : 0;
  a16=(a14*a15);
  a17=arg[3]? arg[3][0] : 0;
  a18=(2.*a17);
  a19=arg[3]? arg[3][2] : 0;
  a20=(a18*a19);
  a21=(a16-a20);
  a21=(a11*a21);
  a21=(a07+a21);
  a22=arg[5]? arg[5][1] : 0;
  a23=(a18*a13);
  a24=(2.*a15);
  a24=(a24*a19);
  a25=(a23+a24);
  a25=(a22*a25);
  a21=(a21+a25);
  a25=arg[5]? arg[5][2] : 0;
  a26=casadi_sq(a15);
  a27=casadi_sq(a19);
  a28=(a26-a27);
  a29=casadi_sq(a17);
  a30=casadi_sq(a13);
  a31=(a29-a30);
  a28=(a28+a31);
  a28=(a25*a28);
  a21=(a21+a28);
  a28=casadi_sq(a21);
  a28=(a04*a28);
  a28=(a02+a28);
  a32=arg[2]? arg[2][0] : 0;
  a33=6.3354393272928204e+06;
  a08=(a08*a09);
  a33=(a33/a08);
  a06=(a06+a33);
  a32=(a32/a06);
  a18=(a18*a15);
  a14=(a14*a19);
  a06=(a18+a14);
  a06=(a11*a06);
  a06=(a32+a06);
  a31=(a27+a31);
  a31=(a31-a26);
  a31=(a22*a31);
  a06=(a06+a31);
  a24=(a24-a23);
  a24=(a25*a24);
  a06=(a06+a24);
  a24=casadi_sq(a06);
  a24=(a04*a24);
  a28=(a28+a24);
  a29=(a29-a27);
  a29=(a29+a30);
  a29=(a29-a26);
  a29=(a11*a29);
  a12=(a12*a10);
  a05=(a05+a12);
  a29=(a29-a05);
  a14=(a14-a18);
  a14=(a22*a14);
  a29=(a29+a14);
  a20=(a20+a16);
  a20=(a25*a20);
  a29=(a29+a20);
  a20=casadi_sq(a29);
  a04=(a04*a20);
  a28=(a28+a04);
  a28=sqrt(a28);
  a04=(a01*a28);
  a20=cos(a04);
  a16=arg[4]? arg[4][0] : 0;
  a14=(a16*a17);
  a18=arg[4]? arg[4][1] : 0;
  a12=(a18*a13);
  a14=(a14+a12);
  a12=arg[4]? arg[4][2] : 0;
  a10=(a12*a19);
  a14=(a14+a10);
  a10=arg[4]? arg[4][3] : 0;
  a26=(a10*a15);
  a14=(a14+a26);
  a26=(a20*a14);
  a04=sin(a04);
  a04=(a03*a04);
  a04=(a04/a28);
  a29=(a04*a29);
  a28=(a16*a13);
  a30=(a12*a15);
  a28=(a28+a30);
  a30=(a18*a17);
  a28=(a28-a30);
  a30=(a10*a19);
  a28=(a28-a30);
  a30=(a29*a28);
  a26=(a26+a30);
  a06=(a04*a06);
  a30=(a16*a19);
  a27=(a10*a13);
  a30=(a30+a27);
  a27=(a18*a15);
  a30=(a30-a27);
  a27=(a12*a17);
  a30=(a30-a27);
  a27=(a06*a30);
  a26=(a26+a27);
  a04=(a04*a21);
  a21=(a16*a15);
  a27=(a18*a19);
  a21=(a21+a27);
  a27=(a12*a13);
  a21=(a21-a27);
  a27=(a10*a17);
  a21=(a21-a27);
  a27=(a04*a21);
  a26=(a26+a27);
  a27=(a00*a26);
  a24=arg[6]? arg[6][1] : 0;
  a23=(a20*a28);
  a31=(a04*a30);
  a23=(a23+a31);
  a31=(a29*a14);
  a23=(a23-a31);
  a31=(a06*a21);
  a23=(a23-a31);
  a31=(a24*a23);
  a27=(a27+a31);
  a31=arg[6]? arg[6][2] : 0;
  a33=(a20*a30);
  a08=(a29*a21);
  a33=(a33+a08);
  a08=(a06*a14);
  a33=(a33-a08);
  a08=(a04*a28);
  a33=(a33-a08);
  a08=(a31*a33);
  a27=(a27+a08);
  a08=arg[6]? arg[6][3] : 0;
  a20=(a20*a21);
  a06=(a06*a28);
  a20=(a20+a06);
  a29=(a29*a30);
  a20=(a20-a29);
  a04=(a04*a14);
  a20=(a20-a04);
  a04=(a08*a20);
  a27=(a27+a04);
  a04=0.;
  a27=(a27<a04);
  a14=(!a27);
  a14=(a14-a27);
  a14=(2.*a14);
  a27=(a00*a23);
  a29=(a31*a20);
  a27=(a27+a29);
  a29=(a24*a26);
  a27=(a27-a29);
  a29=(a08*a33);
  a27=(a27-a29);
  a27=(a14*a27);
  a29=arg[0]? arg[0][15] : 0;
  a03=(a03-a29);
  a29=casadi_sq(a03);
  a30=arg[0]? arg[0][6] : 0;
  a30=(a30+a11);
  a11=arg[0]? arg[0][2] : 0;
  a06=casadi_sq(a11);
  a06=(a02+a06);
  a28=arg[0]? arg[0][1] : 0;
  a21=casadi_sq(a28);
  a06=(a06+a21);
  a21=arg[0]? arg[0][0] : 0;
  a09=casadi_sq(a21);
  a06=(a06+a09);
  a06=sqrt(a06);
  a09=(a01*a06);
  a34=sin(a09);
  a34=(a34/a06);
  a21=(a34*a21);
  a06=(a17*a21);
  a09=cos(a09);
  a35=(a13*a09);
  a06=(a06+a35);
  a28=(a34*a28);
  a35=(a15*a28);
  a06=(a06+a35);
  a34=(a34*a11);
  a11=(a19*a34);
  a06=(a06-a11);
  a11=(2.*a06);
  a35=(a17*a34);
  a36=(a19*a21);
  a35=(a35+a36);
  a36=(a15*a09);
  a35=(a35+a36);
  a36=(a13*a28);
  a35=(a35-a36);
  a36=(a11*a35);
  a37=(a17*a09);
  a38=(a13*a21);
  a37=(a37-a38);
  a38=(a19*a28);
  a37=(a37-a38);
  a38=(a15*a34);
  a37=(a37-a38);
  a38=(2.*a37);
  a17=(a17*a28);
  a13=(a13*a34);
  a17=(a17+a13);
  a19=(a19*a09);
  a17=(a17+a19);
  a15=(a15*a21);
  a17=(a17-a15);
  a15=(a38*a17);
  a21=(a36-a15);
  a21=(a30*a21);
  a07=(a07+a21);
  a21=arg[0]? arg[0][7] : 0;
  a21=(a21+a22);
  a22=(a38*a06);
  a19=(2.*a35);
  a19=(a19*a17);
  a09=(a22+a19);
  a09=(a21*a09);
  a07=(a07+a09);
  a09=arg[0]? arg[0][8] : 0;
  a09=(a09+a25);
  a25=casadi_sq(a35);
  a13=casadi_sq(a17);
  a34=(a25-a13);
  a28=casadi_sq(a37);
  a39=casadi_sq(a06);
  a40=(a28-a39);
  a34=(a34+a40);
  a34=(a09*a34);
  a07=(a07+a34);
  a34=casadi_sq(a07);
  a34=(a29*a34);
  a34=(a02+a34);
  a38=(a38*a35);
  a11=(a11*a17);
  a41=(a38+a11);
  a41=(a30*a41);
  a32=(a32+a41);
  a40=(a13+a40);
  a40=(a40-a25);
  a40=(a21*a40);
  a32=(a32+a40);
  a19=(a19-a22);
  a19=(a09*a19);
  a32=(a32+a19);
  a19=casadi_sq(a32);
  a19=(a29*a19);
  a34=(a34+a19);
  a28=(a28-a13);
  a28=(a28+a39);
  a28=(a28-a25);
  a30=(a30*a28);
  a30=(a30-a05);
  a11=(a11-a38);
  a21=(a21*a11);
  a30=(a30+a21);
  a15=(a15+a36);
  a09=(a09*a15);
  a30=(a30+a09);
  a09=casadi_sq(a30);
  a29=(a29*a09);
  a34=(a34+a29);
  a34=sqrt(a34);
  a29=(a01*a34);
  a09=cos(a29);
  a15=arg[0]? arg[0][12] : 0;
  a36=casadi_sq(a15);
  a02=(a02+a36);
  a36=arg[0]? arg[0][13] : 0;
  a21=casadi_sq(a36);
  a02=(a02+a21);
  a21=arg[0]? arg[0][14] : 0;
  a11=casadi_sq(a21);
  a02=(a02+a11);
  a02=sqrt(a02);
  a01=(a01*a02);
  a11=cos(a01);
  a38=(a16*a11);
  a01=sin(a01);
  a01=(a01/a02);
  a15=(a01*a15);
  a02=(a18*a15);
  a38=(a38-a02);
  a36=(a01*a36);
  a02=(a12*a36);
  a38=(a38-a02);
  a01=(a01*a21);
  a21=(a10*a01);
  a38=(a38-a21);
  a21=(a38*a37);
  a02=(a16*a15);
  a05=(a18*a11);
  a02=(a02+a05);
  a05=(a10*a36);
  a02=(a02+a05);
  a05=(a12*a01);
  a02=(a02-a05);
  a05=(a02*a06);
  a21=(a21+a05);
  a05=(a16*a36);
  a28=(a18*a01);
  a05=(a05+a28);
  a28=(a12*a11);
  a05=(a05+a28);
  a28=(a10*a15);
  a05=(a05-a28);
  a28=(a05*a17);
  a21=(a21+a28);
  a16=(a16*a01);
  a12=(a12*a15);
  a16=(a16+a12);
  a10=(a10*a11);
  a16=(a16+a10);
  a18=(a18*a36);
  a16=(a16-a18);
  a18=(a16*a35);
  a21=(a21+a18);
  a18=(a09*a21);
  a29=sin(a29);
  a03=(a03*a29);
  a03=(a03/a34);
  a30=(a03*a30);
  a34=(a38*a06);
  a29=(a05*a35);
  a34=(a34+a29);
  a29=(a02*a37);
  a34=(a34-a29);
  a29=(a16*a17);
  a34=(a34-a29);
  a29=(a30*a34);
  a18=(a18+a29);
  a32=(a03*a32);
  a29=(a38*a17);
  a36=(a16*a06);
  a29=(a29+a36);
  a36=(a02*a35);
  a29=(a29-a36);
  a36=(a05*a37);
  a29=(a29-a36);
  a36=(a32*a29);
  a18=(a18+a36);
  a03=(a03*a07);
  a38=(a38*a35);
  a02=(a02*a17);
  a38=(a38+a02);
  a05=(a05*a06);
  a38=(a38-a05);
  a16=(a16*a37);
  a38=(a38-a16);
  a16=(a03*a38);
  a18=(a18+a16);
  a16=(a00*a18);
  a37=(a09*a34);
  a05=(a03*a29);
  a37=(a37+a05);
  a05=(a30*a21);
  a37=(a37-a05);
  a05=(a32*a38);
  a37=(a37-a05);
  a05=(a24*a37);
  a16=(a16+a05);
  a05=(a09*a29);
  a06=(a30*a38);
  a05=(a05+a06);
  a06=(a32*a21);
  a05=(a05-a06);
  a06=(a03*a34);
  a05=(a05-a06);
  a06=(a31*a05);
  a16=(a16+a06);
  a09=(a09*a38);
  a32=(a32*a34);
  a09=(a09+a32);
  a30=(a30*a29);
  a09=(a09-a30);
  a03=(a03*a21);
  a09=(a09-a03);
  a03=(a08*a09);
  a16=(a16+a03);
  a16=(a16<a04);
  a04=(!a16);
  a04=(a04-a16);
  a04=(2.*a04);
  a16=(a00*a37);
  a03=(a31*a09);
  a16=(a16+a03);
  a03=(a24*a18);
  a16=(a16-a03);
  a03=(a08*a05);
  a16=(a16-a03);
  a16=(a04*a16);
  a27=(a27-a16);
  if (res[0]!=0) res[0][0]=a27;
  a27=(a00*a33);
  a16=(a08*a23);
  a27=(a27+a16);
  a16=(a24*a20);
  a27=(a27-a16);
  a16=(a31*a26);
  a27=(a27-a16);
  a27=(a14*a27);
  a16=(a00*a05);
  a03=(a08*a37);
  a16=(a16+a03);
  a03=(a24*a09);
  a16=(a16-a03);
  a03=(a31*a18);
  a16=(a16-a03);
  a16=(a04*a16);
  a27=(a27-a16);
  if (res[0]!=0) res[0][1]=a27;
  a20=(a00*a20);
  a33=(a24*a33);
  a20=(a20+a33);
  a23=(a31*a23);
  a20=(a20-a23);
  a26=(a08*a26);
  a20=(a20-a26);
  a14=(a14*a20);
  a00=(a00*a09);
  a24=(a24*a05);
  a00=(a00+a24);
  a31=(a31*a37);
  a00=(a00-a31);
  a08=(a08*a18);
  a00=(a00-a08);
  a04=(a04*a00);
  a14=(a14-a04);
  if (res[0]!=0) res[0][2]=a14;
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



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) va_euler_z_casadi__ ## ID
#endif

#include <math.h>
#include "../src/va_math.h"
#define atan2 BS_ATAN2
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
CASADI_SYMBOL_EXPORT void va_euler_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int va_euler_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int va_euler_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* va_euler_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],euler_m[3],lag)->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  a00=arg[5]? arg[5][0] : 0;
  a01=arg[3]? arg[3][0] : 0;
  a02=arg[2]? arg[2][3] : 0;
  a03=(a01*a02);
  a04=arg[3]? arg[3][1] : 0;
  a05=arg[2]? arg[2][2] : 0;
  a06=(a04*a05);
  a03=(a03+a06);
  a06=arg[3]? arg[3][2] : 0;
  a07=arg[2]? arg[2][1] : 0;
  a08=(a06*a07);
  a03=(a03-a08);
  a08=arg[3]? arg[3][3] : 0;
  a09=arg[2]? arg[2][0] : 0;
  a10=(a08*a09);
  a03=(a03-a10);
  a10=5.0000000000000000e-01;
  a11=1.0000000000000001e-30;
  a12=arg[6]? arg[6][0] : 0;
  a13=casadi_sq(a12);
  a14=arg[4]? arg[4][0] : 0;
  a15=(2.*a09);
  a16=(a15*a02);
  a17=(2.*a05);
  a17=(a17*a07);
  a18=(a16+a17);
  a18=(a14*a18);
  a19=arg[4]? arg[4][1] : 0;
  a20=casadi_sq(a09);
  a21=casadi_sq(a07);
  a22=(a20-a21);
  a23=casadi_sq(a02);
  a24=(a22-a23);
  a25=casadi_sq(a05);
  a24=(a24+a25);
  a24=(a19*a24);
  a18=(a18+a24);
  a24=arg[4]? arg[4][2] : 0;
  a26=(a05*a02);
  a26=(2.*a26);
  a27=(a15*a07);
  a28=(a26-a27);
  a28=(a24*a28);
  a18=(a18+a28);
  a28=arg[1]? arg[1][0] : 0;
  a29=arg[0]? arg[0][2] : 0;
  a30=6.3354393272928204e+06;
  a31=1.;
  a32=6.6943799901413173e-03;
  a33=arg[0]? arg[0][0] : 0;
  a34=sin(a33);
  a35=casadi_sq(a34);
  a32=(a32*a35);
  a31=(a31-a32);
  a32=sqrt(a31);
  a31=(a31*a32);
  a30=(a30/a31);
  a30=(a29+a30);
  a28=(a28/a30);
  a18=(a18+a28);
  a28=casadi_sq(a18);
  a28=(a13*a28);
  a11=(a11+a28);
  a28=7.2921149999999999e-05;
  a33=cos(a33);
  a30=(a28*a33);
  a31=arg[1]? arg[1][1] : 0;
  a35=6378137.;
  a35=(a35/a32);
  a29=(a29+a35);
  a31=(a31/a29);
  a30=(a30+a31);
  a20=(a20-a23);
  a20=(a20+a21);
  a20=(a20-a25);
  a20=(a14*a20);
  a30=(a30-a20);
  a17=(a17-a16);
  a17=(a19*a17);
  a30=(a30-a17);
  a15=(a15*a05);
  a17=(a07*a02);
  a17=(2.*a17);
  a16=(a15+a17);
  a16=(a24*a16);
  a30=(a30-a16);
  a16=casadi_sq(a30);
  a16=(a13*a16);
  a11=(a11+a16);
  a28=(a28*a34);
  a17=(a17-a15);
  a14=(a14*a17);
  a28=(a28+a14);
  a27=(a27+a26);
  a19=(a19*a27);
  a28=(a28+a19);
  a22=(a22-a25);
  a22=(a22+a23);
  a24=(a24*a22);
  a28=(a28+a24);
  a34=(a34/a33);
  a31=(a31*a34);
  a28=(a28+a31);
  a31=casadi_sq(a28);
  a13=(a13*a31);
  a11=(a11+a13);
  a11=sqrt(a11);
  a10=(a10*a11);
  a13=cos(a10);
  a31=(a03*a13);
  a34=(a01*a05);
  a33=(a08*a07);
  a34=(a34+a33);
  a33=(a04*a02);
  a34=(a34-a33);
  a33=(a06*a09);
  a34=(a34-a33);
  a10=sin(a10);
  a12=(a12*a10);
  a12=(a12/a11);
  a30=(a30*a12);
  a11=(a34*a30);
  a31=(a31+a11);
  a11=(a01*a09);
  a10=(a04*a07);
  a11=(a11+a10);
  a10=(a06*a05);
  a11=(a11+a10);
  a10=(a08*a02);
  a11=(a11+a10);
  a28=(a28*a12);
  a10=(a11*a28);
  a31=(a31-a10);
  a01=(a01*a07);
  a06=(a06*a02);
  a01=(a01+a06);
  a04=(a04*a09);
  a01=(a01-a04);
  a08=(a08*a05);
  a01=(a01-a08);
  a18=(a18*a12);
  a12=(a01*a18);
  a31=(a31+a12);
  a12=(a13*a34);
  a08=(a01*a28);
  a12=(a12-a08);
  a08=(a18*a11);
  a12=(a12-a08);
  a08=(a03*a30);
  a12=(a12-a08);
  a08=(2.*a12);
  a05=(a31*a08);
  a04=(a13*a11);
  a09=(a03*a28);
  a04=(a04+a09);
  a09=(a01*a30);
  a04=(a04-a09);
  a09=(a18*a34);
  a04=(a04+a09);
  a13=(a13*a01);
  a03=(a03*a18);
  a13=(a13-a03);
  a30=(a30*a11);
  a13=(a13+a30);
  a34=(a34*a28);
  a13=(a13+a34);
  a34=(2.*a13);
  a28=(a04*a34);
  a05=(a05+a28);
  a28=casadi_sq(a31);
  a13=casadi_sq(a13);
  a28=(a28-a13);
  a13=casadi_sq(a12);
  a30=casadi_sq(a04);
  a13=(a13-a30);
  a30=(a28-a13);
  a05=atan2(a05,a30);
  a00=(a00-a05);
  a05=sin(a00);
  a05=(-a05);
  a00=cos(a00);
  a05=atan2(a05,a00);
  if (res[0]!=0) res[0][0]=a05;
  a05=arg[5]? arg[5][1] : 0;
  a08=(a08*a04);
  a00=(a31*a34);
  a08=(a08-a00);
  a12=(a12*a34);
  a31=(a31*a04);
  a31=(2.*a31);
  a12=(a12+a31);
  a31=casadi_sq(a12);
  a28=(a28+a13);
  a13=casadi_sq(a28);
  a31=(a31+a13);
  a31=sqrt(a31);
  a08=atan2(a08,a31);
  a05=(a05-a08);
  a08=sin(a05);
  a08=(-a08);
  a05=cos(a05);
  a08=atan2(a08,a05);
  if (res[0]!=0) res[0][1]=a08;
  a08=arg[5]? arg[5][2] : 0;
  a28=(-a28);
  a12=atan2(a12,a28);
  a08=(a08-a12);
  a12=sin(a08);
  a12=(-a12);
  a08=cos(a08);
  a12=atan2(a12,a08);
  if (res[0]!=0) res[0][2]=a12;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_euler_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int va_euler_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void va_euler_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void va_euler_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void va_euler_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int va_euler_z_casadi_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int va_euler_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real va_euler_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_euler_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "euler_m";
    case 6: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* va_euler_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_euler_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* va_euler_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int va_euler_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int va_euler_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) val_quaternion_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void val_quaternion_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int val_quaternion_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int val_quaternion_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};

/* val_quaternion_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag)->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31;
  a00=arg[5]? arg[5][0] : 0;
  a01=5.0000000000000000e-01;
  a02=1.0000000000000001e-30;
  a03=arg[6]? arg[6][0] : 0;
  a04=casadi_sq(a03);
  a05=arg[4]? arg[4][0] : 0;
  a06=arg[2]? arg[2][1] : 0;
  a07=(2.*a06);
  a08=arg[2]? arg[2][3] : 0;
  a09=(a07*a08);
  a10=arg[2]? arg[2][0] : 0;
  a11=(2.*a10);
  a12=arg[2]? arg[2][2] : 0;
  a13=(a11*a12);
  a14=(a09-a13);
  a14=(a05*a14);
  a15=arg[4]? arg[4][1] : 0;
  a16=(a11*a06);
  a17=(2.*a08);
  a17=(a17*a12);
  a18=(a16+a17);
  a18=(a15*a18);
  a14=(a14+a18);
  a18=arg[4]? arg[4][2] : 0;
  a19=casadi_sq(a10);
  a20=casadi_sq(a06);
  a21=(a19-a20);
  a22=casadi_sq(a08);
  a23=(a21+a22);
  a24=casadi_sq(a12);
  a23=(a23-a24);
  a23=(a18*a23);
  a14=(a14+a23);
  a23=arg[1]? arg[1][1] : 0;
  a25=arg[0]? arg[0][2] : 0;
  a26=6378137.;
  a27=1.;
  a28=6.6943799901413173e-03;
  a29=arg[0]? arg[0][0] : 0;
  a30=sin(a29);
  a31=casadi_sq(a30);
  a28=(a28*a31);
  a27=(a27-a28);
  a28=sqrt(a27);
  a26=(a26/a28);
  a26=(a25+a26);
  a23=(a23/a26);
  a29=cos(a29);
  a26=(a30/a29);
  a26=(a23*a26);
  a31=7.2921149999999999e-05;
  a30=(a31*a30);
  a26=(a26+a30);
  a14=(a14+a26);
  a26=casadi_sq(a14);
  a26=(a04*a26);
  a02=(a02+a26);
  a11=(a11*a08);
  a07=(a07*a12);
  a26=(a11+a07);
  a26=(a05*a26);
  a21=(a21-a22);
  a21=(a21+a24);
  a21=(a15*a21);
  a26=(a26+a21);
  a17=(a17-a16);
  a17=(a18*a17);
  a26=(a26+a17);
  a17=arg[1]? arg[1][0] : 0;
  a16=6.3354393272928204e+06;
  a27=(a27*a28);
  a16=(a16/a27);
  a25=(a25+a16);
  a17=(a17/a25);
  a26=(a26+a17);
  a17=casadi_sq(a26);
  a17=(a04*a17);
  a02=(a02+a17);
  a19=(a19+a20);
  a19=(a19-a22);
  a19=(a19-a24);
  a05=(a05*a19);
  a07=(a07-a11);
  a15=(a15*a07);
  a05=(a05+a15);
  a13=(a13+a09);
  a18=(a18*a13);
  a05=(a05+a18);
  a31=(a31*a29);
  a23=(a23+a31);
  a05=(a05-a23);
  a23=casadi_sq(a05);
  a04=(a04*a23);
  a02=(a02+a04);
  a02=sqrt(a02);
  a01=(a01*a02);
  a04=cos(a01);
  a23=arg[3]? arg[3][0] : 0;
  a31=(a23*a10);
  a29=arg[3]? arg[3][1] : 0;
  a18=(a29*a06);
  a31=(a31+a18);
  a18=arg[3]? arg[3][2] : 0;
  a13=(a18*a12);
  a31=(a31+a13);
  a13=arg[3]? arg[3][3] : 0;
  a09=(a13*a08);
  a31=(a31+a09);
  a09=(a04*a31);
  a01=sin(a01);
  a03=(a03*a01);
  a03=(a03/a02);
  a05=(a03*a05);
  a02=(a23*a06);
  a01=(a18*a08);
  a02=(a02+a01);
  a01=(a29*a10);
  a02=(a02-a01);
  a01=(a13*a12);
  a02=(a02-a01);
  a01=(a05*a02);
  a09=(a09+a01);
  a26=(a03*a26);
  a01=(a23*a12);
  a15=(a13*a06);
  a01=(a01+a15);
  a15=(a29*a08);
  a01=(a01-a15);
  a15=(a18*a10);
  a01=(a01-a15);
  a15=(a26*a01);
  a09=(a09+a15);
  a03=(a03*a14);
  a23=(a23*a08);
  a29=(a29*a12);
  a23=(a23+a29);
  a18=(a18*a06);
  a23=(a23-a18);
  a13=(a13*a10);
  a23=(a23-a13);
  a13=(a03*a23);
  a09=(a09+a13);
  a13=(a00*a09);
  a10=arg[5]? arg[5][1] : 0;
  a18=(a04*a02);
  a06=(a03*a01);
  a18=(a18+a06);
  a06=(a05*a31);
  a18=(a18-a06);
  a06=(a26*a23);
  a18=(a18-a06);
  a06=(a10*a18);
  a13=(a13+a06);
  a06=arg[5]? arg[5][2] : 0;
  a29=(a04*a01);
  a12=(a05*a23);
  a29=(a29+a12);
  a12=(a26*a31);
  a29=(a29-a12);
  a12=(a03*a02);
  a29=(a29-a12);
  a12=(a06*a29);
  a13=(a13+a12);
  a12=arg[5]? arg[5][3] : 0;
  a04=(a04*a23);
  a26=(a26*a02);
  a04=(a04+a26);
  a05=(a05*a01);
  a04=(a04-a05);
  a03=(a03*a31);
  a04=(a04-a03);
  a03=(a12*a04);
  a13=(a13+a03);
  a03=0.;
  a13=(a13<a03);
  a03=(!a13);
  a03=(a03-a13);
  a03=(2.*a03);
  a13=(a00*a18);
  a31=(a06*a04);
  a13=(a13+a31);
  a31=(a10*a09);
  a13=(a13-a31);
  a31=(a12*a29);
  a13=(a13-a31);
  a13=(a03*a13);
  if (res[0]!=0) res[0][0]=a13;
  a13=(a00*a29);
  a31=(a12*a18);
  a13=(a13+a31);
  a31=(a10*a04);
  a13=(a13-a31);
  a31=(a06*a09);
  a13=(a13-a31);
  a13=(a03*a13);
  if (res[0]!=0) res[0][1]=a13;
  a00=(a00*a04);
  a10=(a10*a29);
  a00=(a00+a10);
  a06=(a06*a18);
  a00=(a00-a06);
  a12=(a12*a09);
  a00=(a00-a12);
  a03=(a03*a00);
  if (res[0]!=0) res[0][2]=a03;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_quaternion_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int val_quaternion_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void val_quaternion_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void val_quaternion_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void val_quaternion_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int val_quaternion_z_casadi_n_in(void) { return 7;}

CASADI_SYMBOL_EXPORT casadi_int val_quaternion_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real val_quaternion_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_quaternion_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "q_m2n_wxyz";
    case 6: return "lag";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* val_quaternion_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_quaternion_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* val_quaternion_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int val_quaternion_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int val_quaternion_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 7*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_euler_z_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vas_math.h"
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
CASADI_SYMBOL_EXPORT void vas_euler_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_euler_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_euler_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};

/* vas_euler_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],euler_m[3],lag,flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37;
  a00=arg[5]? arg[5][0] : 0;
  a01=5.0000000000000000e-01;
  a02=1.0000000000000001e-30;
  a03=arg[6]? arg[6][0] : 0;
  a04=(a03*a03);
  a05=arg[4]? arg[4][2] : 0;
  a06=1.;
  a07=arg[9]? arg[9][2] : 0;
  a07=(a06-a07);
  a07=(a05*a07);
  a08=arg[8]? arg[8][0] : 0;
  a09=2.;
  a10=arg[3]? arg[3][0] : 0;
  a11=(a09*a10);
  a12=arg[3]? arg[3][2] : 0;
  a13=(a11*a12);
  a14=arg[3]? arg[3][3] : 0;
  a15=(a09*a14);
  a16=arg[3]? arg[3][1] : 0;
  a15=(a15*a16);
  a17=(a13+a15);
  a17=(a08*a17);
  a07=(a07-a17);
  a17=arg[8]? arg[8][1] : 0;
  a18=(a12*a14);
  a18=(a09*a18);
  a19=(a11*a16);
  a20=(a18-a19);
  a20=(a17*a20);
  a07=(a07-a20);
  a20=arg[8]? arg[8][2] : 0;
  a21=(a14*a14);
  a22=(a16*a16);
  a23=(a21-a22);
  a24=(a10*a10);
  a25=(a12*a12);
  a26=(a24-a25);
  a23=(a23+a26);
  a23=(a20*a23);
  a07=(a07-a23);
  a23=arg[10]? arg[10][4] : 0;
  a27=arg[4]? arg[4][0] : 0;
  a23=(a23*a27);
  a07=(a07-a23);
  a23=arg[10]? arg[10][5] : 0;
  a28=arg[4]? arg[4][1] : 0;
  a23=(a23*a28);
  a07=(a07-a23);
  a23=arg[2]? arg[2][2] : 0;
  a29=arg[2]? arg[2][3] : 0;
  a30=(a23*a29);
  a30=(a09*a30);
  a31=arg[2]? arg[2][0] : 0;
  a32=(a09*a31);
  a33=arg[2]? arg[2][1] : 0;
  a34=(a32*a33);
  a35=(a30-a34);
  a35=(a07*a35);
  a36=arg[9]? arg[9][0] : 0;
  a36=(a06-a36);
  a36=(a27*a36);
  a26=(a22+a26);
  a26=(a26-a21);
  a26=(a08*a26);
  a36=(a36-a26);
  a11=(a11*a14);
  a26=(a16*a12);
  a26=(a09*a26);
  a37=(a11+a26);
  a37=(a17*a37);
  a36=(a36-a37);
  a15=(a15-a13);
  a15=(a20*a15);
  a36=(a36-a15);
  a15=arg[10]? arg[10][0] : 0;
  a15=(a15*a28);
  a36=(a36-a15);
  a15=arg[10]? arg[10][1] : 0;
  a15=(a15*a05);
  a36=(a36-a15);
  a15=(a32*a29);
  a13=(a09*a23);
  a13=(a13*a33);
  a37=(a15+a13);
  a37=(a36*a37);
  a35=(a35+a37);
  a37=arg[9]? arg[9][1] : 0;
  a37=(a06-a37);
  a28=(a28*a37);
  a26=(a26-a11);
  a08=(a08*a26);
  a28=(a28-a08);
  a24=(a24-a22);
  a24=(a24+a25);
  a24=(a24-a21);
  a17=(a17*a24);
  a28=(a28-a17);
  a19=(a19+a18);
  a20=(a20*a19);
  a28=(a28-a20);
  a20=arg[10]? arg[10][2] : 0;
  a20=(a20*a27);
  a28=(a28-a20);
  a20=arg[10]? arg[10][3] : 0;
  a20=(a20*a05);
  a28=(a28-a20);
  a20=(a23*a23);
  a05=(a29*a29);
  a27=(a20-a05);
  a19=(a31*a31);
  a18=(a33*a33);
  a17=(a19-a18);
  a27=(a27+a17);
  a27=(a28*a27);
  a35=(a35+a27);
  a27=arg[1]? arg[1][0] : 0;
  a24=arg[0]? arg[0][2] : 0;
  a21=6.3354393272928204e+06;
  a25=6.6943799901413173e-03;
  a22=arg[0]? arg[0][0] : 0;
  a08=sin(a22);
  a26=(a08*a08);
  a25=(a25*a26);
  a25=(a06-a25);
  a26=sqrt(a25);
  a25=(a25*a26);
  a21=(a21/a25);
  a21=(a24+a21);
  a27=(a27/a21);
  a35=(a35+a27);
  a27=(a35*a35);
  a27=(a04*a27);
  a02=(a02+a27);
  a27=7.2921149999999999e-05;
  a22=cos(a22);
  a21=(a27*a22);
  a25=arg[1]? arg[1][1] : 0;
  a11=6378137.;
  a11=(a11/a26);
  a24=(a24+a11);
  a25=(a25/a24);
  a21=(a21+a25);
  a32=(a32*a23);
  a24=(a33*a29);
  a24=(a09*a24);
  a11=(a32+a24);
  a11=(a07*a11);
  a21=(a21-a11);
  a19=(a19-a05);
  a19=(a19+a18);
  a19=(a19-a20);
  a19=(a36*a19);
  a21=(a21-a19);
  a13=(a13-a15);
  a13=(a28*a13);
  a21=(a21-a13);
  a13=(a21*a21);
  a13=(a04*a13);
  a02=(a02+a13);
  a27=(a27*a08);
  a05=(a05+a17);
  a05=(a05-a20);
  a07=(a07*a05);
  a27=(a27+a07);
  a24=(a24-a32);
  a36=(a36*a24);
  a27=(a27+a36);
  a34=(a34+a30);
  a28=(a28*a34);
  a27=(a27+a28);
  a08=(a08/a22);
  a25=(a25*a08);
  a27=(a27+a25);
  a25=(a27*a27);
  a04=(a04*a25);
  a02=(a02+a04);
  a02=sqrt(a02);
  a04=(a01*a02);
  a25=cos(a04);
  a08=2.5000000000000000e-01;
  a22=arg[7]? arg[7][0] : 0;
  a28=(a22*a22);
  a28=(a08*a28);
  a28=(a06+a28);
  a34=arg[7]? arg[7][1] : 0;
  a30=(a34*a34);
  a30=(a08*a30);
  a28=(a28+a30);
  a30=arg[7]? arg[7][2] : 0;
  a36=(a30*a30);
  a08=(a08*a36);
  a28=(a28+a08);
  a28=sqrt(a28);
  a06=(a06/a28);
  a16=(a16*a06);
  a14=(a14*a06);
  a34=(a01*a34);
  a28=(a14*a34);
  a28=(a16+a28);
  a22=(a01*a22);
  a10=(a10*a06);
  a08=(a22*a10);
  a28=(a28+a08);
  a12=(a12*a06);
  a01=(a01*a30);
  a30=(a12*a01);
  a28=(a28-a30);
  a30=(a28*a33);
  a06=(a14*a01);
  a06=(a10-a06);
  a08=(a12*a34);
  a06=(a06-a08);
  a08=(a22*a16);
  a06=(a06-a08);
  a08=(a06*a31);
  a30=(a30+a08);
  a08=(a12*a22);
  a08=(a14+a08);
  a36=(a10*a01);
  a08=(a08+a36);
  a36=(a16*a34);
  a08=(a08-a36);
  a36=(a08*a29);
  a30=(a30+a36);
  a16=(a16*a01);
  a12=(a12+a16);
  a34=(a34*a10);
  a12=(a12+a34);
  a14=(a14*a22);
  a12=(a12-a14);
  a14=(a12*a23);
  a30=(a30+a14);
  a14=(a25*a30);
  a22=(a28*a23);
  a34=(a06*a29);
  a22=(a22+a34);
  a34=(a08*a31);
  a22=(a22-a34);
  a34=(a12*a33);
  a22=(a22-a34);
  a04=sin(a04);
  a03=(a03*a04);
  a03=(a03/a02);
  a27=(a27*a03);
  a02=(a22*a27);
  a14=(a14+a02);
  a02=(a06*a33);
  a04=(a12*a29);
  a02=(a02+a04);
  a04=(a28*a31);
  a02=(a02-a04);
  a04=(a08*a23);
  a02=(a02-a04);
  a21=(a21*a03);
  a04=(a02*a21);
  a14=(a14-a04);
  a35=(a35*a03);
  a06=(a06*a23);
  a08=(a08*a33);
  a06=(a06+a08);
  a28=(a28*a29);
  a06=(a06-a28);
  a12=(a12*a31);
  a06=(a06-a12);
  a12=(a35*a06);
  a14=(a14+a12);
  a12=(a25*a02);
  a31=(a22*a35);
  a12=(a12-a31);
  a31=(a21*a30);
  a12=(a12+a31);
  a31=(a06*a27);
  a12=(a12+a31);
  a31=(a09*a12);
  a28=(a14*a31);
  a29=(a22*a25);
  a08=(a06*a21);
  a29=(a29+a08);
  a08=(a30*a27);
  a29=(a29-a08);
  a08=(a02*a35);
  a29=(a29+a08);
  a25=(a25*a06);
  a02=(a02*a27);
  a25=(a25-a02);
  a35=(a35*a30);
  a25=(a25-a35);
  a22=(a22*a21);
  a25=(a25-a22);
  a22=(a29*a25);
  a22=(a09*a22);
  a28=(a28+a22);
  a22=(a14*a14);
  a21=(a29*a29);
  a12=(a12*a12);
  a21=(a21-a12);
  a12=(a22+a21);
  a35=(a25*a25);
  a12=(a12-a35);
  a28=atan2(a28,a12);
  a00=(a00-a28);
  a28=sin(a00);
  a28=(-a28);
  a00=cos(a00);
  a28=atan2(a28,a00);
  if (res[0]!=0) res[0][0]=a28;
  a28=arg[5]? arg[5][1] : 0;
  a00=(a25*a14);
  a00=(a09*a00);
  a12=(a29*a31);
  a00=(a00-a12);
  a25=(a25*a31);
  a29=(a29*a14);
  a09=(a09*a29);
  a25=(a25+a09);
  a09=(a25*a25);
  a22=(a22-a35);
  a22=(a22-a21);
  a21=(a22*a22);
  a09=(a09+a21);
  a09=sqrt(a09);
  a00=atan2(a00,a09);
  a28=(a28-a00);
  a00=sin(a28);
  a00=(-a00);
  a28=cos(a28);
  a00=atan2(a00,a28);
  if (res[0]!=0) res[0][1]=a00;
  a00=arg[5]? arg[5][2] : 0;
  a25=atan2(a25,a22);
  a00=(a00-a25);
  a25=sin(a00);
  a25=(-a25);
  a00=cos(a00);
  a25=atan2(a25,a00);
  if (res[0]!=0) res[0][2]=a25;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_euler_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_euler_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_euler_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_euler_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_euler_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_euler_z_casadi_n_in(void) { return 11;}

CASADI_SYMBOL_EXPORT casadi_int vas_euler_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_euler_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_euler_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "euler_m";
    case 6: return "lag";
    case 7: return "flexure";
    case 8: return "flexure_rate";
    case 9: return "gyro_scale";
    case 10: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_euler_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_euler_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s2;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s0;
    case 10: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_euler_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_euler_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 11;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_euler_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



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
  casadi_real a36, a37, a38;
  a00=arg[5]? arg[5][0] : 0;
  a01=2.;
  a02=5.0000000000000000e-01;
  a03=1.0000000000000001e-30;
  a04=arg[6]? arg[6][0] : 0;
  a05=(a04*a04);
  a06=arg[4]? arg[4][0] : 0;
  a07=1.;
  a08=arg[9]? arg[9][0] : 0;
  a08=(a07-a08);
  a08=(a06*a08);
  a09=arg[8]? arg[8][0] : 0;
  a10=arg[3]? arg[3][0] : 0;
  a11=(a10*a10);
  a12=arg[3]? arg[3][3] : 0;
  a13=(a12*a12);
  a14=(a11-a13);
  a15=arg[3]? arg[3][1] : 0;
  a16=(a15*a15);
  a17=(a14+a16);
  a18=arg[3]? arg[3][2] : 0;
  a19=(a18*a18);
  a17=(a17-a19);
  a17=(a09*a17);
  a08=(a08-a17);
  a17=arg[8]? arg[8][1] : 0;
  a20=(a01*a10);
  a21=(a20*a12);
  a22=(a01*a15);
  a23=(a22*a18);
  a24=(a21+a23);
  a24=(a17*a24);
  a08=(a08-a24);
  a24=arg[8]? arg[8][2] : 0;
  a22=(a22*a12);
  a25=(a20*a18);
  a26=(a22-a25);
  a26=(a24*a26);
  a08=(a08-a26);
  a26=arg[10]? arg[10][0] : 0;
  a27=arg[4]? arg[4][1] : 0;
  a26=(a26*a27);
  a08=(a08-a26);
  a26=arg[10]? arg[10][1] : 0;
  a28=arg[4]? arg[4][2] : 0;
  a26=(a26*a28);
  a08=(a08-a26);
  a26=arg[2]? arg[2][1] : 0;
  a29=(a01*a26);
  a30=arg[2]? arg[2][3] : 0;
  a31=(a29*a30);
  a32=arg[2]? arg[2][0] : 0;
  a33=(a01*a32);
  a34=arg[2]? arg[2][2] : 0;
  a35=(a33*a34);
  a36=(a31-a35);
  a36=(a08*a36);
  a37=arg[9]? arg[9][1] : 0;
  a37=(a07-a37);
  a37=(a27*a37);
  a23=(a23-a21);
  a23=(a09*a23);
  a37=(a37-a23);
  a14=(a14-a16);
  a14=(a14+a19);
  a14=(a17*a14);
  a37=(a37-a14);
  a20=(a20*a15);
  a14=(a01*a18);
  a14=(a14*a12);
  a23=(a20+a14);
  a23=(a24*a23);
  a37=(a37-a23);
  a23=arg[10]? arg[10][2] : 0;
  a23=(a23*a06);
  a37=(a37-a23);
  a23=arg[10]? arg[10][3] : 0;
  a23=(a23*a28);
  a37=(a37-a23);
  a23=(a33*a26);
  a21=(a01*a30);
  a21=(a21*a34);
  a38=(a23+a21);
  a38=(a37*a38);
  a36=(a36+a38);
  a38=arg[9]? arg[9][2] : 0;
  a38=(a07-a38);
  a28=(a28*a38);
  a25=(a25+a22);
  a09=(a09*a25);
  a28=(a28-a09);
  a14=(a14-a20);
  a17=(a17*a14);
  a28=(a28-a17);
  a16=(a16+a19);
  a11=(a11-a16);
  a11=(a11+a13);
  a24=(a24*a11);
  a28=(a28-a24);
  a24=arg[10]? arg[10][4] : 0;
  a24=(a24*a06);
  a28=(a28-a24);
  a24=arg[10]? arg[10][5] : 0;
  a24=(a24*a27);
  a28=(a28-a24);
  a24=(a30*a30);
  a27=(a34*a34);
  a06=(a24-a27);
  a11=(a32*a32);
  a13=(a26*a26);
  a16=(a11-a13);
  a06=(a06+a16);
  a06=(a28*a06);
  a36=(a36+a06);
  a06=arg[1]? arg[1][1] : 0;
  a19=arg[0]? arg[0][2] : 0;
  a17=6378137.;
  a14=6.6943799901413173e-03;
  a20=arg[0]? arg[0][0] : 0;
  a09=sin(a20);
  a25=(a09*a09);
  a14=(a14*a25);
  a14=(a07-a14);
  a25=sqrt(a14);
  a17=(a17/a25);
  a17=(a19+a17);
  a06=(a06/a17);
  a20=cos(a20);
  a17=(a09/a20);
  a17=(a06*a17);
  a22=7.2921149999999999e-05;
  a09=(a22*a09);
  a17=(a17+a09);
  a36=(a36+a17);
  a17=(a36*a36);
  a17=(a05*a17);
  a03=(a03+a17);
  a33=(a33*a30);
  a29=(a29*a34);
  a17=(a33+a29);
  a17=(a08*a17);
  a16=(a27+a16);
  a16=(a16-a24);
  a16=(a37*a16);
  a17=(a17+a16);
  a21=(a21-a23);
  a21=(a28*a21);
  a17=(a17+a21);
  a21=arg[1]? arg[1][0] : 0;
  a23=6.3354393272928204e+06;
  a14=(a14*a25);
  a23=(a23/a14);
  a19=(a19+a23);
  a21=(a21/a19);
  a17=(a17+a21);
  a21=(a17*a17);
  a21=(a05*a21);
  a03=(a03+a21);
  a11=(a11-a27);
  a11=(a11+a13);
  a11=(a11-a24);
  a08=(a08*a11);
  a29=(a29-a33);
  a37=(a37*a29);
  a08=(a08+a37);
  a35=(a35+a31);
  a28=(a28*a35);
  a08=(a08+a28);
  a22=(a22*a20);
  a06=(a06+a22);
  a08=(a08-a06);
  a06=(a08*a08);
  a05=(a05*a06);
  a03=(a03+a05);
  a03=sqrt(a03);
  a05=(a02*a03);
  a06=cos(a05);
  a22=2.5000000000000000e-01;
  a20=arg[7]? arg[7][0] : 0;
  a28=(a20*a20);
  a28=(a22*a28);
  a28=(a07+a28);
  a35=arg[7]? arg[7][1] : 0;
  a31=(a35*a35);
  a31=(a22*a31);
  a28=(a28+a31);
  a31=arg[7]? arg[7][2] : 0;
  a37=(a31*a31);
  a22=(a22*a37);
  a28=(a28+a22);
  a28=sqrt(a28);
  a07=(a07/a28);
  a28=(a10*a07);
  a02=(a02*a07);
  a20=(a02*a20);
  a22=(a15*a20);
  a28=(a28-a22);
  a35=(a02*a35);
  a22=(a18*a35);
  a28=(a28-a22);
  a02=(a02*a31);
  a31=(a12*a02);
  a28=(a28-a31);
  a31=(a32*a28);
  a22=(a10*a20);
  a37=(a15*a07);
  a22=(a22+a37);
  a37=(a12*a35);
  a22=(a22+a37);
  a37=(a18*a02);
  a22=(a22-a37);
  a37=(a26*a22);
  a31=(a31+a37);
  a37=(a10*a35);
  a29=(a15*a02);
  a37=(a37+a29);
  a29=(a18*a07);
  a37=(a37+a29);
  a29=(a12*a20);
  a37=(a37-a29);
  a29=(a34*a37);
  a31=(a31+a29);
  a10=(a10*a02);
  a18=(a18*a20);
  a10=(a10+a18);
  a12=(a12*a07);
  a10=(a10+a12);
  a15=(a15*a35);
  a10=(a10-a15);
  a15=(a30*a10);
  a31=(a31+a15);
  a15=(a06*a31);
  a05=sin(a05);
  a04=(a04*a05);
  a04=(a04/a03);
  a08=(a04*a08);
  a03=(a26*a28);
  a05=(a30*a37);
  a03=(a03+a05);
  a05=(a32*a22);
  a03=(a03-a05);
  a05=(a34*a10);
  a03=(a03-a05);
  a05=(a08*a03);
  a15=(a15+a05);
  a17=(a04*a17);
  a05=(a26*a10);
  a35=(a34*a28);
  a05=(a05+a35);
  a35=(a32*a37);
  a05=(a05-a35);
  a35=(a30*a22);
  a05=(a05-a35);
  a35=(a17*a05);
  a15=(a15+a35);
  a04=(a04*a36);
  a34=(a34*a22);
  a30=(a30*a28);
  a34=(a34+a30);
  a32=(a32*a10);
  a34=(a34-a32);
  a26=(a26*a37);
  a34=(a34-a26);
  a26=(a04*a34);
  a15=(a15+a26);
  a26=(a01*a15);
  a37=(a06*a03);
  a32=(a04*a05);
  a37=(a37+a32);
  a32=(a08*a31);
  a37=(a37-a32);
  a32=(a17*a34);
  a37=(a37-a32);
  a32=(a26*a37);
  a10=(a06*a05);
  a30=(a08*a34);
  a10=(a10+a30);
  a30=(a17*a31);
  a10=(a10-a30);
  a30=(a04*a03);
  a10=(a10-a30);
  a30=(a01*a10);
  a06=(a06*a34);
  a17=(a17*a03);
  a06=(a06+a17);
  a08=(a08*a05);
  a06=(a06-a08);
  a04=(a04*a31);
  a06=(a06-a04);
  a30=(a30*a06);
  a32=(a32+a30);
  a30=(a06*a06);
  a15=(a15*a15);
  a04=(a10*a10);
  a15=(a15-a04);
  a04=(a30+a15);
  a31=(a37*a37);
  a04=(a04-a31);
  a32=atan2(a32,a04);
  a00=(a00-a32);
  a32=sin(a00);
  a32=(-a32);
  a00=cos(a00);
  a32=atan2(a32,a00);
  if (res[0]!=0) res[0][0]=a32;
  a32=arg[5]? arg[5][1] : 0;
  a00=(a26*a10);
  a01=(a01*a37);
  a37=(a01*a06);
  a00=(a00-a37);
  a31=(a31+a15);
  a31=(a31-a30);
  a30=(a31*a31);
  a26=(a26*a06);
  a01=(a01*a10);
  a26=(a26+a01);
  a01=(a26*a26);
  a30=(a30+a01);
  a30=sqrt(a30);
  a00=atan2(a00,a30);
  a32=(a32-a00);
  a00=sin(a32);
  a00=(-a00);
  a32=cos(a32);
  a00=atan2(a00,a32);
  if (res[0]!=0) res[0][1]=a00;
  a00=arg[5]? arg[5][2] : 0;
  a26=atan2(a26,a31);
  a00=(a00-a26);
  a26=sin(a00);
  a26=(-a26);
  a00=cos(a00);
  a26=atan2(a26,a00);
  if (res[0]!=0) res[0][2]=a26;
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



/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_quaternion_z_casadi__ ## ID
#endif

#include <math.h>
#include "../src/vas_math.h"
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
CASADI_SYMBOL_EXPORT void vas_quaternion_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_quaternion_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_quaternion_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};

/* vas_quaternion_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],q_m2n_wxyz[4],lag,flexure[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38;
  a00=2.;
  a01=arg[5]? arg[5][0] : 0;
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
  a10=arg[3]? arg[3][1] : 0;
  a11=(a10*a10);
  a12=arg[3]? arg[3][2] : 0;
  a13=(a12*a12);
  a14=(a11-a13);
  a15=arg[3]? arg[3][0] : 0;
  a16=(a15*a15);
  a17=arg[3]? arg[3][3] : 0;
  a18=(a17*a17);
  a19=(a16-a18);
  a20=(a14+a19);
  a20=(a09*a20);
  a08=(a08-a20);
  a20=arg[8]? arg[8][1] : 0;
  a21=(a00*a15);
  a22=(a21*a17);
  a23=(a00*a10);
  a24=(a23*a12);
  a25=(a22+a24);
  a25=(a20*a25);
  a08=(a08-a25);
  a25=arg[8]? arg[8][2] : 0;
  a23=(a23*a17);
  a26=(a21*a12);
  a27=(a23-a26);
  a27=(a25*a27);
  a08=(a08-a27);
  a27=arg[10]? arg[10][0] : 0;
  a28=arg[4]? arg[4][1] : 0;
  a27=(a27*a28);
  a08=(a08-a27);
  a27=arg[10]? arg[10][1] : 0;
  a29=arg[4]? arg[4][2] : 0;
  a27=(a27*a29);
  a08=(a08-a27);
  a27=arg[2]? arg[2][1] : 0;
  a30=(a00*a27);
  a31=arg[2]? arg[2][3] : 0;
  a32=(a30*a31);
  a33=arg[2]? arg[2][0] : 0;
  a34=(a00*a33);
  a35=arg[2]? arg[2][2] : 0;
  a36=(a34*a35);
  a37=(a32-a36);
  a37=(a08*a37);
  a38=arg[9]? arg[9][1] : 0;
  a38=(a07-a38);
  a38=(a28*a38);
  a24=(a24-a22);
  a24=(a09*a24);
  a38=(a38-a24);
  a19=(a19-a14);
  a19=(a20*a19);
  a38=(a38-a19);
  a21=(a21*a10);
  a19=(a00*a12);
  a19=(a19*a17);
  a14=(a21+a19);
  a14=(a25*a14);
  a38=(a38-a14);
  a14=arg[10]? arg[10][2] : 0;
  a14=(a14*a06);
  a38=(a38-a14);
  a14=arg[10]? arg[10][3] : 0;
  a14=(a14*a29);
  a38=(a38-a14);
  a14=(a34*a27);
  a24=(a00*a31);
  a24=(a24*a35);
  a22=(a14+a24);
  a22=(a38*a22);
  a37=(a37+a22);
  a22=arg[9]? arg[9][2] : 0;
  a22=(a07-a22);
  a29=(a29*a22);
  a26=(a26+a23);
  a09=(a09*a26);
  a29=(a29-a09);
  a19=(a19-a21);
  a20=(a20*a19);
  a29=(a29-a20);
  a11=(a11+a13);
  a16=(a16-a11);
  a16=(a16+a18);
  a25=(a25*a16);
  a29=(a29-a25);
  a25=arg[10]? arg[10][4] : 0;
  a25=(a25*a06);
  a29=(a29-a25);
  a25=arg[10]? arg[10][5] : 0;
  a25=(a25*a28);
  a29=(a29-a25);
  a25=(a31*a31);
  a28=(a35*a35);
  a06=(a25-a28);
  a16=(a33*a33);
  a18=(a27*a27);
  a11=(a16-a18);
  a06=(a06+a11);
  a06=(a29*a06);
  a37=(a37+a06);
  a06=arg[1]? arg[1][1] : 0;
  a13=arg[0]? arg[0][2] : 0;
  a20=6378137.;
  a19=6.6943799901413173e-03;
  a21=arg[0]? arg[0][0] : 0;
  a09=sin(a21);
  a26=(a09*a09);
  a19=(a19*a26);
  a19=(a07-a19);
  a26=sqrt(a19);
  a20=(a20/a26);
  a20=(a13+a20);
  a06=(a06/a20);
  a21=cos(a21);
  a20=(a09/a21);
  a20=(a06*a20);
  a23=7.2921149999999999e-05;
  a09=(a23*a09);
  a20=(a20+a09);
  a37=(a37+a20);
  a20=(a37*a37);
  a20=(a05*a20);
  a03=(a03+a20);
  a34=(a34*a31);
  a30=(a30*a35);
  a20=(a34+a30);
  a20=(a08*a20);
  a11=(a28+a11);
  a11=(a11-a25);
  a11=(a38*a11);
  a20=(a20+a11);
  a24=(a24-a14);
  a24=(a29*a24);
  a20=(a20+a24);
  a24=arg[1]? arg[1][0] : 0;
  a14=6.3354393272928204e+06;
  a19=(a19*a26);
  a14=(a14/a19);
  a13=(a13+a14);
  a24=(a24/a13);
  a20=(a20+a24);
  a24=(a20*a20);
  a24=(a05*a24);
  a03=(a03+a24);
  a16=(a16-a28);
  a16=(a16+a18);
  a16=(a16-a25);
  a08=(a08*a16);
  a30=(a30-a34);
  a38=(a38*a30);
  a08=(a08+a38);
  a36=(a36+a32);
  a29=(a29*a36);
  a08=(a08+a29);
  a23=(a23*a21);
  a06=(a06+a23);
  a08=(a08-a06);
  a06=(a08*a08);
  a05=(a05*a06);
  a03=(a03+a05);
  a03=sqrt(a03);
  a05=(a02*a03);
  a06=cos(a05);
  a23=2.5000000000000000e-01;
  a21=arg[7]? arg[7][0] : 0;
  a29=(a21*a21);
  a29=(a23*a29);
  a29=(a07+a29);
  a36=arg[7]? arg[7][1] : 0;
  a32=(a36*a36);
  a32=(a23*a32);
  a29=(a29+a32);
  a32=arg[7]? arg[7][2] : 0;
  a38=(a32*a32);
  a23=(a23*a38);
  a29=(a29+a23);
  a29=sqrt(a29);
  a07=(a07/a29);
  a29=(a15*a07);
  a02=(a02*a07);
  a21=(a02*a21);
  a23=(a10*a21);
  a29=(a29-a23);
  a36=(a02*a36);
  a23=(a12*a36);
  a29=(a29-a23);
  a02=(a02*a32);
  a32=(a17*a02);
  a29=(a29-a32);
  a32=(a33*a29);
  a23=(a15*a21);
  a38=(a10*a07);
  a23=(a23+a38);
  a38=(a17*a36);
  a23=(a23+a38);
  a38=(a12*a02);
  a23=(a23-a38);
  a38=(a27*a23);
  a32=(a32+a38);
  a38=(a15*a36);
  a30=(a10*a02);
  a38=(a38+a30);
  a30=(a12*a07);
  a38=(a38+a30);
  a30=(a17*a21);
  a38=(a38-a30);
  a30=(a35*a38);
  a32=(a32+a30);
  a15=(a15*a02);
  a12=(a12*a21);
  a15=(a15+a12);
  a17=(a17*a07);
  a15=(a15+a17);
  a10=(a10*a36);
  a15=(a15-a10);
  a10=(a31*a15);
  a32=(a32+a10);
  a10=(a06*a32);
  a05=sin(a05);
  a04=(a04*a05);
  a04=(a04/a03);
  a08=(a04*a08);
  a03=(a27*a29);
  a05=(a31*a38);
  a03=(a03+a05);
  a05=(a33*a23);
  a03=(a03-a05);
  a05=(a35*a15);
  a03=(a03-a05);
  a05=(a08*a03);
  a10=(a10+a05);
  a20=(a04*a20);
  a05=(a27*a15);
  a36=(a35*a29);
  a05=(a05+a36);
  a36=(a33*a38);
  a05=(a05-a36);
  a36=(a31*a23);
  a05=(a05-a36);
  a36=(a20*a05);
  a10=(a10+a36);
  a04=(a04*a37);
  a35=(a35*a23);
  a31=(a31*a29);
  a35=(a35+a31);
  a33=(a33*a15);
  a35=(a35-a33);
  a27=(a27*a38);
  a35=(a35-a27);
  a27=(a04*a35);
  a10=(a10+a27);
  a27=(a01*a10);
  a38=arg[5]? arg[5][1] : 0;
  a33=(a06*a03);
  a15=(a04*a05);
  a33=(a33+a15);
  a15=(a08*a32);
  a33=(a33-a15);
  a15=(a20*a35);
  a33=(a33-a15);
  a15=(a38*a33);
  a27=(a27+a15);
  a15=arg[5]? arg[5][2] : 0;
  a31=(a06*a05);
  a29=(a08*a35);
  a31=(a31+a29);
  a29=(a20*a32);
  a31=(a31-a29);
  a29=(a04*a03);
  a31=(a31-a29);
  a29=(a15*a31);
  a27=(a27+a29);
  a29=arg[5]? arg[5][3] : 0;
  a06=(a06*a35);
  a20=(a20*a03);
  a06=(a06+a20);
  a08=(a08*a05);
  a06=(a06-a08);
  a04=(a04*a32);
  a06=(a06-a04);
  a04=(a29*a06);
  a27=(a27+a04);
  a04=0.;
  a27=(a27<a04);
  a04=(!a27);
  a04=(a04-a27);
  a00=(a00*a04);
  a04=(a01*a33);
  a27=(a15*a06);
  a04=(a04+a27);
  a27=(a38*a10);
  a04=(a04-a27);
  a27=(a29*a31);
  a04=(a04-a27);
  a04=(a00*a04);
  if (res[0]!=0) res[0][0]=a04;
  a04=(a01*a31);
  a27=(a29*a33);
  a04=(a04+a27);
  a27=(a38*a06);
  a04=(a04-a27);
  a27=(a15*a10);
  a04=(a04-a27);
  a04=(a00*a04);
  if (res[0]!=0) res[0][1]=a04;
  a01=(a01*a06);
  a38=(a38*a31);
  a01=(a01+a38);
  a15=(a15*a33);
  a01=(a01-a15);
  a29=(a29*a10);
  a01=(a01-a29);
  a00=(a00*a01);
  if (res[0]!=0) res[0][2]=a00;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_quaternion_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_quaternion_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_quaternion_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_quaternion_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_quaternion_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_quaternion_z_casadi_n_in(void) { return 11;}

CASADI_SYMBOL_EXPORT casadi_int vas_quaternion_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_quaternion_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_quaternion_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "q_m2n_wxyz";
    case 6: return "lag";
    case 7: return "flexure";
    case 8: return "flexure_rate";
    case 9: return "gyro_scale";
    case 10: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_quaternion_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_quaternion_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s1;
    case 6: return casadi_s2;
    case 7: return casadi_s0;
    case 8: return casadi_s0;
    case 9: return casadi_s0;
    case 10: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_quaternion_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_quaternion_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 11;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_quaternion_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 11*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



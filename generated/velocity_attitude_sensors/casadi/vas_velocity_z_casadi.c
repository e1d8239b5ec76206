/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_velocity_z_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vas_velocity_z_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_velocity_z_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_velocity_z_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {1, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};

/* vas_velocity_z_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],lever_b[3],v_m_n[3],a_n[3],lag,flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_z[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=7.2921149999999999e-05;
  a03=arg[0]? arg[0][0] : 0;
  a04=sin(a03);
  a05=(a02*a04);
  a06=arg[1]? arg[1][1] : 0;
  a07=arg[0]? arg[0][2] : 0;
  a08=6378137.;
  a09=1.;
  a10=6.6943799901413173e-03;
  a11=casadi_sq(a04);
  a10=(a10*a11);
  a10=(a09-a10);
  a11=sqrt(a10);
  a08=(a08/a11);
  a08=(a07+a08);
  a08=(a06/a08);
  a03=cos(a03);
  a04=(a04/a03);
  a04=(a08*a04);
  a05=(a05+a04);
  a04=arg[2]? arg[2][0] : 0;
  a12=(2.*a04);
  a13=arg[2]? arg[2][3] : 0;
  a14=(a12*a13);
  a15=arg[2]? arg[2][1] : 0;
  a16=(2.*a15);
  a17=arg[2]? arg[2][2] : 0;
  a16=(a16*a17);
  a18=(a14+a16);
  a19=(a05*a18);
  a20=(a15*a13);
  a20=(2.*a20);
  a21=(a12*a17);
  a22=(a20-a21);
  a23=6.3354393272928204e+06;
  a10=(a10*a11);
  a23=(a23/a10);
  a07=(a07+a23);
  a07=(a00/a07);
  a23=(a22*a07);
  a19=(a19-a23);
  a19=(a01*a19);
  a00=(a00+a19);
  a19=arg[5]? arg[5][1] : 0;
  a23=casadi_sq(a17);
  a10=casadi_sq(a13);
  a11=(a23-a10);
  a04=casadi_sq(a04);
  a24=casadi_sq(a15);
  a25=(a04-a24);
  a11=(a11+a25);
  a26=(a05*a11);
  a12=(a12*a15);
  a17=(a17*a13);
  a17=(2.*a17);
  a13=(a12+a17);
  a15=(a13*a07);
  a26=(a26-a15);
  a26=(a19*a26);
  a00=(a00+a26);
  a26=arg[5]? arg[5][2] : 0;
  a17=(a17-a12);
  a12=(a05*a17);
  a25=(a10+a25);
  a25=(a25-a23);
  a15=(a25*a07);
  a12=(a12-a15);
  a12=(a26*a12);
  a00=(a00+a12);
  a12=arg[6]? arg[6][0] : 0;
  a00=(a00-a12);
  a12=arg[7]? arg[7][0] : 0;
  a15=arg[8]? arg[8][0] : 0;
  a12=(a12*a15);
  a00=(a00-a12);
  a16=(a16-a14);
  a14=arg[4]? arg[4][2] : 0;
  a12=arg[10]? arg[10][2] : 0;
  a12=(a09-a12);
  a12=(a14*a12);
  a27=arg[9]? arg[9][0] : 0;
  a28=arg[3]? arg[3][0] : 0;
  a29=(2.*a28);
  a30=arg[3]? arg[3][2] : 0;
  a31=(a29*a30);
  a32=arg[3]? arg[3][3] : 0;
  a33=(2.*a32);
  a34=arg[3]? arg[3][1] : 0;
  a33=(a33*a34);
  a35=(a31+a33);
  a35=(a27*a35);
  a12=(a12-a35);
  a35=arg[9]? arg[9][1] : 0;
  a36=(a30*a32);
  a36=(2.*a36);
  a37=(a29*a34);
  a38=(a36-a37);
  a38=(a35*a38);
  a12=(a12-a38);
  a38=arg[9]? arg[9][2] : 0;
  a39=casadi_sq(a32);
  a28=casadi_sq(a28);
  a40=casadi_sq(a34);
  a41=(a28-a40);
  a42=(a39+a41);
  a43=casadi_sq(a30);
  a42=(a42-a43);
  a42=(a38*a42);
  a12=(a12-a42);
  a42=arg[11]? arg[11][4] : 0;
  a44=arg[4]? arg[4][0] : 0;
  a42=(a42*a44);
  a12=(a12-a42);
  a42=arg[11]? arg[11][5] : 0;
  a45=arg[4]? arg[4][1] : 0;
  a42=(a42*a45);
  a12=(a12-a42);
  a42=(a16*a12);
  a21=(a21+a20);
  a20=arg[10]? arg[10][1] : 0;
  a20=(a09-a20);
  a20=(a45*a20);
  a34=(a34*a30);
  a34=(2.*a34);
  a29=(a29*a32);
  a32=(a34-a29);
  a32=(a27*a32);
  a20=(a20-a32);
  a32=(a43-a39);
  a32=(a32+a41);
  a32=(a35*a32);
  a20=(a20-a32);
  a37=(a37+a36);
  a37=(a38*a37);
  a20=(a20-a37);
  a37=arg[11]? arg[11][2] : 0;
  a37=(a37*a44);
  a20=(a20-a37);
  a37=arg[11]? arg[11][3] : 0;
  a37=(a37*a14);
  a20=(a20-a37);
  a37=(a21*a20);
  a42=(a42-a37);
  a42=(a01*a42);
  a00=(a00-a42);
  a42=arg[10]? arg[10][0] : 0;
  a09=(a09-a42);
  a44=(a44*a09);
  a28=(a28-a39);
  a28=(a28+a40);
  a28=(a28-a43);
  a27=(a27*a28);
  a44=(a44-a27);
  a29=(a29+a34);
  a35=(a35*a29);
  a44=(a44-a35);
  a33=(a33-a31);
  a38=(a38*a33);
  a44=(a44-a38);
  a38=arg[11]? arg[11][0] : 0;
  a38=(a38*a45);
  a44=(a44-a38);
  a38=arg[11]? arg[11][1] : 0;
  a38=(a38*a14);
  a44=(a44-a38);
  a38=(a21*a44);
  a04=(a04-a10);
  a04=(a04+a24);
  a04=(a04-a23);
  a23=(a12*a04);
  a38=(a38-a23);
  a38=(a19*a38);
  a00=(a00-a38);
  a38=(a20*a04);
  a23=(a16*a44);
  a38=(a38-a23);
  a38=(a26*a38);
  a00=(a00-a38);
  if (res[0]!=0) res[0][0]=a00;
  a02=(a02*a03);
  a08=(a08+a02);
  a02=(a22*a08);
  a03=(a04*a05);
  a02=(a02+a03);
  a02=(a01*a02);
  a06=(a06-a02);
  a02=(a13*a08);
  a03=(a16*a05);
  a02=(a02+a03);
  a02=(a19*a02);
  a06=(a06-a02);
  a02=(a25*a08);
  a05=(a21*a05);
  a02=(a02+a05);
  a02=(a26*a02);
  a06=(a06-a02);
  a02=arg[6]? arg[6][1] : 0;
  a06=(a06-a02);
  a02=arg[7]? arg[7][1] : 0;
  a02=(a02*a15);
  a06=(a06-a02);
  a02=(a11*a12);
  a05=(a17*a20);
  a02=(a02-a05);
  a02=(a01*a02);
  a06=(a06-a02);
  a02=(a17*a44);
  a05=(a12*a18);
  a02=(a02-a05);
  a02=(a19*a02);
  a06=(a06-a02);
  a02=(a20*a18);
  a05=(a11*a44);
  a02=(a02-a05);
  a02=(a26*a02);
  a06=(a06-a02);
  if (res[0]!=0) res[0][1]=a06;
  a06=arg[1]? arg[1][2] : 0;
  a04=(a04*a07);
  a18=(a08*a18);
  a04=(a04+a18);
  a04=(a01*a04);
  a06=(a06+a04);
  a11=(a11*a08);
  a16=(a16*a07);
  a11=(a11+a16);
  a11=(a19*a11);
  a06=(a06+a11);
  a17=(a17*a08);
  a21=(a21*a07);
  a17=(a17+a21);
  a17=(a26*a17);
  a06=(a06+a17);
  a17=arg[6]? arg[6][2] : 0;
  a06=(a06-a17);
  a17=arg[7]? arg[7][2] : 0;
  a17=(a17*a15);
  a06=(a06-a17);
  a17=(a13*a12);
  a15=(a25*a20);
  a17=(a17-a15);
  a01=(a01*a17);
  a06=(a06-a01);
  a25=(a25*a44);
  a12=(a22*a12);
  a25=(a25-a12);
  a19=(a19*a25);
  a06=(a06-a19);
  a22=(a22*a20);
  a13=(a13*a44);
  a22=(a22-a13);
  a26=(a26*a22);
  a06=(a06-a26);
  if (res[0]!=0) res[0][2]=a06;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_velocity_z_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_velocity_z_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_velocity_z_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_velocity_z_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_velocity_z_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_velocity_z_casadi_n_in(void) { return 12;}

CASADI_SYMBOL_EXPORT casadi_int vas_velocity_z_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_velocity_z_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_velocity_z_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "lever_b";
    case 6: return "v_m_n";
    case 7: return "a_n";
    case 8: return "lag";
    case 9: return "flexure_rate";
    case 10: return "gyro_scale";
    case 11: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_velocity_z_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_z";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_velocity_z_casadi_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s0;
    case 2: return casadi_s1;
    case 3: return casadi_s1;
    case 4: return casadi_s0;
    case 5: return casadi_s0;
    case 6: return casadi_s0;
    case 7: return casadi_s0;
    case 8: return casadi_s2;
    case 9: return casadi_s0;
    case 10: return casadi_s0;
    case 11: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_velocity_z_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_velocity_z_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_velocity_z_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 12*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}



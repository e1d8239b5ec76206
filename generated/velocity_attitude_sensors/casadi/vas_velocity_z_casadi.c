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
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48;
  a00=arg[1]? arg[1][0] : 0;
  a01=arg[5]? arg[5][0] : 0;
  a02=arg[2]? arg[2][1] : 0;
  a03=(2.*a02);
  a04=arg[2]? arg[2][3] : 0;
  a05=(a03*a04);
  a06=arg[2]? arg[2][0] : 0;
  a07=(2.*a06);
  a08=arg[2]? arg[2][2] : 0;
  a09=(a07*a08);
  a10=(a05-a09);
  a11=(a01*a10);
  a12=arg[5]? arg[5][1] : 0;
  a13=(a07*a02);
  a14=(2.*a08);
  a14=(a14*a04);
  a15=(a13+a14);
  a16=(a12*a15);
  a11=(a11+a16);
  a16=arg[5]? arg[5][2] : 0;
  a17=casadi_sq(a04);
  a06=casadi_sq(a06);
  a18=casadi_sq(a08);
  a19=(a06-a18);
  a20=(a17+a19);
  a02=casadi_sq(a02);
  a20=(a20-a02);
  a21=(a16*a20);
  a11=(a11+a21);
  a21=arg[0]? arg[0][2] : 0;
  a22=6.3354393272928204e+06;
  a23=1.;
  a24=6.6943799901413173e-03;
  a25=arg[0]? arg[0][0] : 0;
  a26=sin(a25);
  a27=casadi_sq(a26);
  a24=(a24*a27);
  a24=(a23-a24);
  a27=sqrt(a24);
  a24=(a24*a27);
  a22=(a22/a24);
  a22=(a21+a22);
  a22=(a00/a22);
  a24=(a11*a22);
  a00=(a00-a24);
  a24=arg[4]? arg[4][2] : 0;
  a28=arg[10]? arg[10][2] : 0;
  a28=(a23-a28);
  a28=(a24*a28);
  a29=arg[9]? arg[9][0] : 0;
  a30=arg[3]? arg[3][0] : 0;
  a31=(2.*a30);
  a32=arg[3]? arg[3][2] : 0;
  a33=(a31*a32);
  a34=arg[3]? arg[3][3] : 0;
  a35=(2.*a34);
  a36=arg[3]? arg[3][1] : 0;
  a35=(a35*a36);
  a37=(a33+a35);
  a37=(a29*a37);
  a28=(a28-a37);
  a37=arg[9]? arg[9][1] : 0;
  a38=(2.*a32);
  a38=(a38*a34);
  a39=(a31*a36);
  a40=(a38-a39);
  a40=(a37*a40);
  a28=(a28-a40);
  a40=arg[9]? arg[9][2] : 0;
  a41=casadi_sq(a34);
  a42=casadi_sq(a32);
  a43=(a41-a42);
  a30=casadi_sq(a30);
  a44=casadi_sq(a36);
  a45=(a30-a44);
  a46=(a43+a45);
  a46=(a40*a46);
  a28=(a28-a46);
  a46=arg[11]? arg[11][4] : 0;
  a47=arg[4]? arg[4][0] : 0;
  a46=(a46*a47);
  a28=(a28-a46);
  a46=arg[11]? arg[11][5] : 0;
  a48=arg[4]? arg[4][1] : 0;
  a46=(a46*a48);
  a28=(a28-a46);
  a03=(a03*a08);
  a07=(a07*a04);
  a04=(a03-a07);
  a08=(a28*a04);
  a46=arg[10]? arg[10][1] : 0;
  a46=(a23-a46);
  a46=(a48*a46);
  a36=(2.*a36);
  a36=(a36*a32);
  a31=(a31*a34);
  a34=(a36-a31);
  a34=(a29*a34);
  a46=(a46-a34);
  a45=(a45-a43);
  a45=(a37*a45);
  a46=(a46-a45);
  a39=(a39+a38);
  a39=(a40*a39);
  a46=(a46-a39);
  a39=arg[11]? arg[11][2] : 0;
  a39=(a39*a47);
  a46=(a46-a39);
  a39=arg[11]? arg[11][3] : 0;
  a39=(a39*a24);
  a46=(a46-a39);
  a09=(a09+a05);
  a05=(a46*a09);
  a08=(a08-a05);
  a08=(a01*a08);
  a05=arg[10]? arg[10][0] : 0;
  a23=(a23-a05);
  a47=(a47*a23);
  a41=(a41+a42);
  a30=(a30-a41);
  a30=(a30+a44);
  a29=(a29*a30);
  a47=(a47-a29);
  a31=(a31+a36);
  a37=(a37*a31);
  a47=(a47-a37);
  a35=(a35-a33);
  a40=(a40*a35);
  a47=(a47-a40);
  a40=arg[11]? arg[11][0] : 0;
  a40=(a40*a48);
  a47=(a47-a40);
  a40=arg[11]? arg[11][1] : 0;
  a40=(a40*a24);
  a47=(a47-a40);
  a40=(a47*a09);
  a24=(a02-a17);
  a24=(a24+a19);
  a19=(a28*a24);
  a40=(a40-a19);
  a40=(a12*a40);
  a08=(a08+a40);
  a40=(a46*a24);
  a19=(a47*a04);
  a40=(a40-a19);
  a40=(a16*a40);
  a08=(a08+a40);
  a00=(a00-a08);
  a07=(a07+a03);
  a03=(a01*a07);
  a06=(a06-a17);
  a06=(a06+a18);
  a06=(a06-a02);
  a02=(a12*a06);
  a03=(a03+a02);
  a14=(a14-a13);
  a13=(a16*a14);
  a03=(a03+a13);
  a13=arg[1]? arg[1][1] : 0;
  a02=6378137.;
  a02=(a02/a27);
  a21=(a21+a02);
  a21=(a13/a21);
  a25=cos(a25);
  a02=(a26/a25);
  a02=(a21*a02);
  a27=7.2921149999999999e-05;
  a26=(a27*a26);
  a02=(a02+a26);
  a26=(a03*a02);
  a00=(a00+a26);
  a26=arg[6]? arg[6][0] : 0;
  a00=(a00-a26);
  a26=arg[7]? arg[7][0] : 0;
  a18=arg[8]? arg[8][0] : 0;
  a26=(a26*a18);
  a00=(a00-a26);
  if (res[0]!=0) res[0][0]=a00;
  a24=(a01*a24);
  a04=(a12*a04);
  a24=(a24+a04);
  a09=(a16*a09);
  a24=(a24+a09);
  a02=(a24*a02);
  a13=(a13-a02);
  a02=(a28*a06);
  a09=(a46*a14);
  a02=(a02-a09);
  a02=(a01*a02);
  a14=(a47*a14);
  a09=(a28*a07);
  a14=(a14-a09);
  a14=(a12*a14);
  a02=(a02+a14);
  a07=(a46*a07);
  a06=(a47*a06);
  a07=(a07-a06);
  a07=(a16*a07);
  a02=(a02+a07);
  a13=(a13-a02);
  a27=(a27*a25);
  a21=(a21+a27);
  a11=(a11*a21);
  a13=(a13-a11);
  a11=arg[6]? arg[6][1] : 0;
  a13=(a13-a11);
  a11=arg[7]? arg[7][1] : 0;
  a11=(a11*a18);
  a13=(a13-a11);
  if (res[0]!=0) res[0][1]=a13;
  a13=arg[1]? arg[1][2] : 0;
  a03=(a03*a21);
  a13=(a13+a03);
  a03=(a28*a15);
  a21=(a46*a20);
  a03=(a03-a21);
  a01=(a01*a03);
  a20=(a47*a20);
  a28=(a28*a10);
  a20=(a20-a28);
  a12=(a12*a20);
  a01=(a01+a12);
  a46=(a46*a10);
  a47=(a47*a15);
  a46=(a46-a47);
  a16=(a16*a46);
  a01=(a01+a16);
  a13=(a13-a01);
  a24=(a24*a22);
  a13=(a13+a24);
  a24=arg[6]? arg[6][2] : 0;
  a13=(a13-a24);
  a24=arg[7]? arg[7][2] : 0;
  a24=(a24*a18);
  a13=(a13-a24);
  if (res[0]!=0) res[0][2]=a13;
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



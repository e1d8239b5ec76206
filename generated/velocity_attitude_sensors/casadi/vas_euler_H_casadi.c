/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) vas_euler_H_casadi__ ## ID
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
CASADI_SYMBOL_EXPORT void vas_euler_H_casadi__casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int vas_euler_H_casadi__casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int vas_euler_H_casadi__casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {3, 1, 1};
static const casadi_int casadi_s1[3] = {4, 1, 1};
static const casadi_int casadi_s2[3] = {6, 1, 1};
static const casadi_int casadi_s3[3] = {24, 1, 1};

/* vas_euler_H_casadi:(lat_lon_height[3],v_n[3],q_b2n_wxyz[4],q_b2m_wxyz[4],omega_ib_b[3],euler_m[3],flexure_rate[3],gyro_scale[3],gyro_axes[6])->(out_H[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51;
  a00=arg[5]? arg[5][1] : 0;
  a01=cos(a00);
  a02=arg[5]? arg[5][2] : 0;
  a03=cos(a02);
  a04=(a01*a03);
  a05=arg[5]? arg[5][0] : 0;
  a06=cos(a05);
  a07=1.;
  a08=(a07/a01);
  a09=(a06*a08);
  a05=sin(a05);
  a02=sin(a02);
  a10=(a05*a02);
  a00=sin(a00);
  a11=(a03*a06);
  a12=(a00*a11);
  a12=(a10+a12);
  a13=(a09*a12);
  a14=(a13*a00);
  a04=(a04+a14);
  a14=(a03*a05);
  a15=(a14*a00);
  a16=(a02*a06);
  a15=(a15-a16);
  a08=(a05*a08);
  a17=(a15*a08);
  a18=(a17*a00);
  a04=(a04+a18);
  a18=(-a04);
  if (res[0]!=0) res[0][0]=a18;
  a01=(a01*a02);
  a10=(a00*a10);
  a11=(a11+a10);
  a10=(a08*a11);
  a18=(a10*a00);
  a01=(a01+a18);
  a16=(a16*a00);
  a16=(a16-a14);
  a14=(a09*a16);
  a00=(a14*a00);
  a01=(a01+a00);
  a00=(-a01);
  if (res[0]!=0) res[0][1]=a00;
  if (res[0]!=0) res[0][2]=a07;
  a15=(a15*a04);
  a11=(a11*a01);
  a15=(a15+a11);
  if (res[0]!=0) res[0][3]=a15;
  a12=(a04*a12);
  a16=(a16*a01);
  a12=(a12+a16);
  if (res[0]!=0) res[0][4]=a12;
  a16=7.2921149999999999e-05;
  a11=arg[0]? arg[0][0] : 0;
  a00=cos(a11);
  a18=(a16*a00);
  a19=arg[1]? arg[1][1] : 0;
  a20=arg[0]? arg[0][2] : 0;
  a21=6378137.;
  a22=6.6943799901413173e-03;
  a11=sin(a11);
  a23=(a11*a11);
  a22=(a22*a23);
  a22=(a07-a22);
  a23=sqrt(a22);
  a21=(a21/a23);
  a21=(a20+a21);
  a19=(a19/a21);
  a18=(a18+a19);
  a21=arg[4]? arg[4][1] : 0;
  a24=arg[7]? arg[7][1] : 0;
  a24=(a07-a24);
  a24=(a21*a24);
  a25=arg[6]? arg[6][0] : 0;
  a26=2.;
  a27=arg[3]? arg[3][1] : 0;
  a28=arg[3]? arg[3][2] : 0;
  a29=(a27*a28);
  a29=(a26*a29);
  a30=arg[3]? arg[3][0] : 0;
  a31=(a26*a30);
  a32=arg[3]? arg[3][3] : 0;
  a33=(a31*a32);
  a34=(a29-a33);
  a34=(a25*a34);
  a24=(a24-a34);
  a34=arg[6]? arg[6][1] : 0;
  a35=(a28*a28);
  a36=(a27*a27);
  a37=(a35-a36);
  a30=(a30*a30);
  a38=(a32*a32);
  a39=(a30-a38);
  a37=(a37+a39);
  a37=(a34*a37);
  a24=(a24-a37);
  a37=arg[6]? arg[6][2] : 0;
  a40=(a31*a27);
  a41=(a28*a32);
  a41=(a26*a41);
  a42=(a40+a41);
  a42=(a37*a42);
  a24=(a24-a42);
  a42=arg[8]? arg[8][2] : 0;
  a43=arg[4]? arg[4][0] : 0;
  a42=(a42*a43);
  a24=(a24-a42);
  a42=arg[8]? arg[8][3] : 0;
  a44=arg[4]? arg[4][2] : 0;
  a42=(a42*a44);
  a24=(a24-a42);
  a42=arg[2]? arg[2][1] : 0;
  a45=arg[2]? arg[2][2] : 0;
  a46=(a42*a45);
  a46=(a26*a46);
  a47=arg[2]? arg[2][0] : 0;
  a48=(a26*a47);
  a49=arg[2]? arg[2][3] : 0;
  a50=(a48*a49);
  a51=(a46-a50);
  a51=(a24*a51);
  a18=(a18-a51);
  a51=arg[7]? arg[7][0] : 0;
  a51=(a07-a51);
  a51=(a43*a51);
  a39=(a36+a39);
  a39=(a39-a35);
  a39=(a25*a39);
  a51=(a51-a39);
  a33=(a33+a29);
  a33=(a34*a33);
  a51=(a51-a33);
  a27=(a27*a32);
  a27=(a26*a27);
  a31=(a31*a28);
  a28=(a27-a31);
  a28=(a37*a28);
  a51=(a51-a28);
  a28=arg[8]? arg[8][0] : 0;
  a28=(a28*a21);
  a51=(a51-a28);
  a28=arg[8]? arg[8][1] : 0;
  a28=(a28*a44);
  a51=(a51-a28);
  a28=(a42*a42);
  a47=(a47*a47);
  a32=(a45*a45);
  a33=(a47-a32);
  a29=(a28+a33);
  a39=(a49*a49);
  a29=(a29-a39);
  a29=(a51*a29);
  a18=(a18-a29);
  a29=arg[7]? arg[7][2] : 0;
  a07=(a07-a29);
  a44=(a44*a07);
  a31=(a31+a27);
  a25=(a25*a31);
  a44=(a44-a25);
  a41=(a41-a40);
  a34=(a34*a41);
  a44=(a44-a34);
  a30=(a30-a36);
  a30=(a30+a38);
  a30=(a30-a35);
  a37=(a37*a30);
  a44=(a44-a37);
  a37=arg[8]? arg[8][4] : 0;
  a37=(a37*a43);
  a44=(a44-a37);
  a37=arg[8]? arg[8][5] : 0;
  a37=(a37*a21);
  a44=(a44-a37);
  a37=(a48*a45);
  a21=(a26*a49);
  a21=(a21*a42);
  a43=(a37+a21);
  a43=(a44*a43);
  a18=(a18-a43);
  a04=(a04*a18);
  a47=(a47-a28);
  a47=(a47+a32);
  a47=(a47-a39);
  a47=(a24*a47);
  a50=(a50+a46);
  a50=(a51*a50);
  a47=(a47+a50);
  a45=(a45*a49);
  a26=(a26*a45);
  a48=(a48*a42);
  a42=(a26-a48);
  a42=(a44*a42);
  a47=(a47+a42);
  a42=arg[1]? arg[1][0] : 0;
  a45=6.3354393272928204e+06;
  a22=(a22*a23);
  a45=(a45/a22);
  a20=(a20+a45);
  a42=(a42/a20);
  a47=(a47+a42);
  a01=(a01*a47);
  a04=(a04-a01);
  if (res[0]!=0) res[0][5]=a04;
  a04=-1.;
  if (res[0]!=0) res[0][6]=a04;
  a15=(-a15);
  if (res[0]!=0) res[0][7]=a15;
  a12=(-a12);
  if (res[0]!=0) res[0][8]=a12;
  if (res[0]!=0) res[0][9]=a02;
  a12=(-a03);
  if (res[0]!=0) res[0][10]=a12;
  if (res[0]!=0) res[0][11]=a06;
  a12=(-a05);
  if (res[0]!=0) res[0][12]=a12;
  a02=(a18*a02);
  a03=(a47*a03);
  a02=(a02+a03);
  a02=(-a02);
  if (res[0]!=0) res[0][13]=a02;
  a06=(-a06);
  if (res[0]!=0) res[0][14]=a06;
  if (res[0]!=0) res[0][15]=a05;
  a13=(a13+a17);
  a17=(-a13);
  if (res[0]!=0) res[0][16]=a17;
  a10=(a10+a14);
  a14=(-a10);
  if (res[0]!=0) res[0][17]=a14;
  if (res[0]!=0) res[0][18]=a04;
  if (res[0]!=0) res[0][19]=a08;
  if (res[0]!=0) res[0][20]=a09;
  a18=(a18*a13);
  a16=(a16*a11);
  a48=(a48+a26);
  a24=(a24*a48);
  a16=(a16+a24);
  a21=(a21-a37);
  a51=(a51*a21);
  a16=(a16+a51);
  a39=(a39-a28);
  a39=(a39+a33);
  a44=(a44*a39);
  a16=(a16+a44);
  a11=(a11/a00);
  a19=(a19*a11);
  a16=(a16+a19);
  a47=(a47*a10);
  a16=(a16+a47);
  a18=(a18-a16);
  if (res[0]!=0) res[0][21]=a18;
  a08=(-a08);
  if (res[0]!=0) res[0][22]=a08;
  a09=(-a09);
  if (res[0]!=0) res[0][23]=a09;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void vas_euler_H_casadi_release(int mem) {
}

CASADI_SYMBOL_EXPORT void vas_euler_H_casadi_incref(void) {
}

CASADI_SYMBOL_EXPORT void vas_euler_H_casadi_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int vas_euler_H_casadi_n_in(void) { return 9;}

CASADI_SYMBOL_EXPORT casadi_int vas_euler_H_casadi_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real vas_euler_H_casadi_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_euler_H_casadi_name_in(casadi_int i) {
  switch (i) {
    case 0: return "lat_lon_height";
    case 1: return "v_n";
    case 2: return "q_b2n_wxyz";
    case 3: return "q_b2m_wxyz";
    case 4: return "omega_ib_b";
    case 5: return "euler_m";
    case 6: return "flexure_rate";
    case 7: return "gyro_scale";
    case 8: return "gyro_axes";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* vas_euler_H_casadi_name_out(casadi_int i) {
  switch (i) {
    case 0: return "out_H";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_euler_H_casadi_sparsity_in(casadi_int i) {
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
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* vas_euler_H_casadi_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int vas_euler_H_casadi_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 9*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 1*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


